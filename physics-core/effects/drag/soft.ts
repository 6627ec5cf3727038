import type { Body } from '../../dynamics/body.js';
import type { SimulationNode } from '../../dynamics/node.js';
import type { Vec3 } from '../../fields/types.js';

/** Points of mass, three numbers for each: m, m/s; and kg. */
export interface SoftPoints {
  readonly places: Float64Array;
  readonly velocities: Float64Array;
  readonly masses: Float64Array;
}

/** A node that is a rope, a cloth or a soft body, as hands see it. */
export interface Grabbed extends SimulationNode {
  readonly settings: { readonly enabled: boolean };
  /** Where its points are that are seen, metres, flat. */
  readonly places: Float64Array | undefined;
  /** A place that somebody names; undefined: that is none, and told. */
  place(method: string, point: Vec3): Vec3 | undefined;
}

/** What holds them by hand asks of what moves them. */
export interface SoftWorld {
  /** Of what stands in the world now. */
  pointsOf(node: Grabbed): SoftPoints | undefined;
  /** Bodies that are tied to it and move. */
  tiedTo(node: Grabbed): Iterable<Body>;
  /** It does not rest. */
  keepAwake(node: Grabbed): void;
}
