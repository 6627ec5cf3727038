import type { Vec3 } from './case.js';

export interface Limb {
  size: Vec3;
  at: Vec3;
  /** The limb that it hangs on, and where. */
  on?: number;
  joint?: Vec3;
}

/** A person of ten limbs, metres from the middle of the chest. */
export const LIMBS: readonly Limb[] = [
  { size: [0.36, 0.3, 0.2], at: [0, 0, 0] },
  { size: [0.32, 0.24, 0.2], at: [0, -0.29, 0], on: 0, joint: [0, -0.16, 0] },
  { size: [0.18, 0.22, 0.2], at: [0, 0.29, 0], on: 0, joint: [0, 0.17, 0] },
  { size: [0.26, 0.1, 0.1], at: [0.33, 0.08, 0], on: 0, joint: [0.19, 0.08, 0] },
  { size: [0.26, 0.08, 0.08], at: [0.61, 0.08, 0], on: 3, joint: [0.47, 0.08, 0] },
  { size: [0.26, 0.1, 0.1], at: [-0.33, 0.08, 0], on: 0, joint: [-0.19, 0.08, 0] },
  { size: [0.26, 0.08, 0.08], at: [-0.61, 0.08, 0], on: 5, joint: [-0.47, 0.08, 0] },
  { size: [0.13, 0.4, 0.13], at: [0.1, -0.63, 0], on: 1, joint: [0.1, -0.42, 0] },
  { size: [0.13, 0.4, 0.13], at: [-0.1, -0.63, 0], on: 1, joint: [-0.1, -0.42, 0] },
  { size: [0.1, 0.1, 0.24], at: [0.1, -0.9, 0.05], on: 7, joint: [0.1, -0.84, 0] },
];

/** Water's density. */
export const massOfLimb = ([x, y, z]: Limb['size']): number => 1000 * x * y * z;
