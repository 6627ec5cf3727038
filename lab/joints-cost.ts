import { loadEngine, World, type LevelName } from '../physics-core/index.js';
import type { PhysicsNode } from '../physics-core/index.js';

/** Steps that one world takes before the next has its turn, and turns of each. */
const TURN = 20;
const TURNS = 15;

/** What one joint costs in one step: microseconds in the least disturbed turn. */
export interface Cost {
  shape: string;
  level: LevelName;
  joints: number;
  solve: number;
  /** What Bullet's step takes longer than the same bodies without joints. */
  bullet: number;
  /** Of the two, median over the turns. */
  ratio: number;
}

/** The body that a joint holds body `i` by, and where it hangs: trees of one joint per body. */
const shapes: Record<string, (i: number, joints: number) => [parent: number, at: number[]]> = {
  chain: (i) => [i - 1, [i, 0, 0]],
  star: (i, joints) => {
    const angle = (2 * Math.PI * i) / joints;
    const far = Math.max(3, joints / 10);
    return [i ? 0 : -1, i ? [far * Math.cos(angle), 0, far * Math.sin(angle)] : [0, 0, 0]];
  },
  comb: (i) => [i % 2 ? i - 1 : i - 2, [Math.floor(i / 2), -(i % 2), 0]],
};

function build(world: World, shape: string, joints: number, jointed: boolean): void {
  const places: number[][] = [];
  const bodies: PhysicsNode[] = [];
  world.add('CollisionCollection', { collidables: '*', enabled: false });
  for (let i = 0; i < joints; i++) {
    const [parent, position] = shapes[shape]!(i, joints);
    places.push(position);
    const body = world.add('RigidBody', { position, geometry: [{ type: 'Sphere', radius: 0.2 }] });
    bodies.push(body);
    if (!jointed) continue;
    world.add('BallJoint', {
      body1: body,
      ...(parent >= 0 && { body2: bodies[parent] }),
      anchorPoint: parent >= 0 ? places[parent] : [position[0]! - 1, position[1]!, position[2]!],
    });
  }
}

async function made(
  shape: string,
  joints: number,
  accuracy: LevelName,
  jointed: boolean,
): Promise<World> {
  const world = new World();
  world.add('RigidBodyCollection', { accuracy, rest: 'never' });
  build(world, shape, joints, jointed);
  world.start(await loadEngine());
  world.step(2 * TURN);
  return world;
}

const median = (values: number[]): number => [...values].sort((a, b) => a - b)[values.length >> 1]!;

/** Microseconds of one step of Bullet alone. */
function bulletStep(world: World): number {
  const { bullet } = world.bullet;
  const start = performance.now();
  for (let i = 0; i < TURN; i++) bullet.stepSimulation(world.timeStep, 0);
  return ((performance.now() - start) * 1000) / TURN;
}

/** Microseconds that the solve takes of one step. */
function solveStep(world: World): number {
  const { joints } = world.registry;
  let spent = 0;
  for (let i = 0; i < TURN; i++) {
    const before = performance.now();
    joints.beforeStep(world.timeStep);
    spent += performance.now() - before;
    world.bullet.bullet.stepSimulation(world.timeStep, 0);
  }
  return (spent * 1000) / TURN;
}

export async function costOf(shape: string, joints: number, level: LevelName): Promise<Cost> {
  const [ours, raw, loose] = [
    await made(shape, joints, level, true),
    await made(shape, joints, level, true),
    await made(shape, joints, level, false),
  ];
  const turns = Array.from({ length: TURNS }, () => {
    const solve = solveStep(ours) / joints;
    const bullet = (bulletStep(raw) - bulletStep(loose)) / joints;
    return { solve, bullet, ratio: solve / bullet };
  });
  for (const world of [ours, raw, loose]) world.destroy();
  return {
    shape,
    level,
    joints,
    solve: Math.min(...turns.map(({ solve }) => solve)),
    bullet: Math.min(...turns.map(({ bullet }) => bullet)),
    ratio: median(turns.map(({ ratio }) => ratio)),
  };
}

export async function costs(): Promise<Cost[]> {
  const all: Cost[] = [];
  await costOf('chain', 100, 'standard');
  for (const shape of Object.keys(shapes))
    for (const joints of [10, 30, 100, 300, 1000])
      all.push(await costOf(shape, joints, 'standard'));
  for (const level of ['game', 'fine', 'precise', 'reference'] as const)
    all.push(await costOf('chain', 100, level));
  return all;
}
