import { expect } from 'chai';
import './console.js';
import { openText, type PageWindow } from './page.js';
import { nextFrame, until } from './scene.js';
import { allTypes } from '../../physics-core/all-types.js';
import type { World } from './inside.js';

const FALLING = `<transform translation="0 5 0">
    <shape><box></box></shape><x3d-rigid-body id="b"></x3d-rigid-body>
  </transform>`;
const FLOOR = `<transform>
    <shape><box size="20 1 20"></box></shape><x3d-rigid-body id="floor" fixed="true"></x3d-rigid-body>
  </transform>`;
const JOINT = '<x3d-ball-joint body1="b" anchorpoint="0 8 0"></x3d-ball-joint>';
const EGG = `<transform scale="1 2 1">
    <shape><sphere></sphere></shape><x3d-rigid-body></x3d-rigid-body>
  </transform>`;
const COLLECTION = '<x3d-collision-collection collidables="*"></x3d-collision-collection>';

type Shown = Element & { world: World };

/** A page with the module build, and its body's world, started. */
async function show(scene: string) {
  const page = await openText(`<!DOCTYPE html>
    <script src="/node_modules/x3dom/x3dom.js"></script>
    <script type="module" src="/dist/x3d-physics.js"></script>
    <x3d width="200px" height="100px"><scene>${scene}</scene></x3d>`);
  const body = page.document.getElementById('b') as unknown as Shown;
  await until(() => body.world !== undefined);
  const world = await body.world.ready;
  return { page, world, scene: page.document.querySelector('scene')! };
}

/** Files of ours that a page has fetched, engine included. */
const fetched = ({ performance }: PageWindow): string[] =>
  performance
    .getEntriesByType('resource')
    .map(({ name }) => new URL(name).pathname)
    .filter((path) => path.startsWith('/dist/'));

const ENGINE = /ammo/;

/** Bytes of what a page has fetched, as a server would send them; beside the engine, if not said otherwise. */
async function zipped(paths: string[], besides = ENGINE): Promise<number> {
  const ours = paths.filter((path) => !besides.test(path));
  const sizes = ours.map(async (path) => {
    const { body } = await fetch(path);
    const stream = body!.pipeThrough(new CompressionStream('gzip'));
    return (await new Response(stream).arrayBuffer()).byteLength;
  });
  return (await Promise.all(sizes)).reduce((sum, size) => sum + size, 0);
}

/** Bytes of all that a page has fetched, the engine included, as a server sends them: by gzip, and by Brotli. */
async function loaded(page: PageWindow): Promise<{ gzip: number; brotli: number }> {
  const paths = fetched(page);
  const packed = paths.map(async (path) => {
    const { byteLength } = await (await fetch(path)).arrayBuffer();
    // What is short has none.
    if (byteLength < 1000) return byteLength;
    return (await (await fetch(`${path}.br`)).arrayBuffer()).byteLength;
  });
  const brotli = (await Promise.all(packed)).reduce((sum, size) => sum + size, 0);
  return { gzip: await zipped(paths, /^$/), brotli };
}

const has = (page: PageWindow, chunk: RegExp): boolean =>
  fetched(page).some((path) => chunk.test(path));

const JOINTS = /joint-code/;
const CONTACTS = /contact-code/;
const MESHES = /mesh-code/;
const DRAGS = /drag-code/;
const COSTS = /cost-code/;
const BATCHES = /batch-code/;
const WATERS = /water-(code|elements)/;
const ROPES = /rope-(code|elements)|draw-rope|own-shapes/;
const DEFORMABLES = /deformable-(code|elements)|draw-deformable|own-shapes/;
const CHUNKS = [JOINTS, CONTACTS, MESHES, DRAGS, COSTS];

/** WebKitGTK and Safari. */
const isWebKit = !/Chrome|Firefox/.test(navigator.userAgent);

