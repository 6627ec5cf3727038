import type { Draws } from './draws.js';

/** What a particle is born with: x y z, metres; vx vy vz, m/s; in the frame of its system. */
export const BIRTH = 6;

/** A law by which particles are born. */
export interface Emitter {
  /** Writes what one is born with, by the numbers that are drawn for it. FALSE: none is, since there is nowhere to be born. */
  emit(draws: Draws, birth: Float64Array): boolean;
}

/** What all emitters say of their particles. */
export interface Speeds {
  /** m/s. */
  speed: number;
  /** By which share of it speeds are more or less, evenly spread; none below 0. */
  variation: number;
}
