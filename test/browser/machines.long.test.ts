import { expect } from 'chai';
import { worldOf } from '../../elements/index.js';
import { place, until, position } from './scene.js';
import type { World } from './inside.js';

// Machines as authors of X3D build them, in files of their own: joints, motors, sensors, and ROUTEs to what is drawn.

const spin = (world: World, name: string): number[] =>
  world.node(name)!.get('angularVelocity') as number[];

/** Of all joints, metres; a slider's anchors part on its way. */
const widestGap = (world: World): number =>
  Math.max(
    ...[...world.nodes]
      .filter(({ type }) => type.name !== 'SliderJoint')
      .map((node) => (node as { gap?: number }).gap ?? 0),
  );

const files: string[] = [];

/** Shows a scene as an inlined file; the world of its collection, at its start. */
async function inline(scene: string): Promise<{ world: World; named(def: string): Element }> {
  const file = `<?xml version="1.0" encoding="UTF-8"?>
    <X3D profile="Full" version="4.0"><Scene>${scene}</Scene></X3D>`;
  const url = URL.createObjectURL(new Blob([file], { type: 'model/x3d+xml' }));
  files.push(url);
  const x3d = place(`<inline url="${url}"></inline>`);
  const { detail } = await new Promise<CustomEvent>((resolve) =>
    x3d.addEventListener('physicsready', (event) => resolve(event as CustomEvent)),
  );
  const world = worldOf(detail.element) as World;
  world.paused = true;
  world.reset();
  const root = (detail.element as Element).ownerDocument;
  const named = (def: string): Element =>
    [...root.querySelectorAll('*')].find(
      (each) => Element.prototype.getAttribute.call(each, 'DEF') === def,
    )!;
  return { world, named };
}

const shape = (geometry: string): string =>
  `<CollidableShape containerField="geometry"><Shape containerField="shape">${geometry}</Shape></CollidableShape>`;
const drawnAt = (element: Element): { x: number; y: number; z: number } =>
  (
    element as unknown as {
      _x3domNode: { _vf: { translation: { x: number; y: number; z: number } } };
    }
  )._x3domNode._vf.translation;

