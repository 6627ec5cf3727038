import { expect } from 'chai';
import { show, until } from '../../scene.js';
import { worldOf } from '../../inside.js';

describe('x3dom', () => {
  it('draws a USE that stands before its DEF', async () => {
    const { x3d } = await show(`
      <CollidableShape id="use" USE="late"></CollidableShape>
      <RigidBodyCollection><RigidBody DEF="b"><CollidableShape DEF="late"><Shape><Sphere></Sphere></Shape></CollidableShape></RigidBody></RigidBodyCollection>`);
    const node = (
      x3d.querySelector('[def=late]') as unknown as { _x3domNode: { _parentNodes: unknown[] } }
    )._x3domNode;
    expect(node._parentNodes.length).to.equal(1);
  });

  it('is not needed for the simulation to run from elements in the scene only', async () => {
    const { x3d, world } = await show(
      `<RigidBodyCollection><RigidBody DEF="b"></RigidBody></RigidBodyCollection>`,
    );
    expect(world.stats.bodies).to.equal(1);
    expect(getComputedStyle(x3d.querySelector('scene')!).display).to.equal('none');
  });

  it('a prototype holds bodies', async () => {
    const { x3d } = await show(
      `
      <ProtoDeclare name="Ball"><ProtoInterface><field name="at" type="SFVec3f" dataType="SFVec3f" accessType="initializeOnly" value="0 0 0"></field></ProtoInterface>
        <ProtoBody><RigidBodyCollection DEF="pc"><RigidBody DEF="pb" position="0 4 0"></RigidBody></RigidBodyCollection></ProtoBody></ProtoDeclare>
      <ProtoInstance name="Ball" DEF="one"></ProtoInstance>
      <x3d-rigid-body id="own"></x3d-rigid-body>`,
      '#own',
    );
    await until(() => x3d.querySelector('ball') !== null);
    const body = (
      x3d.querySelector('ball') as unknown as { _x3domNode: { protoBodyClone: Element } }
    )._x3domNode.protoBodyClone.querySelector('[def=pb]')!;
    const world = worldOf(body)!;
    await world.ready;
    world.paused = true;
    world.reset();
    expect(world.node(body)!.get('position')).to.eql([0, 4, 0]);
    expect(world.stats.bodies).to.equal(1);
  });
});
