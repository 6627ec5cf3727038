import { expect } from 'chai';
import { until, wait } from './scene.js';

type World = ReturnType<typeof import('../../../elements/index.js').worldOf> & object;
interface Physics {
  worldOf(element: Element): World;
}
type PageWindow = Window & { X3DPhysics?: Physics; eval(text: string): unknown };

async function open(path: string): Promise<PageWindow> {
  const frame = document.createElement('iframe');
  frame.width = '400';
  frame.height = '300';
  frame.src = `/test/pages/${path}`;
  document.body.replaceChildren(frame);
  await new Promise((resolve) => frame.addEventListener('load', resolve, { once: true }));
  return frame.contentWindow as PageWindow;
}

const named = (page: Window, name: string): Element =>
  [...page.document.querySelectorAll('*')].find(
    (element) => Element.prototype.getAttribute.call(element, 'DEF') === name,
  )!;

async function fall(page: PageWindow, physics: Physics): Promise<string> {
  const world = physics.worldOf(named(page, 'ball'));
  await world.ready;
  world.paused = true;
  world.reset();
  world.step(200);
  const body = world.node('ball')!;
  return JSON.stringify([body.get('position'), body.get('orientation')]);
}

function drawn(element: Element): number {
  const node = (element as unknown as { _x3domNode: { getCurrentTransform(): { _13: number } } })
    ._x3domNode;
  return node.getCurrentTransform()._13;
}

describe('pages', () => {
  const falls: string[] = [];
  for (const path of ['classic.html', 'classic.xhtml', 'plain.xhtml', 'foreign.xhtml']) {
    it(`${path}: the ball falls, and is drawn where it lies`, async () => {
      const page = await open(path);
      falls.push(await fall(page, page.X3DPhysics!));
      await until(() => Math.abs(drawn(named(page, 'shape')) - 0.5) < 0.05);
    });
  }

  it('the same scene has the same bits in each', () => {
    expect(new Set(falls).size).to.equal(1);
  });

  it('foreign.xhtml: says once that hyphenated tags are no custom elements there', async () => {
    const page = await open('foreign.xhtml');
    const world = page.X3DPhysics!.worldOf(named(page, 'ball'));
    await world.ready;
    expect(world.problems.map(({ code }) => code)).to.eql(['not-upgraded']);
  });

  it('without-x3dom.html: the simulation runs unseen', async () => {
    const page = await open('without-x3dom.html');
    const world = page.X3DPhysics!.worldOf(named(page, 'ball'));
    await world.ready;
    world.paused = true;
    world.reset();
    world.advance(1);
    expect((world.node('ball')!.get('position') as number[])[1]).to.be.closeTo(3 - 4.9, 0.05);
  });

  it('engine-missing.html: ready rejects with the problem, and the page hears it', async () => {
    const page = await open('engine-missing.html');
    const world = page.X3DPhysics!.worldOf(named(page, 'ball'));
    const problem = (await world.ready.then(
      () => undefined,
      (reason: unknown) => reason,
    )) as { code: string };
    expect(problem.code).to.equal('engine-load-failed');
    expect((page as unknown as { heard: string[] }).heard).to.eql(['engine-load-failed']);
  });

  it('late-library.html: what x3dom dropped is set up when we come', async () => {
    const page = await open('late-library.html');
    await wait(300);
    const script = page.document.createElement('script');
    script.src = '/dist/x3d-physics.classic.js';
    page.document.head.append(script);
    await new Promise((resolve) => script.addEventListener('load', resolve));
    const world = page.X3DPhysics!.worldOf(named(page, 'ball'));
    await world.ready;
    world.paused = true;
    world.advance(1);
    const y = (world.node('ball')!.get('position') as number[])[1];
    expect(y).to.be.below(0);
    await until(() => Math.abs(drawn(named(page, 'shape')) - y) < 1e-4);
    expect(drawn(named(page, 'follower'))).to.be.closeTo(y, 1e-4);
    expect(drawn(named(page, 'othershape'))).to.be.closeTo(y, 1e-4);
  });
});