describe('what a page fetches', () => {
  it('of ours, for a box that falls: few files and bytes before it moves', async () => {
    const { page, world } = await show(FALLING);
    await until(() => world.time > 0);
    // Nothing of hands, debug drawing, measurement or the ui, either.
    const names = fetched(page).map((path) => path.replace(/^\/dist\/|-[\w-]{8}(?=\.js$)/g, ''));
    expect(names.sort()).to.eql([
      'ammo.wasm',
      'chunk-ammo.wasm.js',
      'chunk-core.js',
      'chunk-page.js',
      'x3d-physics.js',
    ]);
    // 85 kB (0.9 more by WebKit's gzip), of which 53 are the core; 4 of these are sines and their like, the same in every
    // browser, 3 the tables of nodes that are not there, whose elements have their properties all the same, and 9 what
    // page code may call at any time and has to answer at once: rays, snapshots, drags, explain.
    expect(await zipped(fetched(page))).to.be.below(isWebKit ? 86_000 : 85_000);
    expect(CHUNKS.filter((chunk) => has(page, chunk))).to.eql([]);
  });

  // With everything but x3dom 313 kB by gzip and 258 by Brotli: the engine 168 and 130 (glue included), contacts and what they
  // reckon with 60 and 53, the core 53 and 46, the page 31 and 28.
  it('of all files, for a box on a floor: bytes', async () => {
    const { page, world } = await show(FALLING + FLOOR);
    await until(() => world.time > 0);
    const { gzip, brotli } = await loaded(page);
    // WebKit's gzip makes one per cent more of it than a server's, and than the other browsers'.
    expect(gzip).to.be.within(250_000, isWebKit ? 320_200 : 317_000);
    expect(brotli).to.be.within(200_000, 260_000);
  });

  // 104 kB, 60 of them contacts.
  it('for joints, meshes, drags and contacts together: less than 200 kB more than for one box', async () => {
    const dragged = FALLING.replace('id="b"', 'id="b" draggable-body');
    const bytes = async (scene: string) => {
      const { page, world } = await show(scene);
      await until(() => world.time > 0);
      return loaded(page);
    };
    const alone = await bytes(FALLING);
    const all = await bytes(dragged + FLOOR + EGG + JOINT);
    expect(all.gzip - alone.gzip).to.be.within(80_000, 115_000);
    expect(all.brotli - alone.brotli).to.be.within(70_000, 105_000);
  });

  it('no text that only the docs of fields read', async () => {
    const { page } = await show(FALLING);
    const files = await Promise.all(fetched(page).map(async (path) => (await fetch(path)).text()));
    const docs = Object.values(allTypes).flatMap(({ doc, fields }) => [
      doc,
      ...Object.values(fields).map((field) => field.doc),
    ]);
    // Enough of each to know it by.
    const begins = docs.map((text) => text.slice(0, 16));
    expect(begins.filter((text) => files.some((file) => file.includes(text)))).to.eql([]);
  });

  for (const [who, ask, acts] of [
    [
      'who asks for them',
      (world) => world.recordCosts('a fact'),
      (world) => (world.costs?.frames ?? 0) > 0,
    ],
    ['profile', (world) => (world.profile = true), () => true],
    [
      'accuracy auto',
      (world) => world.set('accuracy', 'auto'),
      (world) => world.accuracy !== 'standard',
    ],
  ] as [string, (world: World) => unknown, (world: World) => boolean][])
    it(`what looks at the costs of frames, with ${who}`, async () => {
      const { page, world } = await show(FALLING);
      await until(() => world.time > 0);
      expect(has(page, COSTS)).to.equal(false);
      ask(world);
      await until(() => has(page, COSTS) && acts(world));
    });

  it('the code of drags with a body that may be dragged', async () => {
    const { page, world } = await show(FALLING.replace('id="b"', 'id="b" draggable-body'));
    await until(() => world.time > 0);
    expect(CHUNKS.filter((chunk) => has(page, chunk))).to.eql([DRAGS]);
  });

  it('the code of contacts with a body that is fixed: what is moved along pushes', async () => {
    const { page } = await show(FLOOR.replace('id="floor"', 'id="b"'));
    expect(CHUNKS.filter((chunk) => has(page, chunk))).to.eql([CONTACTS]);
  });

  it('the code of contacts with a second body, before the first step', async () => {
    const { page, world } = await show(FALLING + FLOOR);
    await until(() => world.time > 0);
    expect(fetched(page).length, fetched(page).join(' ')).to.be.at.most(7);
    expect([has(page, CONTACTS), has(page, JOINTS)]).to.eql([true, false]);
  });

  it('the same with a CollisionCollection', async () => {
    const { page } = await show(FALLING + COLLECTION);
    expect(has(page, CONTACTS)).to.equal(true);
  });

  it('the code of meshes with a geometry that Bullet has no shape for', async () => {
    const { page } = await show(EGG.replace('<x3d-rigid-body', '<x3d-rigid-body id="b"'));
    expect(CHUNKS.filter((chunk) => has(page, chunk))).to.eql([MESHES]);
  });

  it('all that the markup calls for at the same time as the engine', async () => {
    const faces =
      '<indexedtriangleset index="0 1 2"><coordinate point="0 0 0 1 0 0 0 1 0"></coordinate></indexedtriangleset>';
    const table = `<transform><shape>${faces}</shape><x3d-rigid-body fixed="true"></x3d-rigid-body></transform>`;
    const { page } = await show(FALLING + table + JOINT);
    const [wasm] = page.performance.getEntriesByName(
      new URL('/dist/ammo.wasm', location.href).href,
    );
    const begun = (part: RegExp): number =>
      page.performance.getEntriesByType('resource').find(({ name }) => part.test(name))!.startTime;
    const end = (wasm as PerformanceResourceTiming).responseEnd;
    for (const part of [CONTACTS, JOINTS, MESHES, /ammo\.wasm-.*\.js/])
      expect(begun(part), String(part)).to.be.below(end);
  });

  for (const [count, fetches] of [
    [7, false],
    [8, true],
  ] as const)
    it(`${fetches ? 'the' : 'not the'} code of batched drawing with ${count} bodies of one geometry`, async () => {
      const more = FALLING.replace(' id="b"', '').replace('0 5 0', '0 50 0');
      const { page, world } = await show(FALLING + more.repeat(count - 1));
      world.paused = true;
      if (fetches) await until(() => has(page, BATCHES));
      else for (let i = 0; i < 10; i++) await nextFrame();
      expect(has(page, BATCHES)).to.equal(fetches);
    });

  it('what water is made of with a WaterVolume alone, at the same time as the engine', async () => {
    const dry = await show(FALLING);
    await until(() => dry.world.time > 0);
    expect(has(dry.page, WATERS)).to.equal(false);
    for (const tag of ['x3d-water-volume', 'WaterVolume']) {
      const { page, world } = await show(`${FALLING}<${tag} id="w"></${tag}>`);
      await until(() => world.time > 0);
      const files = fetched(page).filter((path) => WATERS.test(path));
      // The tag, and what floats.
      expect(files.length, files.join(' ')).to.equal(2);
      expect(world.effects.find(({ name }) => name === 'water')!.active).to.equal(true);
      expect(fetched(page).filter((path) => /particle/.test(path))).to.eql([]);
      expect(world.problems).to.eql([]);
    }
  });

  it('what water does to all that gives way only where there is such, whichever comes first', async () => {
    const water = '<x3d-water-volume></x3d-water-volume>';
    const rope = '<x3d-rope points="0 0 0 1 0 0"></x3d-rope>';
    for (const [content, swims] of [
      [water, false],
      [rope, false],
      [water + rope, true],
      [rope + water, true],
    ] as const) {
      const { page, world } = await show(FALLING + content);
      await until(() => world.time > 0);
      expect(has(page, /swim-code/), content).to.equal(swims);
      expect(world.problems).to.eql([]);
    }
  });

  it('what ropes are made of with a Rope alone, and what draws them with its Shape', async () => {
    const dry = await show(FALLING);
    await until(() => dry.world.time > 0);
    expect(has(dry.page, ROPES)).to.equal(false);
    const line = '<lineset><coordinate point="0 0 0 1 0 0"></coordinate></lineset>';
    for (const tag of ['x3d-rope', 'Rope'])
      for (const [content, files] of [
        [line, /rope-code|rope-elements|own-shapes/],
        [`<shape>${line}</shape>`, ROPES],
      ] as const) {
        const { page, world } = await show(`${FALLING}<${tag}>${content}</${tag}>`);
        await until(() => world.time > 0);
        const count = files === ROPES ? 4 : 3;
        await until(() => fetched(page).filter((path) => files.test(path)).length === count);
        expect(fetched(page).filter((path) => ROPES.test(path)).length).to.equal(count);
        expect(world.effects.find(({ name }) => name === 'ropes')!.active).to.equal(true);
        expect(fetched(page).filter((path) => /particle|water/.test(path))).to.eql([]);
        expect(world.problems).to.eql([]);
      }
  });

  it('what cloth is made of with a Cloth alone, and what draws it with its Shape', async () => {
    const dry = await show(FALLING);
    await until(() => dry.world.time > 0);
    expect(has(dry.page, DEFORMABLES)).to.equal(false);
    for (const tag of ['x3d-cloth', 'Cloth'])
      for (const [content, files] of [
        ['', /deformable-(code|elements)|own-shapes/],
        ['<shape><appearance></appearance></shape>', DEFORMABLES],
      ] as const) {
        const { page, world } = await show(`${FALLING}<${tag} size="1 1">${content}</${tag}>`);
        await until(() => world.time > 0);
        const count = files === DEFORMABLES ? 4 : 3;
        await until(() => fetched(page).filter((path) => files.test(path)).length === count);
        expect(fetched(page).filter((path) => DEFORMABLES.test(path)).length).to.equal(count);
        expect(world.effects.find(({ name }) => name === 'deformables')!.active).to.equal(true);
        expect(fetched(page).filter((path) => /particle-|water|rope/.test(path))).to.eql([]);
        expect(world.problems).to.eql([]);
      }
  });

  for (const [first, scene, also] of [
    ['ropes', '<x3d-rope points="0 0 0 1 0 0"></x3d-rope>', /deformable/],
    ['cloth', '<x3d-cloth size="1 1"></x3d-cloth>', /rope-elements/],
  ] as const)
    it(`what ties a cloth that comes later, where what reads ${first} was there first`, async () => {
      const { page, world, scene: x3dScene } = await show(FALLING + scene);
      await until(() => world.time > 0);
      expect(has(page, also)).to.equal(false);
      // Each before what it names, and in that.
      x3dScene.insertAdjacentHTML(
        'beforeend',
        `<x3d-soft-body-attachment id="by-name" softBody="k" index="2" position="0.5 -0.5 0"></x3d-soft-body-attachment>
         <Cloth id="k" size="1 1" subdivision="2 2"><SoftBodyAttachment id="within" index="8" position="0.5 0.5 0"></SoftBodyAttachment></Cloth>`,
      );
      const tied = (name: string): unknown => world.node(name)?.get('softBody');
      await until(() => world.node('k') !== undefined && has(page, also));
      await until(() => ['by-name', 'within'].every((name) => tied(name) === world.node('k')));
      const problems = (): string[] => world.problems.map(({ code }) => code);
      await until(() => !problems().includes('unknown-reference'));
      expect(problems().filter((code) => code !== 'waiting-for-effect')).to.eql([]);
    });

  it('the code of joints with a joint, before the first step', async () => {
    const { page } = await show(FALLING + JOINT);
    expect([has(page, JOINTS), has(page, CONTACTS)]).to.eql([true, false]);
  });
});