describe('machines in X3D files', () => {
  afterEach(() => files.splice(0).forEach((url) => URL.revokeObjectURL(url)));

  it('a piston: a crank turned by a MotorJoint moves a SliderJoint back and forth by twice its radius', async () => {
    const { world, named } = await inline(`
      <Transform DEF="Drawn"><Shape><Box size="0.5 0.5 0.5"/></Shape></Transform>
      <RigidBodyCollection DEF="World" gravity="0 0 0">
        <RigidBody DEF="Crank" containerField="bodies" mass="4" position="0 0 0">${shape('<Box size="1 0.2 0.2"/>')}</RigidBody>
        <RigidBody DEF="Rod" containerField="bodies" mass="0.5" position="2 0 0">${shape('<Box size="3 0.1 0.1"/>')}</RigidBody>
        <RigidBody DEF="Piston" containerField="bodies" mass="0.5" position="3.5 0 0">${shape('<Box size="0.5 0.5 0.5"/>')}</RigidBody>
        <SingleAxisHingeJoint containerField="joints" anchorPoint="0 0 0" axis="0 0 1"><RigidBody USE="Crank" containerField="body1"/></SingleAxisHingeJoint>
        <SingleAxisHingeJoint DEF="Big" containerField="joints" anchorPoint="0.5 0 0" axis="0 0 1"><RigidBody USE="Crank" containerField="body1"/><RigidBody USE="Rod" containerField="body2"/></SingleAxisHingeJoint>
        <SingleAxisHingeJoint DEF="Small" containerField="joints" anchorPoint="3.5 0 0" axis="0 0 1"><RigidBody USE="Rod" containerField="body1"/><RigidBody USE="Piston" containerField="body2"/></SingleAxisHingeJoint>
        <SliderJoint DEF="Slide" containerField="joints" axis="1 0 0" minSeparation="-2" maxSeparation="2" forceOutput='"separation"'><RigidBody USE="Piston" containerField="body1"/></SliderJoint>
        <MotorJoint containerField="joints" enabledAxes="1" motor1Axis="0 0 1" axis1Torque="0.5"><RigidBody USE="Crank" containerField="body1"/></MotorJoint>
      </RigidBodyCollection>
      <ROUTE fromNode="Piston" fromField="position" toNode="Drawn" toField="translation"/>`);
    let [low, high, turned] = [Infinity, -Infinity, 0];
    for (let i = 0; i < 600; i++) {
      world.step(1);
      const [x, y, z] = position(world, 'Piston');
      [low, high] = [Math.min(low, x!), Math.max(high, x!)];
      // 0.3 nm aside and gaps of 1.3 µm were measured.
      expect(Math.hypot(y!, z!)).to.be.below(1e-6);
      expect(widestGap(world)).to.be.below(1e-5);
      turned += Math.abs(spin(world, 'Crank')[2]!) * world.timeStep;
    }
    expect(turned).to.be.above(2 * Math.PI);
    // 8 µm less than that, measured.
    expect(high - low).to.be.closeTo(1, 1e-4);
    // What is drawn follows with the next frame.
    const [x] = position(world, 'Piston');
    await until(() => Math.abs(drawnAt(named('Drawn')).x - x!) < 0.02);
    expect(world.problems.filter(({ severity }) => severity !== 'info')).to.eql([]);
  });

  it('a car: DoubleAxisHingeJoints carry, drive and steer it', async () => {
    const wheel = (name: string, x: number, z: number): string => `
      <RigidBody DEF="${name}" containerField="bodies" mass="2" position="${x} 0.4 ${z}">${shape('<Sphere radius="0.4"/>')}</RigidBody>`;
    const hinge = (name: string, x: number, z: number, rest: string): string => `
      <DoubleAxisHingeJoint DEF="${name}Joint" containerField="joints" anchorPoint="${x} 0.4 ${z}" axis1="0 1 0" axis2="1 0 0" ${rest}>
        <RigidBody USE="Chassis" containerField="body1"/><RigidBody USE="${name}" containerField="body2"/></DoubleAxisHingeJoint>`;
    const straight = 'minAngle1="0" maxAngle1="0"';
    const { world } = await inline(`
      <RigidBodyCollection DEF="World">
        <RigidBody DEF="Ground" containerField="bodies" fixed="true" position="0 -0.5 0">${shape('<Box size="200 1 200"/>')}</RigidBody>
        <RigidBody DEF="Chassis" containerField="bodies" mass="20" position="0 0.6 0">${shape('<Box size="1 0.4 2"/>')}</RigidBody>
        ${wheel('FL', -0.8, 1)}${wheel('FR', 0.8, 1)}${wheel('RL', -0.8, -1)}${wheel('RR', 0.8, -1)}
        ${hinge('FL', -0.8, 1, straight)}${hinge('FR', 0.8, 1, straight)}
        ${hinge('RL', -0.8, -1, `${straight} desiredAngularVelocity2="-5" maxTorque2="10"`)}
        ${hinge('RR', 0.8, -1, `${straight} desiredAngularVelocity2="-5" maxTorque2="10"`)}
      </RigidBodyCollection>`);
    world.advance(4);
    const [x, y, z] = position(world, 'Chassis');
    // 5 rad/s on wheels of 0.4 m are 2 m/s: within 0.3 mm/s, measured, and 6.7 m far, 2 mm aside.
    const speed = Math.hypot(...(world.node('Chassis')!.get('linearVelocity') as number[]));
    expect(speed).to.be.closeTo(2, 0.01);
    expect(Math.abs(z!)).to.be.above(6);
    expect(Math.abs(x!)).to.be.below(0.02);
    expect(y).to.be.closeTo(0.6, 2e-3);
    // 0.05 mm were measured.
    expect(widestGap(world)).to.be.below(5e-4);
    for (const name of ['FLJoint', 'FRJoint'])
      for (const [field, value] of [
        ['minAngle1', 0.3],
        ['maxAngle1', 0.3],
      ] as const)
        (world.node(name)!.host as Element).setAttribute(field, String(value));
    const before = spin(world, 'Chassis')[1]!;
    world.advance(2);
    expect(Math.abs(before)).to.be.below(1e-3);
    // Wheels 2 m apart, the front ones at 0.3 rad: v tan 0.3 / 2 m would be 0.31 rad/s without slip; 0.27 were measured.
    expect(Math.abs(spin(world, 'Chassis')[1]!)).to.be.within(0.22, 0.31);
    expect(world.problems.filter(({ severity }) => severity !== 'info')).to.eql([]);
  });

  it('shafts: a UniversalJoint passes the rotation on around a corner', async () => {
    const { world } = await inline(`
      <RigidBodyCollection DEF="World" gravity="0 0 0">
        <RigidBody DEF="Drive" containerField="bodies" position="-1 0 0">${shape('<Box size="2 0.2 0.2"/>')}</RigidBody>
        <RigidBody DEF="Driven" containerField="bodies" position="0.866 0.5 0" orientation="0 0 1 0.5236">${shape('<Box size="2 0.2 0.2"/>')}</RigidBody>
        <SingleAxisHingeJoint containerField="joints" anchorPoint="-1 0 0" axis="1 0 0"><RigidBody USE="Drive" containerField="body1"/></SingleAxisHingeJoint>
        <SingleAxisHingeJoint containerField="joints" anchorPoint="0.866 0.5 0" axis="0.866 0.5 0"><RigidBody USE="Driven" containerField="body1"/></SingleAxisHingeJoint>
        <UniversalJoint containerField="joints" anchorPoint="0 0 0" axis1="0 1 0" axis2="0 0 1"><RigidBody USE="Drive" containerField="body1"/><RigidBody USE="Driven" containerField="body2"/></UniversalJoint>
        <MotorJoint containerField="joints" enabledAxes="1" motor1Axis="1 0 0" axis1Torque="0.05"><RigidBody USE="Drive" containerField="body1"/></MotorJoint>
      </RigidBodyCollection>`);
    let [drive, driven, ahead] = [0, 0, 0];
    for (let i = 0; i < 600; i++) {
      world.step(1);
      drive += spin(world, 'Drive')[0]! * world.timeStep;
      const [x, y] = spin(world, 'Driven');
      driven += (x! * Math.cos(Math.PI / 6) + y! * Math.sin(Math.PI / 6)) * world.timeStep;
      ahead = Math.max(ahead, Math.abs(drive - driven));
    }
    expect(Math.abs(drive)).to.be.above(2 * Math.PI);
    // Within each turn a cardan's angles differ by asin((1 - cos β) / (1 + cos β)) at most: 0.0719 at 30 degrees.
    expect(ahead).to.be.closeTo(0.0719, 0.002);
    // 0.03 µm were measured.
    expect(widestGap(world)).to.be.below(1e-6);
    expect(world.problems.filter(({ severity }) => severity !== 'info')).to.eql([]);
  });

  it('a door bell: a CollisionSensor ROUTEd to a TimeSensor starts it when the clapper strikes', async () => {
    const { world, named } = await inline(`
      <TimeSensor DEF="Ring" enabled="false" loop="true"/>
      <RigidBodyCollection DEF="World">
        <RigidBody DEF="Bell" containerField="bodies" fixed="true"><CollidableShape DEF="BellShape" containerField="geometry"><Shape containerField="shape"><Box size="2 1 2"/></Shape></CollidableShape></RigidBody>
        <RigidBody DEF="Clapper" containerField="bodies" position="0 2 0"><CollidableShape DEF="ClapperShape" containerField="geometry"><Shape containerField="shape"><Sphere radius="0.25"/></Shape></CollidableShape></RigidBody>
        <CollisionCollection DEF="Hits" containerField="collider" bounce="0.5">
          <CollidableShape USE="BellShape" containerField="collidables"/><CollidableShape USE="ClapperShape" containerField="collidables"/>
        </CollisionCollection>
      </RigidBodyCollection>
      <CollisionSensor DEF="Sensor"><CollisionCollection USE="Hits" containerField="collider"/></CollisionSensor>
      <ROUTE fromNode="Sensor" fromField="isActive" toNode="Ring" toField="enabled"/>`);
    const enabled = (): boolean =>
      (named('Ring') as unknown as { _x3domNode: { _vf: { enabled: boolean } } })._x3domNode._vf
        .enabled;
    world.advance(0.3);
    expect(enabled()).to.equal(false);
    let rang = false;
    for (let i = 0; i < 60 && !rang; i++) {
      world.step(1);
      rang = enabled();
    }
    expect(rang).to.equal(true);
    // 1.25 m down.
    expect(world.time).to.be.closeTo(Math.sqrt((2 * 1.25) / 9.8), 0.02);
    world.advance(0.1);
    expect(enabled()).to.equal(false);
  });
});
