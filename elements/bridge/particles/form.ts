import type { Seen } from './seen.js';

/** What each particle is drawn as. */
export interface Form {
  primitive: 'TRIANGLES' | 'LINES' | 'POINTS';
  /** Points of one particle. */
  corners: number;
  index: ArrayLike<number>;
  normals: ArrayLike<number>;
  texCoords: ArrayLike<number>;
  /** How far it reaches from where it is, in what x3dom draws. */
  reach: number;
  /** What faces who looks is turned to them, its normals too; `view`: their right, up and back. */
  turn?(view: Float64Array): void;
  /** Writes the corners of all particles, in the order in which they are drawn. */
  write(seen: Seen, out: Float32Array): void;
}
