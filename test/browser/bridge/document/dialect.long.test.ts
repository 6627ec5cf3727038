import { expect } from 'chai';
import type { X3DRigidBodyElement } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { drawn, drawnAt, nextFrame, place, show, codes } from '../../scene.js';
import { worldOf } from '../../../../elements/index.js';

function expectNear(actual: number[], expected: number[], tolerance: number): void {
  for (const [i, value] of expected.entries()) expect(actual[i]).to.be.closeTo(value, tolerance);
}

/** As X3DOM's own physics wants it. */
const older = `
  <transform DEF="ground"><shape><box size="10 1 10"></box></shape></transform>
  <transform DEF="link" translation="9 9 9"><transform translation="0 0 0"><shape DEF="linkshape"><box size="1 1 1"></box></shape></transform></transform>
  <CollisionSensor><CollisionCollection enabled="true" bounce="0.5">
    <CollidableShape DEF="cs0"><transform USE="ground" containerField="transform"></transform></CollidableShape>
    <CollidableShape DEF="cs1" translation="2 3 0"><transform USE="link" containerField="transform"></transform><shape USE="linkshape" containerField="shape"></shape></CollidableShape>
  </CollisionCollection></CollisionSensor>
  <RigidBodyCollection id="c">
    <RigidBody DEF="r0" mass="0"><CollidableShape USE="cs0" containerField="geometry"></CollidableShape></RigidBody>
    <RigidBody DEF="r1" mass="2"><CollidableShape USE="cs1" containerField="geometry"></CollidableShape></RigidBody>
    <BallJoint DEF="j" anchorPoint="2 3 0">
      <CollidableShape USE="cs1" containerField="body1"></CollidableShape>
    </BallJoint>
  </RigidBodyCollection>`;

describe("X3DOM's older dialect", () => {
  it('a Transform named by USE is what moves, and starts where its collidable stands', async () => {
    claim('zero-mass');
    const { x3d, world } = await show(older.replace(/<BallJoint[^]*<\/BallJoint>/, ''));
    world.paused = true;
    await nextFrame();
    await nextFrame();
    expect(codes(world)).to.eql(['zero-mass']);
    const link = x3d.querySelector('[def=link]')!;
    expect(drawnAt(link)[0]).to.be.closeTo(2, 1e-6);
    world.advance(4);
    await nextFrame();
    await nextFrame();
    expect(drawnAt(link)[1]).to.be.closeTo(1, 0.05);
    expect(drawnAt(link)[0]).to.be.closeTo(2, 0.05);
  });

  it('zero mass pins, and a joint names its body by a collidable', async () => {
    claim('zero-mass');
    const { world } = await show(older);
    world.paused = true;
    world.advance(1);
    expect(world.stats.joints).to.equal(1);
    expect((world.node('r1')!.get('position') as number[])[1]).to.be.closeTo(3, 0.01);
    expect((world.node('r0')!.get('position') as number[])[1]).to.equal(0);
  });

  it('nothing is drawn twice', async () => {
    claim('zero-mass');
    const { x3d } = await show(older);
    const node = (
      x3d.querySelector('[def=link]') as unknown as { _x3domNode: { _parentNodes: unknown[] } }
    )._x3domNode;
    expect(node._parentNodes.length).to.equal(1);
  });
});

describe('lamps on hinges, in a file that counts angles in degrees', () => {
  it('swing about their hooks, and are drawn where they are', async () => {
    const x3d = place('<inline url="/test/pages/swinging-lamps.x3d"></inline>');
    const event = await new Promise<CustomEvent>((resolve) =>
      x3d.addEventListener('physicsready', (e) => resolve(e as CustomEvent)),
    );
    const world = worldOf(event.detail.element)!;
    world.paused = true;
    world.reset();
    const file = (event.detail.element as Element).ownerDocument;
    const bulbs = ['LeftBulb', 'RightBulb'].map((name) => file.querySelector(`[DEF=${name}]`)!);
    await drawn();
    // 2.5 m from their hooks, to the left and at 45°.
    const side = 2.5 * Math.SQRT1_2;
    expectNear(drawnAt(bulbs[0]!), [-4.5, 6, 0], 1e-5);
    expectNear(drawnAt(bulbs[1]!), [2 + side, 6 - side, 0], 1e-5);
    expect(codes(world)).to.eql([]);
    let swung = 0;
    for (let i = 0; i < 60; i++) {
      world.advance(0.05);
      for (const [name, hook] of [
        ['Left', -2],
        ['Right', 2],
      ] as const) {
        const [x, y, z] = world.node(name)!.get('position') as [number, number, number];
        expect(Math.hypot(x - hook, y - 6)).to.be.closeTo(1, 1e-5);
        expect(z).to.be.closeTo(0, 1e-5);
        swung = Math.max(swung, Math.abs(x - hook));
      }
    }
    expect(swung).to.be.above(0.5);
    await drawn();
    const [x, y] = world.node('Left')!.get('position') as [number, number, number];
    // The lamp hangs as one rigid piece: its bulb 1.5 m from the body, on the line through its own down.
    expect(Math.hypot(drawnAt(bulbs[0]!)[0]! - x, drawnAt(bulbs[0]!)[1]! - y)).to.be.closeTo(
      1.5,
      1e-4,
    );
  });
});

describe('units', () => {
  const content = `
    <unit category="angle" name="degree" conversionFactor="0.0174532925199432958"></unit>
    <unit category="length" name="cm" conversionFactor="0.01"></unit>`;

  it('physics fields and driven Transforms are in those of the file', async () => {
    document.body.innerHTML = `<x3d width="300px" height="200px">${content}<scene>
      <transform DEF="t" translation="100 0 0" rotation="0 0 1 90"><shape><box size="100 20 20"></box></shape>
        <x3d-rigid-body id="b" useglobalgravity="false" angularvelocity="0 0 90" linearvelocity="50 0 0"></x3d-rigid-body></transform>
    </scene></x3d>`;
    const body = document.querySelector<X3DRigidBodyElement>('#b')!;
    const world = worldOf(body)!;
    await world.ready;
    world.paused = true;
    world.reset();
    const node = world.node(body)!;
    expect((node.get('position') as number[])[0]).to.be.closeTo(1, 1e-6);
    expect((node.get('orientation') as number[])[3]).to.be.closeTo(Math.PI / 2, 1e-5);
    expect((node.get('linearVelocity') as number[])[0]).to.be.closeTo(0.5, 1e-6);
    expect(body.angularVelocity[2]).to.be.closeTo(90, 1e-3);
    const [collidable] = node.get('geometry') as { get(name: string): { size: number[] }[] }[];
    expect(collidable.get('shape')[0].size[0]).to.be.closeTo(1, 1e-9);
    world.advance(1);
    await nextFrame();
    await nextFrame();
    expect(body.position[0]).to.be.closeTo(150, 0.1);
    const t = document.querySelector('[def=t]')! as unknown as Element & {
      _x3domNode: { _trafo: Record<string, number> };
    };
    expect(drawnAt(t)[0]).to.be.closeTo(150, 0.1);
    expect(t._x3domNode._trafo._00).to.be.closeTo(Math.cos(Math.PI), 1e-2);
  });
});
