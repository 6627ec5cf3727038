import assert from 'node:assert/strict';
import { test } from 'node:test';
// What pages have no words for comes with it.
import '../../physics-core/index.js';
import { createWorld, type CreateOptions } from '../../physics-core/create.js';
import { type World } from '../../physics-core/inside.js';
import type { BodyNode } from '../../physics-core/nodes/body/body.js';
import type { CollisionSensorNode } from '../../physics-core/nodes/collision/collision-sensor-node.js';
import type { JointNode } from '../../physics-core/nodes/joints/joint.js';
import type { PhysicsNode } from '../../physics-core/nodes/node/node.js';
import type { SingleAxisHingeJointNode } from '../../physics-core/nodes/joints/single-axis-hinge-joint-node.js';
import { contactReader } from '../../physics-core/effects/contacts/effects.js';
import { factsHere } from './thread/facts-here.js';
import { goAwayAtOnce, steppingOf } from './thread/at-once.js';

export type Vec3 = [number, number, number];
export type Body = BodyNode;
export type Node = PhysicsNode;
export type Sensor = CollisionSensorNode;
export type Joint = JointNode;
export type Hinge = SingleAxisHingeJointNode;

// Tests count steps, not milliseconds: a busy machine must not make a frame drop any.
performance.now = () => 0;

/** Whether worlds take their steps on the other side: see thread/at-once.ts. */
const ELSEWHERE = process.env.X3D_ELSEWHERE === 'yes';

// ---- worlds, and the problems they may end with ------------------------------------------------------------------

/** Problems by code that a test claims, and those that came. */
interface Watch {
  claimed: Set<string>;
  came: { code: string; message: string }[];
}

const open = new Map<World, Watch>();

/** A quiet world that never rests, unless `fields` say otherwise. `closeWorlds` ends it. */
export async function world(fields: CreateOptions = {}): Promise<World> {
  const made = await createWorld({ console: false, rest: 'never', ...fields });
  if (ELSEWHERE) goAwayAtOnce(made);
  watch(made);
  return made;
}

/** Fields of a world in which nothing falls. */
export const WEIGHTLESS = { gravity: [0, 0, 0] };

/** For worlds made in another way: their problems count too. */
export function watch(made: World): World {
  const came: Watch['came'] = [...made.problems];
  made.on('problem', (problem) => came.push(problem as Watch['came'][0]));
  open.set(made, { claimed: new Set(), came });
  return made;
}

/** The test expects these problems; any other fails it, and so does one of these that never comes. */
export function claim(made: World, ...codes: string[]): void {
  for (const code of codes) open.get(made)!.claimed.add(code);
}

/** Of the problems that a world has told of. */
export const codes = (of: World): string[] => of.problems.map(({ code }) => code);

/** What was told under a code. */
export const told = (of: World, code: string): string[] =>
  of.problems.filter((problem) => problem.code === code).map(({ message }) => message);

/** A world that has to come back says so. */
const isComingBack = ({ code }: { code: string }): boolean => ELSEWHERE && code === 'thread-main';

/** Ends every open world; with `judge`, throws where problems and claims differ. */
export function closeWorlds(judge = true): void {
  const all = [...open];
  open.clear();
  for (const [made] of all) made.destroy();
  if (!judge) return;
  for (const [, { claimed, came }] of all) {
    for (const { code, message } of came.filter((each) => !isComingBack(each)))
      assert.ok(claimed.has(code), `unexpected problem ${code}: ${message}`);
    for (const code of claimed)
      assert.ok(
        came.some((problem) => problem.code === code),
        `the problem ${code} was claimed but never came`,
      );
  }
}

/** A test whose worlds must end with the problems it claimed. */
export function fact(name: string, run: () => void | Promise<void>): void {
  const skip = ELSEWHERE && factsHere.get(name);
  void test(name, { skip }, async () => {
    let judge = false;
    try {
      await run();
      judge = true;
    } finally {
      closeWorlds(judge);
    }
  });
}

// ---- nodes ---------------------------------------------------------------------------------------------------------

export const box = (...size: number[]) => ({
  type: 'Box',
  size: size.length === 1 ? [size[0], size[0], size[0]] : size,
});
export const sphere = (radius: number) => ({ type: 'Sphere', radius });

export const addBody = (to: World, fields: Record<string, unknown> = {}): Body =>
  to.add('RigidBody', { geometry: [sphere(0.5)], ...fields }) as Body;

/** A fixed slab whose top lies at `top`. */
export const addFloor = (to: World, top = 0, fields: Record<string, unknown> = {}): Body =>
  addBody(to, {
    fixed: true,
    position: [0, top - 0.5, 0],
    geometry: [box(60, 1, 60)],
    ...fields,
  });

export const addJoint = (to: World, type: string, fields: Record<string, unknown>): Hinge =>
  to.add(type, fields) as Hinge;

export const position = (body: Node): Vec3 => body.get('position') as Vec3;
export const velocity = (body: Node): Vec3 => body.get('linearVelocity') as Vec3;
export const spin = (body: Node): Vec3 => body.get('angularVelocity') as Vec3;
export const height = (body: Node): number => position(body)[1];

/** No author can do that: an impulse, N s, that is too much for single precision. Bullet's velocities are infinite then. */
export function overflow({ world: of, id }: Body, impulse: Vec3): void {
  of.flush();
  const stepping = steppingOf(of as World);
  const node = [...stepping.bodies].find((each) => each.id === id)!;
  node.body.applyCentralImpulse(stepping.engine.scratch.vector(...impulse));
  stepping.bodies.readVelocity(node);
}

/** Whether a body touches another, as the events of collisions have it. */
export function isColliding({ world: of, id }: Body): boolean {
  const stepping = steppingOf(of as World);
  const same = [...stepping.bodies].find((each) => each.id === id);
  return !!same && !!stepping.registry.find(contactReader)?.colliding(same);
}

/** Objects made, patched and unmade so far. */
export function counts(of: World): { created: number; patched: number; destroyed: number } {
  of.step(0);
  const { created, patched, destroyed } = of.stats;
  return { created, patched, destroyed };
}

// ---- judging ---------------------------------------------------------------------------------------------------------

/** Within `tolerance`, absolute and in the unit of the values, number by number. */
export function close(
  actual: number | readonly number[],
  expected: number | readonly number[],
  tolerance: number,
  what = '',
): void {
  const list = (value: number | readonly number[]) => (typeof value === 'number' ? [value] : value);
  const [a, e] = [list(actual), list(expected)];
  assert.equal(a.length, e.length, `${what} has ${a.length} numbers, not ${e.length}`);
  const off = e.some((value, i) => !(Math.abs(a[i]! - value) <= tolerance));
  assert.ok(!off, `${what} ${a.join(' ')} is not ${e.join(' ')} within ${tolerance}`);
}

export const below = (actual: number, bound: number, what = ''): void =>
  assert.ok(actual < bound, `${what} ${actual} is not below ${bound}`);
export const above = (actual: number, bound: number, what = ''): void =>
  assert.ok(actual > bound, `${what} ${actual} is not above ${bound}`);

/** Way under a constant acceleration after `t` seconds from rest. */
export const way = (a: number, t: number): number => (a * t * t) / 2;

export const distance = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(...a.map((value, i) => value - b[i]!));

/** The same sequence in every run. */
export function random(seed = 1): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}