describe('world.effects', () => {
  const DEBUG =
    '<x3d-rigid-body-collection default="true" debug="true"></x3d-rigid-body-collection>';
  const MONITOR = '<x3d-physics-monitor></x3d-physics-monitor>';
  const into = (text: string) => (scene: Element) => scene.insertAdjacentHTML('beforeend', text);
  for (const [name, add, file] of [
    ['joint solve', into(JOINT), /joint-code|arithmetic/],
    ['contact solve', into(FLOOR), /contact-code|arithmetic/],
    ['mesh shapes', into(EGG), MESHES],
    [
      'dragging',
      (scene) => scene.querySelector('#b')!.setAttribute('draggable-body', ''),
      /drag-code|arithmetic/,
    ],
    ['debug drawing', into(DEBUG), /debug-code|contact-code|arithmetic/],
    [
      'monitor',
      (scene) => scene.closest('body')!.insertAdjacentHTML('beforeend', MONITOR),
      /ui\/(monitor|chunk-styles)|cost-code/,
    ],
  ] as [string, (scene: Element) => void, RegExp][])
    it(`has no bytes of a chunk before its cause is there: ${name}`, async () => {
      const { page, world, scene } = await show(FALLING);
      const effect = () => world.effects.find((each) => each.name === name)!;
      const bytes = (): number => effect().bytes;
      expect(bytes()).to.equal(0);
      add(scene);
      // The monitor has a file of its own, and looks when both are here.
      await until(() => bytes() > 0 && (name !== 'monitor' || effect().active));
      // Another zip, without the line that tells the number.
      const weight = await zipped(fetched(page).filter((path) => file.test(path)));
      expect(bytes()).to.be.closeTo(weight, 0.02 * weight);
    });

  it('counts the file of monitors once, however many there are', async () => {
    const { page, world } = await show(FALLING);
    const effect = () => world.effects.find(({ name }) => name === 'monitor')!;
    const { body } = page.document;
    body.insertAdjacentHTML('beforeend', MONITOR);
    await until(() => effect().active);
    const { bytes } = effect();
    body.insertAdjacentHTML('beforeend', MONITOR);
    const shown = [...body.querySelectorAll('x3d-physics-monitor')];
    await until(() =>
      shown.every(({ shadowRoot }) => shadowRoot && !/^Loading/.test(shadowRoot.textContent!)),
    );
    expect(effect().bytes).to.equal(bytes);
  });
});

