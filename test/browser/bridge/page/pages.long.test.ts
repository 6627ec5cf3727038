import { expect } from 'chai';
import { addScript, named, open, openText, worldIn, type PageWindow } from '../../page.js';
import { until, wait } from '../../scene.js';

/** The world of the file that a page's Inline brings. */
async function worldOfInline(page: PageWindow, inline: Element) {
  const content = (): Element | undefined =>
    (inline as unknown as { _x3domNode?: { _childNodes: { _xmlNode: Element }[] } })._x3domNode
      ?._childNodes[0]?._xmlNode;
  await until(() => content() !== undefined);
  return page.X3DPhysics!.worldOf(content()!.querySelector('RigidBody')!)!.ready;
}

/** All numbers of the ball after 200 steps, and how high its collidable is drawn. */
async function fall(page: PageWindow): Promise<string> {
  const inline = page.document.querySelector('inline[url="ball.x3d"]');
  const world = await (inline ? worldOfInline(page, inline) : worldIn(page));
  world.paused = true;
  world.reset();
  world.step(200);
  const ball = world.node('ball')!;
  const shape = world.node('shape')!.host as Element;
  await until(() => Math.abs(drawn(shape) - 0.5) < 0.05);
  const fields = ['position', 'orientation', 'linearVelocity', 'angularVelocity'];
  return JSON.stringify(fields.map((field) => ball.get(field)));
}

function drawn(element: Element): number {
  const node = (element as unknown as { _x3domNode: { getCurrentTransform(): { _13: number } } })
    ._x3domNode;
  return node.getCurrentTransform()._13;
}

const heardIn = (page: Window): string[] => (page as unknown as { heard: string[] }).heard;
const height = (world: Awaited<ReturnType<typeof worldIn>>, name: string): number =>
  (world.node(name)!.get('position') as number[])[1]!;

