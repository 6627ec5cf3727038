import { expect } from 'chai';
import type { World } from '../../inside.js';
import { addScript, named, openText, worldIn, type PageWindow } from '../../page.js';
import { until } from '../../scene.js';

/** What the engine of the stand-in counts. */
type Page = PageWindow & { ownEngine?: { begun: number; frames: number }; loaded?: number };

const X3DOM = '<script src="/node_modules/x3dom/x3dom.js"></script>';
const STAND_IN = '<script src="/test/pages/other-physics.js"></script>';
/** Made by `node tools/test/x3dom-full.js`, where x3dom's source can be had. */
const FULL = '/x3dom-full/x3dom-physics.js';

const OURS: Record<string, string> = {
  classic: '<script src="/dist/x3d-physics.classic.js"></script>',
  single: '<script src="/dist/x3d-physics.single.js"></script>',
  module:
    '<script type="module">import * as all from "/dist/x3d-physics.js"; window.X3DPhysics = all;</script>',
};

const HEARD = `<script>
  var heard = [];
  var note = function (text) { heard.push(text); };
  document.addEventListener('physicsproblem', function (event) { note(event.detail.code); });
  window.addEventListener('error', function (event) { note(event.message); });
  ['warn', 'error'].forEach(function (level) { console[level] = note; });
</script>`;

const BOX = `<transform def="moves" translation="0 6 0" rotation="1 0 1 0.5">
    <shape><box size="1 1 1"></box></shape><x3d-rigid-body def="ball" mass="2"></x3d-rigid-body>
  </transform>`;

const PLAIN = `<transform def="moves" translation="0 6 0"><shape def="shape"><box size="1 1 1"></box></shape></transform>
  <CollidableShape def="collidable" translation="0 6 0">
    <transform use="moves"></transform><shape use="shape"></shape>
  </CollidableShape>
  <RigidBodyCollection>
    <RigidBody def="ball" mass="2" containerfield="bodies">
      <CollidableShape use="collidable" containerfield="geometry"></CollidableShape>
    </RigidBody>
  </RigidBodyCollection>`;

const INLINE = '<inline url="/test/pages/ball.x3d"></inline>';

const scene = (content: string): string =>
  `<x3d width="300px" height="200px"><scene>${content}</scene></x3d>`;

const openPage = (scripts: string, ...scenes: string[]): Promise<Page> =>
  openText(`<!DOCTYPE html>${HEARD}${scripts}${scenes.map(scene).join('')}`) as Promise<Page>;

const heardIn = (page: Page): string[] => (page as unknown as { heard: string[] }).heard;

/** All numbers of the ball after a second. */
async function fall(page: Page): Promise<string> {
  await until(() => page.X3DPhysics !== undefined);
  return afterOneSecond(await worldIn(page));
}

function afterOneSecond(world: World): string {
  world.paused = true;
  world.reset();
  world.advance(1);
  const ball = world.node('ball')!;
  return JSON.stringify(
    ['position', 'orientation', 'linearVelocity'].map((name) => ball.get(name)),
  );
}

function drawn(element: Element): number | undefined {
  type Node = { getCurrentTransform(): { _13: number } };
  return (element as unknown as { _x3domNode?: Node })._x3domNode?.getCurrentTransform()._13;
}

/** As soon as the file of the page's Inline is there. */
async function worldOfInline(page: Page): Promise<World> {
  type Node = { _childNodes: { _xmlNode: Element }[] };
  const inline = page.document.querySelector('inline') as unknown as { _x3domNode?: Node };
  const body = (): Element | null | undefined =>
    inline._x3domNode?._childNodes[0]?._xmlNode.querySelector('RigidBody');
  await until(() => !!body());
  return page.X3DPhysics!.worldOf(body()!)!.ready;
}

const isThere = async (url: string): Promise<boolean> => (await fetch(url)).ok;

