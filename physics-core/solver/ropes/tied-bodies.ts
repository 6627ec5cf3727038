import { grown } from '../../base/grown.js';
import { SIDE } from '../joints/blocks.js';

const BLOCK = SIDE * SIDE;

/** The bodies that ropes are tied to, in a step: six numbers each, linear, then angular. */
export class TiedBodies {
  count = 0;
  /** What resists a change of their velocities: full blocks. */
  inertias = new Float64Array(0);
  /** What they have if no rope pulls, N s and N m s. */
  momenta = new Float64Array(0);
  /** As found. */
  velocities = new Float64Array(0);

  resize(count: number): void {
    this.count = count;
    if (this.momenta.length >= SIDE * count) return;
    this.inertias = grown(this.inertias, 2 * BLOCK * count);
    this.momenta = grown(this.momenta, 2 * SIDE * count);
    this.velocities = grown(this.velocities, 2 * SIDE * count);
  }
}
