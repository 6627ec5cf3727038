import { expect } from 'chai';
import type { X3DRigidBodyElement } from '../../../../../elements/index.js';
import { worldOf } from '../../../../../elements/index.js';
import { drawn, place, show, until, wait } from '../../../scene.js';
import type { World } from '../../../inside.js';

interface LineShape {
  _vf: { isPickable: boolean };
  _cf: {
    geometry: {
      node: { _mesh: { _positions: Float32Array[]; _indices: Uint32Array[]; _primType: string } };
    };
  };
  _xmlNode: Element | null;
}

interface Runtime {
  canvas: { doc: { _scene: { _childNodes: LineShape[] } } };
  getSceneBBox(): { min: object; max: object };
  shootRay(x: number, y: number): { pickObject: Element | null };
  exitFrame(): void;
}

const runtimeOf = (x3d: Element): Runtime => (x3d as unknown as { runtime: Runtime }).runtime;

/** The shapes that stand in x3dom's scene without an element. */
const sketches = (x3d: Element): LineShape[] =>
  runtimeOf(x3d).canvas.doc._scene._childNodes.filter(
    (node) => !node._xmlNode && node._cf.geometry?.node?._mesh._primType === 'LINES',
  );

const positions = (x3d: Element): number[] => [
  ...(sketches(x3d)[0]?._cf.geometry.node._mesh._positions[0] ?? []),
];

const least = (x3d: Element, axis: 0 | 1 | 2): number =>
  Math.min(...positions(x3d).filter((_, i) => i % 3 === axis));

const active = (world: World): boolean =>
  world.effects.find(({ name }) => name === 'debug drawing')!.active;

/** A box of 2 m that hangs still, in either spelling. */
const hanging = (spelling: 'custom' | 'plain', attributes = ''): string => {
  const shape = '<transform id="shape" translation="1 2 3"><shape><box></box></shape></transform>';
  return spelling === 'custom'
    ? `<x3d-rigid-body-collection gravity="0 0 0" ${attributes}>
         <x3d-rigid-body id="body" for="shape"></x3d-rigid-body>
       </x3d-rigid-body-collection>${shape}`
    : `<RigidBodyCollection gravity="0 0 0" ${attributes}>
         <RigidBody id="body" for="shape"></RigidBody>
       </RigidBodyCollection>${shape}`;
};

