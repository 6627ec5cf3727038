import { FRAME } from '../checks.js';
import type { Driver, NodeData } from '../fact.js';
import { collection } from '../scenes.js';

type Fields = Record<string, unknown>;
export type Vector = number[];

/** Between two meetings particles go by closed forms: what is left of them after single precision, metres. */
export const EXACT = 1e-5;

/** One particle each 0.1 s from the start on, and all of them stay. */
export const FLOW = { maxParticles: 100, particleLifetime: 10 };

/** A thousand in the first second, and all of them stay. */
export const MANY = { maxParticles: 4000, particleLifetime: 4 };

/** How many of those a mean is taken of. */
export const SAMPLE = 1000;

/** How far a mean of so many may be off by chance: four of its standard deviations. `spread`: that of one. */
export const chance = (spread: number, count = SAMPLE): number => (4 * spread) / Math.sqrt(count);

/** Between what is looked at: no multiple of the time from birth to birth. */
export const LOOK = 0.55;

/** A world, and beside it a system of particles that all live equally long. */
export const system = (emitter: NodeData | null, fields: Fields = {}): NodeData[] => [
  collection(),
  {
    type: 'ParticleSystem',
    DEF: 'system',
    lifetimeVariation: 0,
    ...FLOW,
    ...(emitter && { emitter: { DEF: 'emitter', ...emitter } }),
    ...fields,
  },
];

export const point = (fields: Fields = {}): NodeData => ({
  type: 'PointEmitter',
  variation: 0,
  direction: [1, 0, 0],
  ...fields,
});

/** All at once, from rest. */
export const burst = (fields: Fields = {}): NodeData => ({
  type: 'ExplosionEmitter',
  variation: 0,
  ...fields,
});

export const points = (list: readonly number[]): NodeData => ({
  type: 'Coordinate',
  point: [...list],
});

// ---- what is measured ---------------------------------------------------------------------------------------------

/** The oldest first, metres. */
export const places = (x: Driver): Promise<Vector[]> => x.get('system', 'positions');
export const count = (x: Driver): Promise<number> => x.get('system', 'count');
export const isActive = (x: Driver): Promise<boolean> => x.get('system', 'isActive');

export const minus = (a: Vector, b: Vector): Vector => a.map((value, i) => value - b[i]!);
export const lengthOf = (v: Vector): number => Math.hypot(...v);
export const unit = (v: Vector): Vector => v.map((value) => value / lengthOf(v));
export const dot = (a: Vector, b: Vector): number =>
  a.reduce((sum, value, i) => sum + value * b[i]!, 0);

/** The least and the greatest. */
export const ends = (list: readonly number[]): [number, number] => [
  Math.min(...list),
  Math.max(...list),
];

export const mean = (list: readonly number[]): number =>
  list.reduce((sum, value) => sum + value, 0) / list.length;

/** Axis by axis. */
export const middle = (list: readonly Vector[]): Vector =>
  [0, 1, 2].map((i) => mean(list.map((each) => each[i]!)));

export const share = <T>(list: readonly T[], is: (each: T) => boolean): number =>
  list.filter(is).length / list.length;

/** How far the one that is furthest off is. */
export const furthest = (list: readonly Vector[], from: Vector): number =>
  list.length > 0 ? Math.max(...list.map((each) => lengthOf(minus(each, from)))) : NaN;

/** Seconds between two looks at the same particles: none of them may die meanwhile. */
const BETWEEN = 6 * FRAME;

/** How each that is there moves, m/s, where nothing pushes it; it takes a while. */
export async function velocities(x: Driver): Promise<Vector[]> {
  const before = await places(x);
  await x.advance(BETWEEN);
  const after = await places(x);
  return before.map((place, i) => minus(after[i]!, place).map((way) => way / BETWEEN));
}

/** What pushes each that is there, m/s², as long as that is steady. */
export async function pushes(x: Driver): Promise<Vector[]> {
  const before = await places(x);
  const first = await velocities(x);
  const second = await velocities(x);
  return before.map((_, i) => minus(second[i]!, first[i]!).map((change) => change / BETWEEN));
}
