import { expect } from 'chai';
import './console.js';
import { open, openText, worldIn, type PageWindow } from './page.js';
import { drawnAt, until, wait } from './scene.js';
import type { Run, World } from './inside.js';

// Worlds in a worker, in pages of the build: the worker's script is the classic one beside it.

const boxes = Array.from(
  { length: 12 },
  (_, i) =>
    `<x3d-rigid-body id="b${i}" mass="1" position="${i % 3} ${2 + 1.2 * i} 0">
      <x3d-collidable-shape><shape><box size="1 1 1"></box></shape></x3d-collidable-shape>
    </x3d-rigid-body>`,
).join('');

const scene = (attributes: string, more = ''): string => `<!doctype html>
  <script src="/node_modules/x3dom/x3dom.js"></script>
  <script type="module" src="/dist/x3d-physics.js"></script>
  <x3d width="300px" height="200px"><scene>
    <x3d-rigid-body-collection id="collection" ${attributes}>
      <x3d-rigid-body id="floor" fixed="true"><x3d-collidable-shape><shape><box size="20 1 20"></box></shape></x3d-collidable-shape></x3d-rigid-body>
      ${boxes}
      <x3d-rigid-body id="ball" for="drawn" draggable-body="true"></x3d-rigid-body>
      ${more}
    </x3d-rigid-body-collection>
    <transform id="drawn" translation="8 9 6"><shape><sphere></sphere></shape></transform>
  </scene></x3d>`;

/** A hundred boxes at rest on the floor. */
const many = Array.from(
  { length: 100 },
  (_, i) =>
    `<x3d-rigid-body position="${(i % 10) * 1.5 - 8} 0.99 ${Math.floor(i / 10) * 1.5 - 8}"><x3d-collidable-shape><shape><box size=".8 1 .8"></box></shape></x3d-collidable-shape></x3d-rigid-body>`,
).join('');

/** They fly among the boxes. */
const SPARKS = `<x3d-particle-system id="sparks" collides="true" pushes="true" bounce=".5" particlesize=".1 .1">
    <x3d-cone-emitter position="0 9 0" direction="0 -1 0" angle=".5" speed="6" mass=".01"></x3d-cone-emitter>
  </x3d-particle-system>`;

interface ParticleElement extends Element {
  count: number;
  isActive: boolean;
  positions: number[][];
}

/** The corners of what stands in x3dom's scene and in no document. */
function cloudOf(page: PageWindow): ArrayLike<number> & { some: Float32Array['some'] } {
  const { runtime } = page.document.querySelector('x3d') as any;
  const cloud = runtime.canvas.doc._scene._childNodes.find(
    (node: any) => node._cf.geometry && node._xmlNode === null,
  );
  return cloud?._cf.geometry.node._mesh._positions[0] ?? new Float32Array(0);
}

/** Of the pages: nobody else hears them. */
const errors: string[] = [];

async function shown(text: string): Promise<{ page: PageWindow; world: World }> {
  const page = await openText(text);
  page.addEventListener('error', ({ message }) => errors.push(message));
  const body = page.document.querySelector('x3d-rigid-body') as unknown as { world?: World };
  await until(() => body.world !== undefined);
  return { page, world: await body.world!.ready };
}

const bits = (world: World): string =>
  JSON.stringify([...world.bodies].map((body) => [body.id, body.pose()]).sort());

const codes = (world: World): string[] => world.problems.map(({ code }) => code);

async function begun(world: World): Promise<void> {
  world.paused = true;
  world.reset();
  await world.ask('stats');
}

/** Edits of boxes, each of which the next one of its kind undoes. */
function turns(document: Document): (i: number) => void {
  const kinds: ((i: number) => [name: string, value: string])[] = [
    (i) => ['linearvelocity', `${Math.sin(i)} ${Math.cos(i)} 0`],
    (i) => ['position', `${i % 3} ${2 + (i % 11)} ${Math.sin(i)}`],
    (i) => ['mass', String(1 + (i % 7))],
    (i) => ['fixed', String(i % 5 === 0)],
    (i) => ['angularvelocity', `0 ${i % 13} 0`],
  ];
  return (i) => {
    const [name, value] = kinds[i % kinds.length]!(i);
    document.getElementById(`b${i % 12}`)!.setAttribute(name, value);
  };
}

