import { expect } from 'chai';
import type { World } from '../../physics-core/index.js';
import { worldOf } from '../../elements/index.js';
import { place } from './bridge/scene.js';

/**
 * Scenes that were written for other X3D browsers. They lie beside the project and not in it; where they are missing
 * these tests say so and pass over.
 */
interface Content {
  world: World;
  inline: Element;
}

type Numbers = number[];
type Joint = { gap: number; get(field: string): number };

async function load(this: Mocha.Context, file: string): Promise<Content> {
  const url = `/shared-content/${file}`;
  if (!(await fetch(url)).ok) {
    console.info(`${file} is not beside the project; its test is left out`);
    this.skip();
  }
  const x3d = place(`<inline url="${url}"></inline>`);
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

describe('X3D content written for other browsers', () => {
  it('BallBounceSimple: the ball falls on the floor and comes to rest without bouncing', async function () {
    const { world } = await load.call(this, 'BallBounceSimple.x3d');
    // The floor's upper side lies at -1 + 0.0219 / 2, the ball's radius is 0.1 m.
    const rest = -1 + 0.0219 / 2 + 0.1;
    world.advance(0.3);
    expect(position(world, 'BallBody')[1]).to.be.closeTo(-0.5 * 9.8 * 0.09, 0.03);
    world.advance(4);
    expect(position(world, 'BallBody')[1]).to.be.closeTo(rest, 0.002);
    expect(speed(world, 'BallBody')).to.be.below(0.01);
  });

  it('BallJoint: both joints hold, and degrees are degrees', async function () {
    const { world } = await load.call(this, 'BallJoint.x3d');
    const turned = world.node('Cylinder1')!.get('orientation') as Numbers;
    expect(turned[3]).to.be.closeTo(Math.PI / 2, 1e-3);
    for (let i = 0; i < 50; i++) {
      world.advance(0.1);
      for (const joint of joints(world, 'BallJoint')) expect(joint.gap).to.be.below(0.02);
    }
  });

  it('SingleAxisHingeJoint: turns about its axis only', async function () {
    const { world } = await load.call(this, 'SingleAxisHingeJoint.x3d');
    const [hinge] = joints(world, 'SingleAxisHingeJoint');
    const before = hinge!.get('angle');
    world.advance(0.5);
    expect(Math.abs(hinge!.get('angle') - before)).to.be.above(0.1);
    const bodies = [...world.nodes].filter((node) => node.type.name === 'RigidBody');
    for (const body of bodies) {
      const [x, , z] = body.get('angularVelocity') as Numbers;
      expect(Math.hypot(x!, z!)).to.be.below(0.02);
    }
    expect(hinge!.gap).to.be.below(0.02);
  });

  it('sim-collision: the box comes to rest on the fixed floor, and the sensor reports', async function () {
    const { world, inline } = await load.call(this, 'sim-collision.x3d');
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
});
