import { expect } from 'chai';
import type { World } from '../../physics-core/inside.js';
import { claim } from '../browser/console.js';
import { place } from '../browser/scene.js';
import { worldOf } from '../browser/inside.js';

/**
 * Scenes that were written for other X3D browsers. They lie beside the project and not in it: tools/test/stages.js leaves
 * these tests out where they are missing, and says so.
 */
interface Content {
  world: World;
  inline: Element;
}

type Numbers = number[];
type Joint = { gap: number; get(field: string): number };

async function load(file: string): Promise<Content> {
  const x3d = place(`<inline url="/content/${file}"></inline>`);
  const inline = x3d.querySelector('inline')!;
  const world = await collectionWorld(inline);
  world.paused = true;
  world.reset();
  return { world, inline };
}

/** The world of the Inline's own RigidBodyCollection, as soon as the file is there. */
async function collectionWorld(inline: Element): Promise<World> {
  for (let tries = 0; tries < 500; tries++) {
    const root = (inline as unknown as { _x3domNode?: { _childNodes: { _xmlNode: Element }[] } })
      ._x3domNode?._childNodes[0]?._xmlNode;
    const collection = root?.getElementsByTagName('RigidBodyCollection')[0];
    const world = collection && worldOf(collection);
    if (world) return world.ready;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  throw new Error('the Inline did not load');
}

const position = (world: World, name: string): Numbers =>
  world.node(name)!.get('position') as Numbers;
const speed = (world: World, name: string): number =>
  Math.hypot(...(world.node(name)!.get('linearVelocity') as Numbers));
const joints = (world: World, type: string): Joint[] =>
  [...world.nodes].filter((node) => node.type.name === type) as unknown as Joint[];

/** rad/s about the hinges' axis. */
const turned = (world: World, name: string): number =>
  Math.abs((world.node(name)!.get('angularVelocity') as Numbers)[2]!);

/**
 * For each half swing after the first hit: the fastest that the ball at the far end was, as a share of the speed of
 * that hit. The way down to it is half of a half swing.
 */
function swings(world: World, count: number): number[] {
  let hit = 0;
  while (turned(world, '_38') >= 0.8 * hit) {
    hit = Math.max(hit, turned(world, '_38'));
    world.step(1);
  }
  const half = Math.round((2 * world.time) / world.timeStep);
  return Array.from({ length: count }, (_, swing) => {
    let fastest = turned(world, swing % 2 ? '_38' : '_46');
    for (let i = 0; i < half; i++) {
      world.step(1);
      fastest = Math.max(fastest, turned(world, swing % 2 ? '_38' : '_46'));
    }
    return fastest / hit;
  });
}

const tell = (shares: number[]): void =>
  console.log(
    `far ball's share of the speed: ${shares.map((share) => share.toFixed(2)).join(' ')}`,
  );

/** Attributes of the first such element of the Inline's file, at run time. */
function write(inline: Element, tag: string, attributes: Record<string, string>): void {
  const root = (inline as unknown as { _x3domNode: { _childNodes: { _xmlNode: Element }[] } })
    ._x3domNode._childNodes[0]!._xmlNode;
  const element = root.getElementsByTagName(tag)[0]!;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
}

/** Metres that a joint may gape: a few times what is seen where wheels and balls strike (2.4e-5). */
const WHOLE = 1e-4;

/** The sixth, sim-vehicle, moves in a test of its own. */
const FILES = [
  'BallBounceSimple',
  'BallJoint',
  'SingleAxisHingeJoint',
  'KineticPendulum',
  'sim-collision',
];

describe('X3D content written for other browsers', () => {
  for (const file of FILES) {
    it(`${file} starts and moves, and nothing in it is lost`, async () => {
      const { world } = await load(`${file}.x3d`);
      const bodies = [...world.nodes].filter(({ type }) => type.name === 'RigidBody');
      const poses = (): Numbers[] =>
        bodies.map((body) => [
          ...(body.get('position') as Numbers),
          ...(body.get('orientation') as Numbers),
        ]);
      const before = poses();
      world.advance(1);
      const after = poses();
      expect(after.flat().every(Number.isFinite)).to.equal(true);
      const moved = after.map((pose, k) => Math.hypot(...pose.map((v, i) => v - before[k]![i]!)));
      expect(Math.max(...moved)).to.be.above(0.05);
      const told = world.problems.filter(({ severity }) => severity !== 'info');
      expect(told).to.eql([]);
    });
  }

  it('BallBounceSimple: the ball falls on the floor and comes to rest without bouncing', async () => {
    const { world } = await load('BallBounceSimple.x3d');
    // The floor's upper side lies at -1 + 0.0219 / 2, the ball's radius is 0.1 m.
    const rest = -1 + 0.0219 / 2 + 0.1;
    world.advance(0.3);
    expect(position(world, 'BallBody')[1]).to.be.closeTo(-0.5 * 9.8 * 0.09, 0.03);
    world.advance(4);
    expect(position(world, 'BallBody')[1]).to.be.closeTo(rest, 0.002);
    expect(speed(world, 'BallBody')).to.be.below(0.01);
  });

  it('BallJoint: both joints hold, and degrees are degrees', async () => {
    const { world } = await load('BallJoint.x3d');
    const turned = world.node('Cylinder1')!.get('orientation') as Numbers;
    expect(turned[3]).to.be.closeTo(Math.PI / 2, 1e-3);
    for (let i = 0; i < 50; i++) {
      world.advance(0.1);
      for (const joint of joints(world, 'BallJoint')) expect(joint.gap).to.be.below(WHOLE);
    }
  });

  it('SingleAxisHingeJoint: turns about its axis only', async () => {
    const { world } = await load('SingleAxisHingeJoint.x3d');
    const [hinge] = joints(world, 'SingleAxisHingeJoint');
    const before = hinge!.get('angle');
    world.advance(0.5);
    expect(Math.abs(hinge!.get('angle') - before)).to.be.above(0.1);
    const bodies = [...world.nodes].filter((node) => node.type.name === 'RigidBody');
    for (const body of bodies) {
      const [x, , z] = body.get('angularVelocity') as Numbers;
      expect(Math.hypot(x!, z!)).to.be.below(0.02);
    }
    expect(hinge!.gap).to.be.below(WHOLE);
  });

  it('sim-collision: the box comes to rest on the fixed floor, and the sensor reports', async () => {
    const { world, inline } = await load('sim-collision.x3d');
    const sensor = world.node('Sensor')!;
    const heard: unknown[] = [];
    sensor.on('isActive', (active) => heard.push(active));
    world.advance(4);
    // The floor is 1 m thick about the origin, the box 1 m.
    expect(position(world, 'Faller')[1]).to.be.closeTo(1, 0.005);
    expect(sensor.get('isActive')).to.equal(true);
    expect(
      (sensor.get('intersections') as { name: string }[]).map(({ name }) => name).sort(),
    ).to.deep.equal(['FallColl', 'FloorColl']);
    expect(heard[0]).to.equal(true);
    expect(inline.isConnected).to.equal(true);
  });

  it('KineticPendulum: hinges hold, balls stay in their plane, the hit sets the row moving', async () => {
    const { world } = await load('KineticPendulum.x3d');
    const row = ['_40', '_42', '_44', '_46'];
    let moved = 0;
    for (let i = 0; i < 30; i++) {
      world.advance(0.1);
      for (const joint of joints(world, 'SingleAxisHingeJoint'))
        expect(joint.gap).to.be.below(WHOLE);
      for (const [k, name] of ['_38', ...row].entries()) {
        expect(Math.abs(position(world, name)[2]!)).to.be.below(0.01);
        if (k > 0) moved = Math.max(moved, turned(world, name));
      }
    }
    expect(moved).to.be.above(0.05);
  });

  it('KineticPendulum: with bounce 1, set at run time, the far ball takes over what friction leaves', async () => {
    const { world, inline } = await load('KineticPendulum.x3d');
    write(inline, 'CollisionCollection', { bounce: '1' });
    const shares = swings(world, 10);
    tell(shares);
    // The file says nothing of friction, so that it is 0.5: the balls slide on each other, half a metre beside their
    // hinges, 4 m up, and 1 - 0.5 · 0.5 / 4 of the speed goes on with each of four hits.
    expect(shares[0]).to.be.closeTo((15 / 16) ** 4, 0.02);
    // Each time less than a cradle without losses between the hits would pass on, until the row swings as one.
    for (let k = 1; k < 5; k++) expect(shares[k]! / shares[k - 1]!).to.be.within(0.58, 0.8);
    for (const share of shares.slice(5)) expect(share).to.be.closeTo(shares[5]!, 0.03);
  });

  it('KineticPendulum: without friction the far ball takes over the swing, ten times over', async () => {
    const { world, inline } = await load('KineticPendulum.x3d');
    write(inline, 'CollisionCollection', { bounce: '1', frictionCoefficients: '0 0' });
    const shares = swings(world, 10);
    tell(shares);
    for (const share of shares) expect(share).to.be.closeTo(1, 0.03);
  });

  it('sim-vehicle: the torque on its rear wheels drives it forward', async () => {
    // Its collider lists the chassis only, with friction for the wheels: it is taken as it is meant.
    claim('one-sided-collider');
    const { world } = await load('sim-vehicle.x3d');
    world.advance(3);
    const [x, y, z] = position(world, 'Chassis');
    // 6 N m on wheels of 0.4 m push 9 kg and the wheels' inertia, 2 kg at the rim: 15 N / 11 kg for 3 s.
    const way = (0.5 * (6 / 0.4) * 9) / 11;
    expect(z).to.be.within(0.7 * way, 1.1 * way);
    expect(Math.abs(x!)).to.be.below(0.2);
    expect(y).to.be.closeTo(0.5, 0.1);
    for (const joint of joints(world, 'SingleAxisHingeJoint')) expect(joint.gap).to.be.below(WHOLE);
  });
});
