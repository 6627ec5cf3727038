import { applyInertia, multiply4, writeTurn } from '../../base/flat-math.js';
import type { Body } from '../../dynamics/body.js';
import type { Gyroscopic } from '../flight/gyroscopic.js';
import { turnFreely } from '../flight/top.js';

const orientation = new Float64Array(4);
const turn = new Float64Array(4);
const change = new Float64Array(3);
const spin = new Float64Array(3);

/**
 * Where a body is turned to by the end of a step in which contacts pushed it evenly: as if all of that were one blow in the
 * middle, with free motion before and after it; of what begins to turn, after it alone. Undefined: that is not known. `velocity`: six numbers, what was found.
 */
export function turnedEvenly(
  spins: Gyroscopic,
  body: Body,
  velocity: Float64Array,
  dt: number,
  begins: boolean,
): Float64Array | undefined {
  const state = spins.spinOf(body);
  if (!state?.slow) return undefined;
  state.even = true;
  const { from, axes, momentum, given, displaced } = state;
  const top = spins.topOf(body);
  orientation.set(from);
  if (!begins) turnFreely(orientation, top, momentum, dt / 2);
  for (let i = 0; i < 3; i++) spin[i] = velocity[3 + i]! - given[i]!;
  applyInertia(change, 0, axes, body.mass.moments, spin, 0);
  for (let i = 0; i < 3; i++) change[i]! += momentum[i]!;
  turnFreely(orientation, top, change, dt / 2);
  writeTurn(turn, displaced, 1);
  multiply4(orientation, turn, 0, orientation, 0);
  return orientation;
}