describe('debug drawing', () => {
  for (const spelling of ['custom', 'plain'] as const) {
    it(`${spelling}: an attribute switches it on and off`, async () => {
      const { x3d, world } = await show(hanging(spelling));
      world.paused = true;
      await drawn();
      expect(sketches(x3d).length).to.equal(0);
      expect(active(world)).to.equal(false);
      const collection = x3d.querySelector('#body')!.parentElement!;
      collection.setAttribute('debug', 'true');
      await until(() => sketches(x3d).length === 1);
      // Twelve edges and the cross at the centre of mass.
      expect(positions(x3d).length).to.equal((12 + 3) * 6);
      expect([0, 1, 2].map((axis) => least(x3d, axis as 0))).to.eql([0, 1, 2]);
      const because = world.effects.find(({ name }) => name === 'debug drawing')!.because!;
      expect(because.element).to.equal(collection);
      collection.removeAttribute('debug');
      await until(() => sketches(x3d).length === 0);
      expect(active(world)).to.equal(false);
    });
  }

  it('follows steps, edits, teleports and resets while the world is paused', async () => {
    const { x3d, world } = await show(hanging('custom', 'debug'));
    world.paused = true;
    await until(() => sketches(x3d).length === 1);
    const body = x3d.querySelector<X3DRigidBodyElement>('#body')!;
    body.linearVelocity = [12, 0, 0];
    world.step(10);
    await until(() => Math.abs(least(x3d, 0) - 1) < 1e-5);
    body.teleport([-5, 2, 3]);
    await until(() => Math.abs(least(x3d, 0) - -6) < 1e-5);
    x3d.querySelector('box')!.setAttribute('size', '6 6 6');
    await until(() => Math.abs(least(x3d, 0) - -8) < 1e-5);
    world.reset();
    await until(() => Math.abs(least(x3d, 0) - -2) < 1e-5);
    world.accuracy = 'fine';
    world.step(2);
    await until(() => least(x3d, 0) > -2);
    body.remove();
    await until(() => (sketches(x3d)[0]?._cf.geometry.node._mesh._positions[0]!.length ?? 0) === 0);
  });

  it('has a rope, a cloth and a soft body by their edges, and goes where they go', async () => {
    const { x3d, world } = await show(`
      <x3d-rigid-body-collection default debug></x3d-rigid-body-collection>
      <x3d-rope points="0 3 0 1 3 0" segments="4"></x3d-rope>
      <transform translation="3 3 0"><x3d-cloth size="2 1" subdivision="2 1"></x3d-cloth></transform>
      <transform translation="6 3 0"><shape><box size="1 1 1"></box></shape><x3d-soft-body></x3d-soft-body></transform>`);
    world.paused = true;
    await until(() => positions(x3d).length === 6 * (4 + 9 + 18));
    const low = least(x3d, 1);
    world.advance(0.5);
    await until(() => least(x3d, 1) < low - 0.5);
  });

  it('adds no element, no body, no bounds, and can not be picked', async () => {
    // Nothing of the body is drawn: a ray there meets only lines.
    const invisible = `<viewpoint position="0 0 10"></viewpoint>
      <transform translation="50 0 0"><shape><box></box></shape></transform>
      <x3d-rigid-body-collection gravity="0 0 0">
        <x3d-rigid-body><x3d-collidable-shape><shape><box></box></shape></x3d-collidable-shape></x3d-rigid-body>
      </x3d-rigid-body-collection>`;
    const { x3d, world } = await show(invisible);
    await drawn();
    const runtime = runtimeOf(x3d);
    const picture = (): unknown => [
      x3d.querySelectorAll('*').length,
      world.stats.bodies,
      world.stats.created,
      JSON.stringify(runtime.getSceneBBox()),
      runtime.shootRay(150, 100).pickObject,
    ];
    const before = picture();
    x3d.querySelector('x3d-rigid-body-collection')!.setAttribute('debug', '');
    await until(() => sketches(x3d).length === 1);
    await drawn();
    expect(picture()).to.eql(before);
    expect(sketches(x3d)[0]!._vf.isPickable).to.equal(false);
  });

  it('draws a shared world once, and each world by itself', async () => {
    const one = (attributes: string, x: number): string =>
      `<x3d-rigid-body-collection gravity="0 0 0" ${attributes}>
        <x3d-rigid-body position="${x} 0 0"><x3d-collidable-shape><shape><box></box></shape></x3d-collidable-shape></x3d-rigid-body>
      </x3d-rigid-body-collection>`;
    const shared = 'shared-world="w"';
    const { x3d } = await show(
      one(`${shared} debug`, 0) + one(`${shared} debug`, 5) + one('debug', 10) + one('', 20),
    );
    await until(() => sketches(x3d).length === 2);
    await until(() => positions(x3d).length === 2 * 15 * 6);
    const [first, second] = x3d.querySelectorAll('x3d-rigid-body-collection');
    first!.removeAttribute('debug');
    await drawn();
    expect(sketches(x3d).length).to.equal(2);
    second!.removeAttribute('debug');
    await until(() => sketches(x3d).length === 1);
  });

  it('is there again when the x3d was taken out and put back', async () => {
    const { x3d } = await show(hanging('custom', 'debug'));
    await until(() => sketches(x3d).length === 1);
    x3d.remove();
    await wait(50);
    document.body.append(x3d);
    await worldOf(x3d.querySelector('x3d-rigid-body'))!.ready;
    await until(() => sketches(x3d).length === 1);
    await until(() => positions(x3d).length === 15 * 6);
  });

  it('of two x3d elements stands in each its own', async () => {
    const scene = `<x3d width="200px" height="100px"><scene>${hanging('custom', 'debug')}</scene></x3d>`;
    document.body.innerHTML = scene + scene.replaceAll('shape"', 'other"');
    const both = [...document.querySelectorAll('x3d')];
    for (const x3d of both)
      await until(() => !!x3d.querySelector('canvas') && sketches(x3d).length === 1);
  });

  it('is of the world frame in metres, where a file has other units', async () => {
    const { x3d, world } = await show(
      `<unit category="length" name="cm" conversionFactor="0.01"></unit>
       <x3d-rigid-body-collection gravity="0 0 0" debug>
         <x3d-rigid-body position="100 0 0"><x3d-collidable-shape><shape><box></box></shape></x3d-collidable-shape></x3d-rigid-body>
       </x3d-rigid-body-collection>`,
    );
    await until(() => positions(x3d).length > 0);
    expect(
      (world.node(x3d.querySelector('x3d-rigid-body'))!.get('position') as number[])[0],
    ).to.equal(1);
    expect(least(x3d, 0)).to.be.closeTo(99, 1e-3);
  });

  it('of a world at rest asks for no frames', async () => {
    const { x3d, world } = await show(hanging('custom', 'debug'));
    await until(() => sketches(x3d).length === 1);
    (world.node('body') as unknown as { sleep(): void }).sleep();
    let quiet = 0;
    runtimeOf(x3d).exitFrame = () => (quiet = -1);
    // The page itself may still have something to draw at first.
    await until(() => ++quiet > 20);
    const drawnFrom = performance.now();
    await until(() => performance.now() - drawnFrom > 300);
    expect(quiet).to.be.above(20);
  });

  it('has the ghost of a recorded run alone, while one looks back, and nothing once it goes on or ends', async () => {
    const { x3d, world } = await show(hanging('custom').replace('0 0 0', '0 -9.8 0'));
    world.paused = true;
    world.reset();
    const timeline = await world.record();
    world.step(60);
    await timeline.ghost('game');
    await drawn();
    expect(sketches(x3d).length).to.equal(0);
    timeline.seek(0.25);
    // Twelve edges, without a cross.
    await until(() => positions(x3d).length === 12 * 6);
    expect(least(x3d, 1)).to.be.closeTo(2 - 1 - 4.9 / 16, 1e-3);
    const because = world.effects.find(({ name }) => name === 'debug drawing')!.because!;
    expect(because.element).to.equal(x3d.querySelector('#body'));
    timeline.seek(0.5);
    await until(() => Math.abs(least(x3d, 1) - (2 - 1 - 4.9 / 4)) < 1e-3);
    const collection = x3d.querySelector('x3d-rigid-body-collection')!;
    collection.setAttribute('debug', '');
    world.resume();
    await until(() => positions(x3d).length === (12 + 3) * 6);
    collection.removeAttribute('debug');
    await until(() => sketches(x3d).length === 0);
    timeline.seek(0.25);
    await until(() => sketches(x3d).length === 1);
    collection.remove();
    await until(() => sketches(x3d).length === 0);
  });

  it('stands once when it is switched on and off quickly', async () => {
    const x3d = place(hanging('custom', 'debug'));
    const collection = x3d.querySelector('x3d-rigid-body-collection')!;
    await worldOf(collection)!.ready;
    for (let i = 0; i < 5; i++) {
      collection.toggleAttribute('debug');
      await Promise.resolve();
    }
    collection.setAttribute('debug', '');
    await until(() => sketches(x3d).length === 1);
    await drawn();
    expect(sketches(x3d).length).to.equal(1);
  });
});