describe('pages', () => {
  it('one scene has the same bits in HTML, XHTML and an Inline file, in both spellings', async () => {
    const falls: Record<string, string> = {};
    const pages = ['classic.html', 'plain.html', 'classic.xhtml', 'plain.xhtml', 'foreign.xhtml'];
    for (const path of [...pages, 'inline.html']) falls[path] = await fall(await open(path));
    expect(falls['inline.html']).to.contain('.');
    for (const [path, bits] of Object.entries(falls))
      expect(bits, path).to.equal(falls['classic.html']);
  });

  it('foreign.xhtml: says once that hyphenated tags are no custom elements there', async () => {
    const page = await open('foreign.xhtml');
    const world = await worldIn(page);
    expect(world.problems.map(({ code }) => code)).to.eql(['not-upgraded']);
  });

  it('without-x3dom.html: the simulation runs unseen', async () => {
    const world = await worldIn(await open('without-x3dom.html'));
    world.paused = true;
    world.reset();
    world.advance(1);
    expect(height(world, 'ball')).to.be.closeTo(3 - 4.9, 0.05);
  });

  for (const search of ['', '?404']) {
    it(`engine-missing.html${search}: the page hears of it once, with the address, ready rejects, x3dom draws`, async () => {
      const page = await open(`engine-missing.html${search}`);
      const ball = named(page, 'ball');
      const world = page.X3DPhysics!.worldOf(ball)!;
      const problem = await world.ready.then(
        () => undefined,
        (reason: unknown) => reason as { code: string; value: string },
      );
      expect(problem!.code).to.equal('engine-load-failed');
      expect(problem!.value).to.contain(search ? '404' : 'no network');
      expect(problem!.value).to.contain(`${location.origin}/dist/ammo.wasm`);
      ball.setAttribute('mass', '3');
      await wait(100);
      expect(heardIn(page)).to.eql(['engine-load-failed']);
      expect(world.problems.map(({ code }) => code)).to.eql(['engine-load-failed']);
      expect(drawn(named(page, 'drawn'))).to.equal(3);
    });
  }

  /** Two scenes that wait for an engine that can't be had, and how often it was asked for. */
  async function withoutEngine() {
    const page = (await open('engine-later.html')) as PageWindow & {
      heard: string[];
      fetched: number;
      there: boolean;
    };
    const worlds = ['ball', 'free'].map((name) => page.X3DPhysics!.worldOf(named(page, name))!);
    const codes = worlds.map((world) => world.ready.catch(({ code }: { code: string }) => code));
    expect(await Promise.all(codes)).to.eql(['engine-load-failed', 'engine-load-failed']);
    expect(page.heard.sort()).to.eql(['engine-load-failed second', 'engine-load-failed waits']);
    // One scene may have come after the other one had failed.
    expect(page.fetched).to.be.oneOf([1, 2]);
    page.heard.length = page.fetched = 0;
    return { page, worlds, scene: page.document.querySelector('scene')! };
  }

  const anotherWorld = '<x3d-rigid-body-collection id="new"></x3d-rigid-body-collection>';

  for (const [by, act] of [
    [
      'another world comes',
      (scene: Element) => scene.insertAdjacentHTML('beforeend', anotherWorld),
    ],
    [
      'the browser is online again',
      ({ ownerDocument }: Element) => ownerDocument.defaultView!.dispatchEvent(new Event('online')),
    ],
  ] as const)
    it(`engine-later.html: is asked for again when ${by}, and all that wait start`, async () => {
      const { page, worlds, scene } = await withoutEngine();
      page.there = true;
      act(scene);
      await until(() => worlds.every(({ started }) => started));
      for (const world of worlds) expect(await world.ready).to.equal(world);
      expect(worlds.map(({ problems }) => problems)).to.eql([[], []]);
      expect(page.fetched).to.equal(1);
      expect(page.heard).to.include.members(['physicsready waits', 'physicsready second']);
      for (const world of worlds) {
        world.paused = true;
        world.reset();
        world.advance(1);
      }
      expect(height(worlds[0]!, 'ball')).to.be.closeTo(-4.9, 0.05);
      expect(height(worlds[1]!, 'free')).to.be.closeTo(-4.9, 0.05);
    });

  it('engine-later.html: is asked for once by each new world, by no new body, and told of once', async () => {
    const { page, worlds, scene } = await withoutEngine();
    for (let i = 0; i < 5; i++) {
      scene.insertAdjacentHTML('beforeend', '<x3d-rigid-body></x3d-rigid-body>');
      scene
        .querySelector('#waits')!
        .insertAdjacentHTML('beforeend', '<x3d-rigid-body></x3d-rigid-body>');
      await wait(20);
    }
    await until(() => page.fetched > 0);
    await wait(100);
    // The first of them were in the default world of their <x3d>, which they made.
    expect(page.fetched).to.equal(1);
    scene.insertAdjacentHTML('beforeend', anotherWorld);
    await until(() => page.fetched > 1);
    await wait(100);
    expect(page.fetched).to.equal(2);
    const again = page.X3DPhysics!.worldOf(scene.querySelector('#new')!)!;
    expect(await again.ready.catch(({ code }: { code: string }) => code)).to.equal(
      'engine-load-failed',
    );
    expect(await worlds[0]!.ready.catch(({ code }: { code: string }) => code)).to.equal(
      'engine-load-failed',
    );
    expect(page.heard).to.eql(['engine-load-failed first', 'engine-load-failed new']);
  });

  it('late-x3dom.html: what x3dom reads when it comes, with load or long after, is drawn where it is', async () => {
    const page = await open('late-x3dom.html');
    const world = await worldIn(page);
    world.paused = true;
    world.reset();
    world.advance(0.5);
    await wait(100);
    await addScript(page, '/node_modules/x3dom/x3dom.js');
    const [ball, plain] = ['ball', 'plain'].map((name) => height(world, name));
    expect(ball).to.be.closeTo(3 - 4.9 * 0.25, 0.05);
    const isDrawn = (name: string, y: number): boolean =>
      '_x3domNode' in named(page, name) && Math.abs(drawn(named(page, name)) - y) < 1e-4;
    await until(() => isDrawn('drawn', ball!) && isDrawn('shape', plain!));
    await until(() => isDrawn('ring', height(world, 'torus')));
    world.step(0);
    // Only x3dom has the mesh of a Torus.
    expect(world.problems.map(({ code }) => code)).to.eql(['concave-dynamic']);
    const inline = await worldOfInline(page, page.document.querySelector('inline')!);
    expect(inline.stats.bodies).to.equal(2);
    named(page, 'drawn').setAttribute('translation', '0 7 0');
    world.step(0);
    expect(height(world, 'ball')).to.equal(7);
  });

  it('late-library.html: what x3dom dropped is set up when we come', async () => {
    const page = await open('late-library.html');
    await wait(300);
    await addScript(page, '/dist/x3d-physics.classic.js');
    const world = await worldIn(page);
    world.paused = true;
    world.advance(1);
    const y = height(world, 'ball');
    expect(y).to.be.below(0);
    await until(() => Math.abs(drawn(named(page, 'shape')) - y) < 1e-4);
    expect(drawn(named(page, 'follower'))).to.be.closeTo(y, 1e-4);
    expect(drawn(named(page, 'othershape'))).to.be.closeTo(y, 1e-4);
  });

  it('two-scripts.html: the second copy says so, leaves the page to the first, and answers through it', async () => {
    const page = (await open('two-scripts.html')) as PageWindow & { problems: string[] };
    const world = await worldIn(page);
    const other = await page.X3DPhysics!.worldOf(named(page, 'other'))!.ready;
    await until(() => page.problems.length === 2);
    expect(heardIn(page).sort()).to.eql(['custom', 'plain']);
    expect(page.problems).to.eql(['console two-copies', 'two-copies HTML']);
    expect([...world.problems, ...other.problems]).to.eql([]);
    const module = (await (page as unknown as { eval(text: string): unknown }).eval(
      "import('/dist/x3d-physics.js')",
    )) as { worldOf(element: Element): unknown; explain(element: Element): object };
    const classic = page.X3DPhysics as unknown as typeof module;
    for (const each of [world, other]) {
      each.paused = true;
      each.reset();
      each.advance(1);
    }
    for (const name of ['ball', 'other']) {
      const element = named(page, name);
      expect(module.worldOf(element)).to.equal(classic.worldOf(element));
      expect(module.explain(element)).to.deep.include({ running: true, problems: [] });
      expect(module.explain(element)).to.deep.equal(classic.explain(element));
    }
    const touching = module.explain(named(page, 'lies')) as { touches: string[] };
    expect(touching.touches).to.eql(['x3d-rigid-body[DEF="ground"]']);
    expect(height(world, 'ball')).to.be.closeTo(3 - 4.9, 0.05);
    await until(() => Math.abs(drawn(named(page, 'shape')) - height(other, 'other')) < 1e-4);
    expect(height(other, 'other')).to.equal(height(world, 'ball'));
  });

  const early = (script: string): string => `<!DOCTYPE html>
    <script src="/node_modules/x3dom/x3dom.js"></script>
    <x3d width="300px" height="200px"><scene>
      <transform id="t"><shape><box></box></shape><x3d-rigid-body id="b" useglobalgravity="false"></x3d-rigid-body></transform>
    </scene></x3d>
    <script>${script}</script>
    <script src="/dist/x3d-physics.classic.js"></script>`;
  const listened = `var heard = 0;
    document.addEventListener('afterstep', function () { heard++; });`;

  it('a listener that was there before the library hears, whoever added it', async () => {
    const page = (await openText(early(listened))) as PageWindow & { heard: number };
    const world = await worldIn(page);
    world.paused = true;
    const before = page.heard;
    world.step(3);
    expect(page.heard).to.equal(before + 3);
  });

  it('a page whose scripts say nothing of our events, or come from elsewhere, pays for none', async () => {
    const elsewhere = '</script><script src="/test/pages/analytics.js"></script><script>';
    const page = await openText(early(`var nothing = 0;${elsewhere}var more = 0;`));
    expect(page).to.have.property('analytics', true);
    const world = await worldIn(page);
    expect(['beforestep', 'afterstep'].map((name) => world.heard(name))).to.eql([false, false]);
    expect(world.effects.filter(({ name, active }) => active && /contact/.test(name))).to.eql([]);
  });
});
