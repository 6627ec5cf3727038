import { jointSolve } from '../../physics-core/inside.js';
import { loadEngine } from '../../physics-core/create.js';
import { World, type LevelName, type PhysicsNode } from '../../physics-core/inside.js';
import { bulletAlone, leaveJointsToBullet } from '../engines/ours.js';
import { median } from '../run/median.js';

/** Steps that one world takes before the next has its turn, and turns of each. */
const TURN = 20;
const TURNS = 25;

/** What one joint costs in one step: microseconds in the least disturbed turn. */
export interface Cost {
  shape: string;
  level: LevelName;
  joints: number;
  /** All that the solve does, before Bullet's step and after it. */
  solve: number;
  /** What Bullet's step takes longer, for its own rows of the same joints, than the same bodies without joints. */
  bullet: number;
  /** Of the two, median over the turns. */
  ratio: number;
  /** A whole step with the solve against one with Bullet's rows alone, median over the turns. */
  total: number;
}

type Shape = (i: number, joints: number) => [parent: number, at: number[]];

const chain: Shape = (i) => [i - 1, [i, 0, 0]];

/** The body that a joint holds body `i` by, and where it hangs: trees of one joint per body. */
const shapes: Record<string, Shape> = {
  chain,
  star: (i, joints) => {
    const angle = (2 * Math.PI * i) / joints;
    const far = Math.max(3, joints / 10);
    return [i ? 0 : -1, i ? [far * Math.cos(angle), 0, far * Math.sin(angle)] : [0, 0, 0]];
  },
  comb: (i) => [i % 2 ? i - 1 : i - 2, [Math.floor(i / 2), -(i % 2), 0]],
  'chain of hinges': chain,
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
    const hinges = shape === 'chain of hinges';
    world.add(hinges ? 'SingleAxisHingeJoint' : 'BallJoint', {
      ...(hinges && { axis: [0, 0, 1] }),
      body1: body,
      ...(parent >= 0 && { body2: bodies[parent] }),
      anchorPoint: parent >= 0 ? places[parent] : [position[0]! - 1, position[1]!, position[2]!],
    });
  }
}

/** `solve`: otherwise Bullet's own rows hold the joints. */
async function made(
  shape: string,
  joints: number,
  accuracy: LevelName,
  jointed: boolean,
  solve: boolean,
): Promise<World> {
  const world = new World();
  world.add('RigidBodyCollection', { accuracy, rest: 'never' });
  if (!solve) leaveJointsToBullet(world);
  build(world, shape, joints, jointed);
  world.start(await loadEngine());
  world.step(2 * TURN);
  return world;
}

/** Microseconds of one step. */
function timeOf(step: () => void): number {
  const start = performance.now();
  for (let i = 0; i < TURN; i++) step();
  return ((performance.now() - start) * 1000) / TURN;
}

/** Microseconds of one step of ours, and those that the solve takes of it. */
function ourStep(world: World): { whole: number; solve: number } {
  const joints = world.registry.get(jointSolve);
  const start = performance.now();
  let spent = 0;
  for (let i = 0; i < TURN; i++) {
    const before = performance.now();
    joints.beforeStep(world.timeStep);
    const between = performance.now();
    world.bullet.bullet.stepSimulation(world.timeStep, 0);
    const after = performance.now();
    joints.settle(world.timeStep);
    spent += between - before + performance.now() - after;
  }
  return { whole: ((performance.now() - start) * 1000) / TURN, solve: (spent * 1000) / TURN };
}

export async function costOf(shape: string, joints: number, level: LevelName): Promise<Cost> {
  const [ours, raw, loose] = [
    await made(shape, joints, level, true, true),
    await made(shape, joints, level, true, false),
    await made(shape, joints, level, false, false),
  ];
  const [rows, nothing] = [bulletAlone(raw), bulletAlone(loose)];
  const turns = Array.from({ length: TURNS }, () => {
    const { whole, solve } = ourStep(ours);
    const [alone, without] = [timeOf(rows), timeOf(nothing)];
    return { solve, alone, without, ratio: solve / (alone - without), total: whole / alone };
  });
  for (const world of [ours, raw, loose]) world.destroy();
  const least = (of: 'solve' | 'alone' | 'without') => Math.min(...turns.map((turn) => turn[of]));
  return {
    shape,
    level,
    joints,
    solve: least('solve') / joints,
    bullet: (least('alone') - least('without')) / joints,
    ratio: median(turns.map(({ ratio }) => ratio)),
    total: median(turns.map(({ total }) => total)),
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
