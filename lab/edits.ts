// npm run lab:edits: whether one edit costs the same in a scene of 1000 bodies as in one of 10, interleaved in one run.
//   --rounds <n>   edits of each kind in each scene (400)
import { parseArgs } from 'node:util';
import { createWorld, type PhysicsNode, type World } from '../physics-core/inside.js';
import type { BodyNode } from '../physics-core/nodes/body/body.js';
import { median } from './run/median.js';

const { values: options } = parseArgs({
  options: { rounds: { type: 'string', default: '400' } },
});
const ROUNDS = Number(options.rounds);
const SIZES = [10, 1000] as const;
/** Edits that are timed as one, since a clock of microseconds sees no single one. */
const BATCH = 5;

const BOX = { type: 'Box', size: [0.5, 0.5, 0.5] };

interface Scene {
  world: World;
  body: BodyNode;
  /** As many more on the ground as are timed at once. */
  lying: BodyNode[];
  /** Is fixed; a box lies on it. */
  stone: BodyNode;
  shape: PhysicsNode;
  joint: PhysicsNode;
}

/** Boxes on the ground, every fourth with another on a joint above it; and what is edited, which lies on the ground, too. */
async function scene(bodies: number, rest: 'auto' | 'never'): Promise<Scene> {
  const world = await createWorld({ rest });
  world.add('RigidBody', {
    fixed: true,
    position: [0, -0.5, 0],
    geometry: [{ type: 'Box', size: [500, 1, 500] }],
  });
  for (let i = 0; i < bodies; i++) pile(world, i);
  const shape = world.add('CollidableShape', { shape: [BOX] });
  const body = world.add('RigidBody', { position: [-3, 0.25, 0], geometry: [shape] }) as BodyNode;
  const arm = world.add('RigidBody', { position: [-5, 5, 0], geometry: [BOX] });
  const joint = world.add('BallJoint', { body1: arm, anchorPoint: [-5, 6, 0] });
  const lying = Array.from(
    { length: BATCH },
    (_, i) => world.add('RigidBody', { position: [-8 - i, 0.25, 0], geometry: [BOX] }) as BodyNode,
  );
  const stone = world.add('RigidBody', {
    fixed: true,
    position: [-15, 0.25, 0],
    geometry: [BOX],
  }) as BodyNode;
  world.add('RigidBody', { position: [-15, 0.75, 0], geometry: [BOX] });
  world.advance(0.5);
  return { world, body, lying, stone, shape, joint };
}

function pile(world: World, i: number): void {
  const [x, z] = [(i % 25) * 3, Math.floor(i / 25) * 3];
  const hangs = i % 4 === 3;
  const body1 = world.add('RigidBody', { position: [x, hangs ? 5 : 0.25, z], geometry: [BOX] });
  if (hangs) world.add('BallJoint', { body1, anchorPoint: [x + 0.5, 6, z] });
}

/** Each does another edit every time. */
const EDITS: Record<string, (scene: Scene, i: number) => void> = {
  'mass, in place': ({ body }, i) => body.set('mass', 1 + (i % 7)),
  'position, a jump': ({ body }, i) => body.set('position', [-3, 0.25 + (i % 7) / 100, 0]),
  'a size, another shape': ({ shape }, i) =>
    shape.set('shape', [{ type: 'Box', size: [0.5, 0.5 + (i % 7) / 100, 0.5] }]),
  'an anchor, the joint anew': ({ joint }, i) =>
    joint.set('anchorPoint', [-5, 6 + (i % 7) / 100, 0]),
  'a body added and removed': ({ world }) => {
    const body = world.add('RigidBody', { position: [-20, 0.25, 0], geometry: [BOX] });
    world.step(0);
    body.remove();
  },
  'position of a fixed body, a jump': ({ stone }, i) =>
    stone.teleport([-15, 0.25 - (i % 7) / 100, 0]),
  'a fixed body added and removed': ({ world }) => {
    const body = world.add('RigidBody', { fixed: true, position: [-20, 0.25, 0], geometry: [BOX] });
    world.step(0);
    body.remove();
  },
  'position, a jump of who was put to sleep': ({ lying }, i) => {
    lying[0]!.sleep();
    lying[0]!.set('position', [-8, 0.25 + (i % 7) / 100, 0]);
  },
};

/** In a world at rest: it is timed by itself, and then everything comes to rest again. */
const OUT_OF_REST = 'position, a jump out of rest';
const REST = 3;
const RESTED_ROUNDS = ROUNDS / 10;

function timedOutOfRest({ world, lying }: Scene, round: number): number {
  world.advance(REST);
  if (lying.some(({ sleeping }) => !sleeping)) throw new Error('a box does not rest');
  const start = performance.now();
  for (const [i, body] of lying.entries()) {
    body.set('position', [-8 - i, 0.25 + (round % 7) / 100, 0]);
    world.step(0);
  }
  return (performance.now() - start) / BATCH;
}

/** Milliseconds of some edits and of their way to Bullet. */
function timed(at: Scene, edit: (scene: Scene, i: number) => void, round: number): number {
  const start = performance.now();
  for (let i = 0; i < BATCH; i++) {
    edit(at, round * BATCH + i);
    at.world.step(0);
  }
  return (performance.now() - start) / BATCH;
}

type Time = (scene: Scene, round: number) => number;

function row(name: string, scenes: readonly Scene[], rounds: number, time: Time): string[] {
  const times: number[][] = scenes.map(() => []);
  for (let round = 0; round < rounds; round++)
    for (const [i, at] of scenes.entries()) times[i]!.push(time(at, round));
  const medians = times.map(median);
  const micro = medians.map((ms) => (ms * 1000).toFixed(1));
  return [name, ...micro, (medians[1]! / medians[0]!).toFixed(2)];
}

const scenes = await Promise.all(SIZES.map((size) => scene(size, 'never')));
const rested = await Promise.all(SIZES.map((size) => scene(size, 'auto')));
const rows = [
  ...Object.entries(EDITS).map(([name, edit]) =>
    row(name, scenes, ROUNDS, (at, round) => timed(at, edit, round)),
  ),
  row(OUT_OF_REST, rested, RESTED_ROUNDS, timedOutOfRest),
];

console.log('microseconds of one edit, medians of interleaved rounds\n');
console.log(`| edit | ${SIZES.map((size) => `${size} bodies`).join(' | ')} | ratio |`);
console.log('| --- | ---: | ---: | ---: |');
for (const cells of rows) console.log(`| ${cells.join(' | ')} |`);
