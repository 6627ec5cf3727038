import { compose7, dot3 } from '../../base/flat-math.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import type { Flat } from '../../shapes/cut/cut.js';
import { SIX } from './six.js';

const pose = new Float64Array(POSE);

type Numbers = ArrayLike<number>;

/** A body's centre of mass and principal axes, and how it moves as seen from there. */
export class BodyFrame {
  /** Of the centre of mass, in the author's world, metres. */
  readonly centre: Flat = new Float64Array(3);
  /** Of its own axes: velocity, m/s, and spin, rad/s. */
  readonly velocity: Flat = new Float64Array(SIX);
  readonly #rows = new Float64Array(MATRIX);

  /** As it is, but for being where it goes in `ahead` seconds. */
  take({ slot, centerOfMass }: Body, { poses, bodies }: Simulation, ahead: number): void {
    const { velocities } = bodies;
    const at = slot * VELOCITY;
    compose7(pose, 0, poses.current, slot * POSE, centerOfMass);
    writeMatrix(this.#rows, 0, pose, 3);
    for (let k = 0; k < 3; k++)
      this.centre[k] = pose[k]! + poses.origin[k]! + velocities[at + k]! * ahead;
    this.inward(velocities, at, this.velocity, 0);
    this.inward(velocities, at + 3, this.velocity, 3);
  }

  /** Of the world, in the body's axes. */
  inward(from: Numbers, at: number, out: Flat, to: number): void {
    const r = this.#rows;
    for (let k = 0; k < 3; k++)
      out[to + k] = r[k]! * from[at]! + r[3 + k]! * from[at + 1]! + r[6 + k]! * from[at + 2]!;
  }

  /** Of the body's axes, in the world. */
  outward(from: Flat, at: number, out: Flat, to: number): void {
    for (let k = 0; k < 3; k++) out[to + k] = dot3(this.#rows, 3 * k, from, at);
  }
}
