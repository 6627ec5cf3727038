import {
  Lattice,
  type LatticeSettings,
} from '../../../../physics-core/solver/deformables/lattice.js';
import type { Vec3 } from '../../helpers.js';
import { boxMesh, type Mesh } from './helpers.js';

/** kg/m³, Pa: a soft foam. */
export const DENSITY = 100;
export const E = 1e5;

export const solid = (mesh: Mesh, mass: number, more: Partial<LatticeSettings> = {}): Lattice =>
  new Lattice(mesh.points, mesh.index, { mass, youngsModulus: E, poissonsRatio: 0.3, ...more });

export const box = (size: Readonly<Vec3>, more: Partial<LatticeSettings> = {}): Lattice =>
  solid(boxMesh(size), DENSITY * size[0] * size[1] * size[2], more);

/** Flings points about, and each in another direction: `size` is metres, or m/s. */
export const shake = (numbers: Float64Array, size: number): void => {
  for (let j = 0, seed = 1; j < numbers.length; j++) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    numbers[j]! += size * (seed / 2 ** 31 - 1);
  }
};