describe('a world in a worker', () => {
  afterEach(() => expect(errors.splice(0)).to.deep.equal([]));

  it('goes the way it goes on the page’s own thread, to the bit, edits included', async () => {
    const ways: string[] = [];
    const steps: unknown[] = [];
    for (const attributes of ['', 'thread="worker"']) {
      const { page, world } = await shown(scene(attributes));
      await begun(world);
      await world.ask('step', 60);
      const ball = page.document.getElementById('ball')!;
      ball.setAttribute('linearvelocity', '-6 0 0');
      page.document.getElementById('b3')!.remove();
      ball.insertAdjacentHTML(
        'afterend',
        '<x3d-rigid-body position="1 20 0"><x3d-collidable-shape><shape><sphere></sphere></shape></x3d-collidable-shape></x3d-rigid-body>',
      );
      await wait(50);
      await world.ask('step', 120);
      ways.push(bits(world));
      steps.push(world.mirrored);
      expect(world.problems.map(({ message }) => message)).to.deep.equal([]);
    }
    expect(steps).to.deep.equal([undefined, 180]);
    expect(ways[1]).to.equal(ways[0]);
  });

  it('hears a thousand edits in a second of the scene, each in its turn', async () => {
    const ways: string[] = [];
    for (const attributes of ['', 'thread="worker"']) {
      const { page, world } = await shown(scene(attributes));
      await begun(world);
      const edits = turns(page.document);
      for (let step = 0; step < 60; step++) {
        for (let i = 0; i < 17; i++) edits(17 * step + i);
        await wait(0);
        await world.ask('step', 1);
      }
      ways.push(bits(world));
      expect(codes(world)).to.deep.equal([]);
    }
    expect(ways[1]).to.equal(ways[0]);
  });

  it('runs by the page’s frames and draws what comes back', async () => {
    const { page, world } = await shown(scene('thread="worker"'));
    const drawn = page.document.getElementById('drawn')!;
    await until(() => drawnAt(drawn)[1]! < 3);
    expect(world.time).to.be.above(0.5);
    expect(world.stats.bodies).to.equal(14);
    expect(world.stats.contacts).to.be.above(0);
  });

  it('has the particles of the page’s own thread, to the bit, and draws them', async () => {
    const ways: unknown[] = [];
    for (const attributes of ['', 'thread="worker"']) {
      const { page, world } = await shown(scene(attributes, SPARKS));
      const system = page.document.getElementById('sparks') as unknown as ParticleElement;
      await until(() => world.node(system) !== undefined);
      await begun(world);
      await world.ask('step', 120);
      await until(() => system.count > 0);
      ways.push([system.count, system.isActive, system.positions]);
      await until(() => cloudOf(page).some((value) => Math.abs(value) < 100));
      expect(world.problems.map(({ message }) => message)).to.deep.equal([]);
    }
    expect(ways[1]).to.deep.equal(ways[0]);
  });

  it('fires collisions, each begun and ended, and sleep, at the elements', async () => {
    const { page, world } = await shown(scene('thread="worker"'));
    await begun(world);
    const ball = page.document.getElementById('ball')!;
    const heard: string[] = [];
    for (const type of ['collisionstart', 'collisionend', 'sleep'])
      ball.addEventListener(type, (event) => {
        const { other } = (event as CustomEvent<{ other?: Element }>).detail;
        heard.push(`${type} ${other?.id ?? ''}`.trim());
      });
    await world.ask('step', 1200);
    expect(heard).to.deep.equal(['collisionstart floor', 'sleep']);
    expect(ball.matches(':state(sleeping)')).to.equal(true);
  });

  it('is recorded there: what it was is drawn, gone on from, and exported with its markup', async () => {
    const { page, world } = await shown(scene('thread="worker"'));
    await begun(world);
    const timeline = await world.record();
    await world.ask('step', 120);
    const ball = page.document.getElementById('ball')!;
    ball.setAttribute('linearvelocity', '-6 0 0');
    await wait(50);
    await world.ask('step', 120);
    const drawn = page.document.getElementById('drawn')!;
    timeline.seek(0.5);
    await until(() => Math.abs(drawnAt(drawn)[1]! - (9 - (9.8 * 0.5 ** 2) / 2)) < 0.03);
    expect(timeline.at).to.be.closeTo(0.5, 1e-6);
    timeline.play();
    await until(() => !timeline.playing);
    expect(timeline.at).to.be.closeTo(2, 1e-6);
    const run = JSON.parse(JSON.stringify(await world.ask('exportRun'))) as Run;
    expect(run.markup).to.match(/^<scene.*id="ball"/is);
    expect(run.steps).to.equal(240);
    timeline.seek(1);
    world.resume();
    await world.ask('stats');
    expect(world.time).to.be.closeTo(1, 1e-6);
    expect(world.mirrored).to.be.a('number');
    expect(codes(world)).to.deep.equal([]);
  });

  it('is recorded on where it is taken to a worker', async () => {
    const { page, world } = await shown(scene(''));
    await begun(world);
    await world.record({ seconds: 5 });
    page.document.getElementById('collection')!.setAttribute('thread', 'worker');
    await wait(50);
    world.reset();
    await world.ask('step', 60);
    await until(() => world.timeline?.to === 0.5);
    expect(world.mirrored).to.be.a('number');
    expect(codes(world)).to.deep.equal([]);
  });

  it('answers what is asked with elements', async () => {
    const { page, world } = await shown(scene('thread="worker"'));
    await begun(world);
    const hit = (await world.ask('raycast', [8, 20, 6], [8, -20, 6])) as { element: Element };
    expect(hit.element.id).to.equal('ball');
    await world.ask('step', 240);
    const known = (await world.ask('explain', page.document.getElementById('ball'))) as {
      touches: string[];
      bullet: { state: string };
    };
    expect(known.touches).to.deep.equal(['x3d-rigid-body[id="floor"]']);
    expect(known.bullet.state).to.match(/awake|asleep/);
  });

  it('comes back for who listens before each step, and goes on', async () => {
    const { page, world } = await shown(scene('thread="worker"'));
    await begun(world);
    await world.ask('step', 60);
    const before = bits(world);
    let steps = 0;
    page.document.getElementById('collection')!.addEventListener('beforestep', () => void steps++);
    await until(() => world.mirrored === undefined);
    expect(codes(world)).to.deep.equal(['thread-main']);
    expect(bits(world)).to.equal(before);
    world.step(5);
    expect(steps).to.equal(5);
    expect(world.events.silent).to.equal(false);
  });

  it('stays where a ROUTE takes what a sensor sends to physics', async () => {
    const sensor = `<x3d-collision-sensor def="sensor">
        <x3d-collision-collection containerfield="collider" collidables="*"></x3d-collision-collection>
      </x3d-collision-sensor>`;
    const route =
      '<route fromnode="sensor" fromfield="isActive" tonode="b0" tofield="enabled"></route>';
    const text = scene('thread="worker"', sensor).replace('id="b0"', 'def="b0"');
    const { world } = await shown(text.replace('</scene>', `${route}</scene>`));
    await until(() => codes(world).includes('thread-main'));
    await until(() => world.mirrored === undefined);
    await until(() => world.time > 0.1);
    expect(codes(world)).to.deep.equal(['thread-main']);
  });

  it('another thread is taken at the next reset', async () => {
    const { page, world } = await shown(scene(''));
    world.paused = true;
    page.document.getElementById('collection')!.setAttribute('thread', 'worker');
    // The code of it is fetched meanwhile.
    await until(() => world.step() > 0);
    expect(world.mirrored).to.equal(undefined);
    world.reset();
    await until(() => world.mirrored !== undefined);
    await world.ask('step', 30);
    const there = bits(world);
    page.document.getElementById('collection')!.removeAttribute('thread');
    world.reset();
    expect(world.mirrored).to.equal(undefined);
    world.step(30);
    expect(bits(world)).to.equal(there);
  });

  it('beside the classic script, too', async () => {
    const world = await worldIn(await open('classic.html'));
    world.set('thread', 'worker');
    world.reset();
    await until(() => world.mirrored !== undefined);
    world.paused = true;
    await world.ask('step', 10);
    expect(world.mirrored).to.be.above(9);
  });

  it('runs there by itself from a hundred bodies on, and asks for no frame where all rests', async () => {
    const { world } = await shown(scene('thread="auto"', many));
    await world.ask('step', 1);
    expect(world.mirrored).to.be.a('number');
    await until(() => world.stats.awake === 0);
    await until(() => !world.stepping.needsFrame);
    const at = world.mirrored;
    await wait(300);
    expect(world.stepping.needsFrame).to.equal(false);
    expect(world.mirrored).to.equal(at);
  });

  it('has a worker by auto while there is a core beside the page’s, and by worker always', async () => {
    const cores =
      '<script>Object.defineProperty(navigator, "hardwareConcurrency", { value: 2 })</script>';
    const collection = (attributes: string, bodies: string): string =>
      `<x3d-rigid-body-collection gravity="0 0 0" ${attributes}>${bodies}</x3d-rigid-body-collection>`;
    const collections = [
      collection('id="first" thread="auto"', many),
      collection('id="second" thread="auto"', many),
      collection('id="third"', '<x3d-rigid-body></x3d-rigid-body>'),
    ];
    const text = scene('')
      .replace('<x3d ', `${cores}<x3d `)
      .replace('</scene>', `${collections.join('')}</scene>`);
    const { page } = await shown(text);
    const worlds = await Promise.all(
      ['first', 'second', 'third'].map((id) => {
        const { world } = page.document.getElementById(id) as unknown as { world: World };
        return world.ready;
      }),
    );
    const [first, second, third] = worlds as [World, World, World];
    const isThere = (world: World): boolean => world.mirrored !== undefined;
    const [there, here] = isThere(first) ? [first, second] : [second, first];
    const begin = (world: World, thread: string): void => {
      world.set('thread', thread);
      world.reset();
    };
    expect([there, here].map(isThere)).to.deep.equal([true, false]);
    begin(third, 'worker');
    expect(isThere(third)).to.equal(true);
    begin(there, 'main');
    begin(here, 'auto');
    expect([there, here].map(isThere)).to.deep.equal([false, false]);
    begin(third, 'main');
    begin(here, 'auto');
    expect(isThere(here)).to.equal(true);
    await here.ask('step', 10);
    expect(worlds.flatMap(codes)).not.to.include('thread-main');
  });
});
