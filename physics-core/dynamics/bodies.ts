import type { MovingBodies } from '../engine/moving-bodies.js';
import type { Body } from './body.js';

/** The built bodies of a simulation, by slot. */
export interface Bodies extends Iterable<Body> {
  /** What passes over all of them ask of each, by slot. */
  readonly moving: MovingBodies;
  /** The author's body in a slot, or what the world stands for a collidable. */
  in(slot: number): Body | undefined;
  /** Of all slots, linear then angular, as they were read last: at the end of the last step, or after an edit. */
  readonly velocities: Float64Array;
  velocityOf(body: Body): Float64Array;
  readVelocity(body: Body): void;
  /** The next step is taken whether bodies move or not: something else does. */
  goOn(): void;
  asleep(body: Body): boolean;
  /** Whether a body's speeds lie below both limits, m/s and rad/s. */
  slower(slot: number, linear: number, angular: number): boolean;
  /** Whether any body that moves is faster, m/s. */
  anyFaster(speed: number): boolean;
}
