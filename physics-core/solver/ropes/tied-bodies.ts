import { grown } from '../../base/grown.js';
import { SIDE } from '../joints/blocks.js';
import type { JoinedBodies } from './joined-bodies.js';

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
  /** Those of them that joints hold, too. */
  joined: readonly JoinedBodies[] = [];

  /** Those that joints hold together with it in this step; undefined: it counts by itself. */
  with(body: number): JoinedBodies | undefined {
    for (const each of this.joined) if (each.has(body)) return each;
    return undefined;
  }

  resize(count: number, joined: readonly JoinedBodies[] = []): void {
    this.count = count;
    this.joined = joined;
    for (const each of joined) each.resize(count);
    if (this.momenta.length >= SIDE * count) return;
    this.inertias = grown(this.inertias, 2 * BLOCK * count);
    this.momenta = grown(this.momenta, 2 * SIDE * count);
    this.velocities = grown(this.velocities, 2 * SIDE * count);
  }
}
