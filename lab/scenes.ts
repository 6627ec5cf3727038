import type { CaseBody, CaseScene, Vec3 } from './case.js';
import { addBodies, wallsOf } from './walls.js';
import { loadEngine } from '../physics-core/create.js';
import { World, type PhysicsNode } from '../physics-core/inside.js';

/** A scene to measure. */
export interface Scene {
  name: string;
  /** Fields of its RigidBodyCollection. */
  fields?: Record<string, unknown>;
  /** Seconds simulated before anything is measured. */
  warmUp: number;
  build(world: World): void;
  /** The same in words that every engine can be told. */
  told?: CaseScene;
}

/** The scene in a world that never rests, ready to be measured. */
export async function started({ fields, build, warmUp }: Scene): Promise<World> {
  const world = new World();
  world.add('RigidBodyCollection', { rest: 'never', ...fields });
  build(world);
  world.start(await loadEngine());
  world.advance(warmUp);
  return world;
}

const sphere = (radius: number) => ({ type: 'Sphere', radius });
const box = (...size: number[]) => ({ type: 'Box', size });

/** Scene 1 of the paper: eight balls on seven ball joints, the last twenty times as heavy. */
function chain(world: World): void {
  const d = Math.SQRT1_2;
  let last: PhysicsNode | undefined;
  for (let i = 0; i < 8; i++) {
    const body = world.add('RigidBody', {
      position: [i * d, -i * d, 0],
      fixed: i === 0,
      mass: i < 7 ? 0.1 : 2,
      useGlobalGravity: i === 7,
      geometry: [sphere(0.1)],
    });
    if (last)
      world.add('BallJoint', {
        body1: last,
        body2: body,
        anchorPoint: [(i - 1) * d, -(i - 1) * d, 0],
      });
    last = body;
  }
}

/** Scene 2 of the paper: a hull on a ball joint, driven by a motor, strikes what hangs beside it. */
function motor(world: World): void {
  const tetrahedron = {
    type: 'IndexedFaceSet',
    coord: [0.3, 0.3, 0.3, -0.3, -0.3, 0.3, -0.3, 0.3, -0.3, 0.3, -0.3, -0.3],
    coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1],
  };
  const pin = world.add('RigidBody', { fixed: true, geometry: [sphere(0.1)] });
  let last = pin;
  for (let i = 1; i <= 4; i++) {
    const body = world.add('RigidBody', {
      position: [0, -i, 0],
      mass: 0.5,
      geometry: [sphere(0.2)],
    });
    world.add('BallJoint', { body1: last, body2: body, anchorPoint: [0, -i, 0] });
    last = body;
  }
  const hull = world.add('RigidBody', { position: [2, 0, 0], geometry: [tetrahedron] });
  world.add('BallJoint', { body1: hull, body2: pin });
  world.add('MotorJoint', { body1: hull, motor1Axis: [0, 0, 1], axis1Torque: 30 });
}

/** Scene 3 of the paper without its motor: boxes heaped up in a room. */
function room(count: number): CaseBody[] {
  let state = 1;
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
  const boxes = Array.from({ length: count }, (_, i): CaseBody => {
    const size = 0.5 + 0.5 * random();
    return {
      name: String(i),
      position: [
        1.2 * ((i % 7) - 3),
        1 + 1.1 * Math.floor(i / 49),
        1.2 * ((Math.floor(i / 7) % 7) - 3),
      ],
      mass: 8 * size ** 3,
      shape: { type: 'Box', size: [size, size, size] },
    };
  });
  const size: Vec3 = [12, 1, 12];
  const floor: CaseBody = {
    name: 'floor',
    fixed: true,
    position: [0, -0.5, 0],
    shape: { type: 'Box', size },
  };
  return [floor, ...wallsOf(5, 40), ...boxes];
}

export const pile =
  (count: number) =>
  (world: World): void =>
    addBodies(world, room(count));

/**
 * The same as Bullet alone would have it: with its iterations, as many as it takes by itself. Raw Ammo, as its examples make
 * it, rubs along one direction of each contact, Bullet beside us along two as we do.
 */
export const piled = (count: number): Scene => ({
  name: `${count} piled boxes`,
  fields: { iterations: 10 },
  warmUp: 1,
  build: pile(count),
  told: {
    gravity: [0, -9.8, 0],
    bodies: room(count),
    contact: { bounce: 0, friction: 0.5 },
  },
});

/** Scene 4 of the paper: hinged pieces lying on the ground. */
const hinges =
  (count: number) =>
  (world: World): void => {
    world.add('RigidBody', { fixed: true, position: [0, -0.5, 0], geometry: [box(400, 1, 400)] });
    let last: PhysicsNode | undefined;
    for (let i = 0; i < count; i++) {
      const body = world.add('RigidBody', {
        position: [0.5 * i, 0.1, 0],
        mass: 0.5,
        geometry: [box(0.4, 0.2, 0.2)],
      });
      if (last)
        world.add('SingleAxisHingeJoint', {
          body1: last,
          body2: body,
          axis: [0, 1, 0],
          anchorPoint: [0.5 * i - 0.25, 0.1, 0],
        });
      last = body;
    }
  };

/** Boxes in the air that touch nothing, in a world whose bodies may rest as by default. */
export function falling(count: number): Scene {
  const side = Math.ceil(Math.cbrt(count));
  const bodies = Array.from({ length: count }, (_, i): CaseBody => ({
    name: String(i),
    position: [3 * (i % side), 3 * (Math.floor(i / side) % side), 3 * Math.floor(i / side ** 2)],
    shape: { type: 'Box', size: [1, 1, 1] },
  }));
  return {
    name: `${count} falling boxes`,
    fields: { rest: 'auto' },
    warmUp: 0.1,
    build(world) {
      for (const { position, shape } of bodies)
        world.add('RigidBody', { position, geometry: [shape] });
    },
    told: { gravity: [0, -9.8, 0], bodies, contact: { bounce: 0, friction: 0.5 } },
  };
}

export const scenes: readonly Scene[] = [
  falling(1000),
  piled(1000),
  { name: 'chain of 8', warmUp: 0.1, build: chain },
  { name: 'pile of 500', warmUp: 2, build: pile(500) },
  { name: 'row of 200 hinges', warmUp: 1, build: hinges(200) },
];

/** All four of the paper, of a size that all levels bear. */
export const paperScenes: readonly Scene[] = [
  { name: 'pendulum', warmUp: 0.5, build: chain },
  { name: 'pendulum and motor', warmUp: 0.5, build: motor },
  { name: 'room of 100 boxes', warmUp: 2, build: pile(100) },
  { name: 'row of 40 hinges', warmUp: 0.5, build: hinges(40) },
];