function facts(x3dom: string, leaveOut: (test: Mocha.Context) => Promise<void>): void {
  beforeEach(async function () {
    await leaveOut(this);
  });

  for (const [build, ours] of Object.entries(OURS)) {
    for (const [order, scripts] of Object.entries({
      before: x3dom + ours,
      after: ours + x3dom,
    })) {
      it(`${build}, x3dom ${order} it: bodies move once, as without that engine, and nothing is told`, async () => {
        for (const content of [BOX, PLAIN]) {
          const page = await openPage(scripts, content);
          expect(await fall(page)).to.equal(await fall(await openPage(X3DOM + ours, content)));
        }
        const page = await openPage(scripts, PLAIN);
        await fall(page);
        const height = (
          page.X3DPhysics!.worldOf(named(page, 'ball'))!.node('ball')!.get('position') as number[]
        )[1]!;
        await until(() => Math.abs(drawn(named(page, 'moves'))! - height) < 1e-3);
        expect(heardIn(page)).to.eql([]);
        expect(named(page, 'ball').attributes).to.have.lengthOf(3);
        if (page.ownEngine) expect(page.ownEngine).to.eql({ begun: 0, frames: 0 });
      });
    }
  }

  it('files that an Inline brings move, too', async () => {
    const bits: string[] = [];
    for (const each of [x3dom, X3DOM]) {
      const page = await openPage(each + OURS.classic, INLINE);
      bits.push(afterOneSecond(await worldOfInline(page)));
      expect(heardIn(page)).to.eql([]);
    }
    expect(bits[0]).to.equal(bits[1]);
  });

  it('a scene without physics beside one with it stays as it is', async () => {
    const still =
      '<transform def="still" translation="0 2 0"><shape><box></box></shape></transform>';
    const page = await openPage(x3dom + OURS.classic, BOX, still);
    await fall(page);
    await until(() => drawn(named(page, 'still')) === 2);
    expect(named(page, 'still').getAttribute('translation')).to.equal('0 2 0');
    expect(heardIn(page)).to.eql([]);
  });

  it("a page's own handler of its load is called", async () => {
    const own = '<script>window.onload = function () { window.loaded = 1; };</script>';
    const page = await openPage(x3dom + own + OURS.classic, BOX);
    expect(page.loaded).to.equal(1);
    await fall(page);
    expect(heardIn(page)).to.eql([]);
  });
}

describe("x3dom's own physics, by a stand-in that hangs on the page as it does", () => {
  facts(STAND_IN, async () => {});

  it('what runs already is stopped, its nodes become ours, and that is told', async () => {
    const page = await openPage(STAND_IN, BOX + PLAIN.replaceAll('moves', 'other'));
    await until(() => page.ownEngine!.frames > 3);
    expect(named(page, 'collidable').attributes).to.have.length.greaterThan(2);
    await addScript(page, '/dist/x3d-physics.classic.js');
    await until(() => heardIn(page).includes('two-physics-engines'));
    const { frames } = page.ownEngine!;
    const body = page.document.querySelector('RigidBody')!;
    expect([...body.attributes].map(({ name }) => name)).to.eql(['def', 'mass', 'containerfield']);
    const world = await page.X3DPhysics!.worldOf(body)!.ready;
    await until(() => world.time > 0.2);
    expect(page.ownEngine!.frames).to.equal(frames);
    expect((world.node('ball')!.get('linearVelocity') as number[])[1]).to.be.lessThan(-1);
  });
});

describe("x3dom's own physics, in a full build made from x3dom's source", () => {
  facts(`<script src="${FULL}"></script>`, async (test) => {
    if (!(await isThere(FULL))) test.skip();
  });

  it('geometry that it has nodes for is drawn by these', async function () {
    if (!(await isThere(FULL))) this.skip();
    const grid = `<shape><ElevationGrid def="grid" xDimension="2" zDimension="2" height="0 0 0 0"></ElevationGrid></shape>
      <x3d-rigid-body fixed></x3d-rigid-body>`;
    const page = await openPage(
      `<script src="${FULL}"></script>${OURS.classic}`,
      `${BOX}<transform>${grid}</transform>`,
    );
    await fall(page);
    const { _x3domNode: node } = named(page, 'grid') as unknown as { _x3domNode: object };
    expect(node).not.to.have.property('surface');
    expect(heardIn(page)).to.eql([]);
  });
});
