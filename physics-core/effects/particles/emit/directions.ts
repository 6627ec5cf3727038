import { lengthOf } from '../../../base/exact/index.js';
import type { Vec3 } from '../../../fields/types.js';
import { Cap } from './cap.js';
import type { Draws } from './draws.js';
import { BIRTH, type Speeds } from './emitter.js';

/** Where the velocity stands in a birth. */
const VELOCITY = BIRTH / 2;

/** Writes a unit direction where a birth has its velocity. */
export type Direction = (draws: Draws, birth: Float64Array) => void;

const ANY = new Cap();

/** All directions alike. */
export const randomDirection: Direction = (draws, birth) => ANY.draw(draws, birth, VELOCITY);

/** Of length 1, however long or short; undefined for 0 0 0. */
export function unitOf(direction: Vec3): Vec3 | undefined {
  const most = Math.max(...direction.map(Math.abs));
  if (most === 0) return undefined;
  const ratios = direction.map((value) => value / most);
  const size = lengthOf(ratios);
  return ratios.map((value) => value / size) as Vec3;
}

/** Always the same one; with 0 0 0 X3D means another for each particle. */
export function directionOf(direction: Vec3): Direction {
  const unit = unitOf(direction);
  if (!unit) return randomDirection;
  return (_, birth) => {
    for (let k = 0; k < 3; k++) birth[VELOCITY + k] = unit[k]!;
  };
}

/**
 * All directions within `angle` of an axis alike, radians; beyond a half turn there are no others. An axis of 0 0 0 is any,
 * so that all directions are.
 */
export function capDirection(axis: Vec3, angle: number): Direction {
  const unit = unitOf(axis);
  if (!unit) return randomDirection;
  const cap = new Cap().take(...unit, Math.min(Math.max(angle, 0), Math.PI));
  return (draws, birth) => cap.draw(draws, birth, VELOCITY);
}

/** Makes a velocity, m/s, of the direction that a birth has. */
export function giveSpeed(draws: Draws, { speed, variation }: Speeds, birth: Float64Array): void {
  const drawn = Math.max(0, speed * (1 + variation * draws.either()));
  for (let i = VELOCITY; i < BIRTH; i++) birth[i]! *= drawn;
}