describe('a node that comes late, with the first of its code', () => {
  for (const [what, added, code] of [
    ['joint', JOINT, JOINTS],
    ['second body', FLOOR, CONTACTS],
    ['mesh', EGG, MESHES],
  ] as const) {
    it(`has the world wait for that: ${what}`, async () => {
      const { page, world, scene } = await show(FALLING);
      world.paused = true;
      const parts = (): number => world.stats.bodies + world.stats.joints;
      expect(parts()).to.equal(1);
      scene.insertAdjacentHTML('beforeend', added);
      expect(world.step(3)).to.equal(0);
      expect(world.problems.map(({ code: name }) => name)).to.eql(['waiting-for-effect']);
      await until(() => has(page, code));
      await until(() => world.step(1) > 0);
      expect(parts()).to.equal(2);
      expect(world.problems).to.eql([]);
    });
  }

  it('has the world wait for that: a drag that a script begins', async () => {
    const { page, world } = await show(FALLING);
    world.paused = true;
    const body = page.document.getElementById('b') as unknown as {
      drag(point: number[]): { move(point: number[]): void; end(): void };
      position: number[];
    };
    const [, height] = body.position;
    const drag = body.drag(body.position);
    drag.move([0, height! + 5, 0]);
    expect(world.step(3)).to.equal(0);
    await until(() => has(page, DRAGS));
    await until(() => world.step(1) > 0);
    world.advance(1);
    // Without a hand it would fall by 5 m.
    expect(body.position[1]).to.be.closeTo(height! + 5, 0.5);
    drag.end();
    expect(world.problems).to.eql([]);
  });

  it('tells those who listened before of what it touches', async () => {
    const { page, world, scene } = await show(FALLING);
    const heard: string[] = [];
    page.document
      .getElementById('b')!
      .addEventListener('collisionstart', ({ target }) => heard.push((target as Element).id));
    await until(() => world.time > 0);
    expect(has(page, CONTACTS)).to.equal(false);
    world.paused = true;
    scene.insertAdjacentHTML('beforeend', FLOOR);
    await until(() => world.step(1) > 0);
    world.advance(2);
    expect(heard).to.eql(['b']);
  });

  it('makes what was there before cause effects of that code, too', async () => {
    const log =
      '<transform><shape><cylinder></cylinder></shape><x3d-rigid-body id="b"></x3d-rigid-body></transform>';
    const { world, scene } = await show(log);
    const shapes = () => world.effects.find(({ name }) => name === 'contact shapes')!;
    expect(shapes().active).to.equal(false);
    scene.insertAdjacentHTML('beforeend', FLOOR);
    await until(() => shapes().active);
    expect((shapes().because!.element as Element).id).to.equal('b');
  });
});
