import { expect } from 'chai';
import { worldOf } from '../../../../elements/index.js';
import { show, until, wait } from '../../scene.js';

interface Fields {
  getFieldValue(name: string): { x: number; y: number; z: number };
  setFieldValue(name: string, value: unknown): void;
  _x3domNode: { _vf: Record<string, unknown>; postMessage(name: string, value: unknown): void };
}
const fields = (x3d: Element, name: string): Fields =>
  x3d.querySelector(`[def=${name}]`) as unknown as Fields;

describe('ROUTE and setFieldValue', () => {
  for (const tag of ['RigidBody', 'x3d-rigid-body']) {
    it(`${tag}: setFieldValue is an event that always acts`, async () => {
      const { x3d, world } = await show(
        `<RigidBodyCollection><${tag} DEF="b" position="0 5 0"></${tag}></RigidBodyCollection>`,
      );
      world.paused = true;
      world.advance(1);
      const body = fields(x3d, 'b');
      expect(body.getFieldValue('position').y).to.be.below(1);
      body.setFieldValue('position', body.getFieldValue('position'));
      body.setFieldValue('position', '0 5 0');
      expect(body.getFieldValue('position').y).to.equal(5);
      body.setFieldValue('mass', 3);
      expect(world.node('b')!.get('mass')).to.equal(3);
    });
  }

  it('a circle of ROUTEs between bodies ends', async () => {
    const { x3d, world } = await show(`
      <RigidBodyCollection>
        <RigidBody DEF="a" position="0 5 0"></RigidBody><RigidBody DEF="b" position="0 1 0"></RigidBody>
      </RigidBodyCollection>
      <ROUTE fromNode="a" fromField="position" toNode="b" toField="position"></ROUTE>
      <ROUTE fromNode="b" fromField="position" toNode="a" toField="position"></ROUTE>`);
    await wait(200);
    world.paused = true;
    fields(x3d, 'a').setFieldValue('position', '0 9 0');
    await wait(50);
    expect(Number.isFinite(fields(x3d, 'b').getFieldValue('position').y)).to.equal(true);
  });

  it('a ROUTEd output does not come back as an edit', async () => {
    const { x3d, world } = await show(`
      <RigidBodyCollection><RigidBody DEF="a" position="0 5 0" linearVelocity="1 0 0"></RigidBody></RigidBodyCollection>
      <Transform DEF="t"></Transform><Transform DEF="s"></Transform>
      <ROUTE fromNode="a" fromField="position_changed" toNode="t" toField="set_translation"></ROUTE>
      <ROUTE fromNode="s" fromField="translation_changed" toNode="a" toField="set_position"></ROUTE>`);
    const patched = world.stats.patched;
    // However few frames a busy machine draws meanwhile.
    await until(() => fields(x3d, 't').getFieldValue('translation').x > 0.05);
    expect(world.stats.patched).to.equal(patched);
    expect(fields(x3d, 't').getFieldValue('x' as never)).to.equal(null);
  });

  it('joint outputs go out once per drawn frame', async () => {
    const { x3d } = await show(`
      <RigidBodyCollection>
        <BallJoint DEF="j" anchorPoint="0 3 0" forceOutput='"ALL"'><RigidBody DEF="a" position="1 3 0" containerField="body1"></RigidBody></BallJoint>
      </RigidBodyCollection>
      <Transform DEF="t"></Transform>
      <ROUTE fromNode="j" fromField="body1AnchorPoint" toNode="t" toField="translation"></ROUTE>`);
    await until(() => Math.abs(fields(x3d, 't').getFieldValue('translation').y - 3) < 0.1);
  });

  it('no ghost attributes on custom elements', async () => {
    const { x3d } = await show(
      `<x3d-rigid-body-collection><x3d-rigid-body id="a"></x3d-rigid-body></x3d-rigid-body-collection>`,
    );
    const body = x3d.querySelector('#a')!;
    expect(body.getAttribute('mass')).to.equal(null);
    expect(body.getAttributeNames()).to.eql(['id']);
    let heard = 0;
    body.addEventListener('ping', () => heard++);
    body.remove();
    await wait(20);
    body.addEventListener('ping', () => heard++);
    body.dispatchEvent(new Event('ping'));
    expect(heard).to.equal(2);
    expect(worldOf(body)).to.equal(undefined);
  });

  it('survive a body that moves in the tree', async () => {
    const { x3d, world } = await show(`
      <RigidBodyCollection id="c"><RigidBody DEF="a" position="0 5 0"></RigidBody><RigidBody DEF="b"></RigidBody></RigidBodyCollection>
      <Transform DEF="t"></Transform>
      <ROUTE fromNode="a" fromField="position" toNode="t" toField="translation"></ROUTE>`);
    const sent = (): number => fields(x3d, 't').getFieldValue('translation').y;
    await until(() => sent() > 0 && sent() < 4.95);
    x3d.querySelector('#c')!.append(x3d.querySelector('[def=a]')!);
    const before = sent();
    await until(() => sent() < before - 0.2);
    world.paused = true;
    const [, y] = world.node('a')!.get('position') as number[];
    await until(() => Math.abs(sent() - y!) < 1e-3);
  });

  it('a ROUTEd Transform carries the fixed body in it', async () => {
    const { x3d, world } = await show(
      `
      <TimeSensor DEF="clock" cycleInterval="1" loop="true"></TimeSensor>
      <PositionInterpolator DEF="way" key="0 1" keyValue="0 0 0 4 0 0"></PositionInterpolator>
      <Transform DEF="t"><Shape><Box></Box></Shape><RigidBody DEF="b" fixed="true"></RigidBody></Transform>
      <ROUTE fromNode="clock" fromField="fraction_changed" toNode="way" toField="set_fraction"></ROUTE>
      <ROUTE fromNode="way" fromField="value_changed" toNode="t" toField="translation"></ROUTE>`,
      '[def=b]',
    );
    const seen = new Set<number>();
    await until(() => seen.add((world.node('b')!.get('position') as number[])[0]!).size > 3);
    const drawn = fields(x3d, 't').getFieldValue('translation').x;
    expect((world.node('b')!.get('position') as number[])[0]).to.be.closeTo(drawn, 0.01);
  });
});
