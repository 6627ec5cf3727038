import type { Masses } from '../../solver/deformables/masses.js';
import type { Surface } from '../../solver/deformables/surface.js';

/** What gives way, and may be in water: a node by its number, which hears of it. */
export interface Matter {
  readonly id: number;
  emit(event: string, detail: unknown): void;
}

/** Points that have mass, as water pushes them. */
export type Points = Pick<Masses, 'count' | 'masses' | 'inverse' | 'places' | 'velocities'>;

/** A surface of points that have mass. */
export interface WetSurface {
  readonly masses: Masses;
  readonly hull: Surface;
  /** Where outside is: 1, where its triangles look to; -1, behind them; 0: it encloses nothing, and both sides are. */
  readonly side: number;
  /** m³ as laid, of what is solid within; undefined: it is hollow, or encloses nothing. */
  readonly solid: number | undefined;
  /** Metres, of what encloses nothing. */
  readonly thickness: number;
}

/** A line of points with links between them. */
export interface WetLine {
  readonly points: Points;
  /** Of each link, metres. */
  readonly lengths: Float64Array;
  /** Metres. */
  readonly radius: number;
}
