import { cos, sin } from '../../../../physics-core/base/exact/index.js';
import type { Masses } from '../../../../physics-core/solver/deformables/masses.js';
import type { Material } from '../../../../physics-core/solver/deformables/material.js';
import type { Vec3 } from '../../helpers.js';

/** A closed surface: its points, and three of them for each triangle, outward. */
export interface Mesh {
  points: number[];
  index: number[];
}

/** A box whose least corner lies at the origin. */
export function boxMesh([x, y, z]: Readonly<Vec3>): Mesh {
  const points = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((c) => [x * (c & 1), y * ((c >> 1) & 1), z * (c >> 2)]); // prettier-ignore
  const faces = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5];
  const index: number[] = [];
  for (let f = 0; f < 24; f += 4) {
    const [a, b, c, d] = faces.slice(f, f + 4) as [number, number, number, number];
    index.push(a, b, c, a, c, d);
  }
  return { points, index };
}

/** The same with each face divided into squares, `cells` along each side; points along edges are laid twice, and thrice. */
export function fineBoxMesh(size: Readonly<Vec3>, cells: number): Mesh {
  const points: number[] = [];
  const index: number[] = [];
  for (let axis = 0; axis < 3; axis++)
    for (const end of [0, 1]) {
      const u = (axis + 1) % 3;
      const v = (axis + 2) % 3;
      const first = points.length / 3;
      for (let j = 0; j <= cells; j++)
        for (let i = 0; i <= cells; i++) {
          const point: Vec3 = [0, 0, 0];
          point[axis] = end * size[axis]!;
          point[u] = (i / cells) * size[u]!;
          point[v] = (j / cells) * size[v]!;
          points.push(...point);
        }
      for (let j = 0; j < cells; j++)
        for (let i = 0; i < cells; i++) {
          const a = first + j * (cells + 1) + i;
          const corners = [a, a + 1, a + cells + 2, a + cells + 1] as const;
          const [b, c, d] = end
            ? [corners[1], corners[2], corners[3]]
            : [corners[3], corners[2], corners[1]];
          index.push(a, b, c, a, c, d);
        }
    }
  return { points, index };
}

/** A ball of triangles that are nearly alike: an octahedron's, each divided into four, `rounds` times. */
export function ballMesh(radius: number, rounds: number): Mesh {
  let points: Vec3[] = [
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
    [0, -1, 0],
    [0, 0, 1],
    [0, 0, -1],
  ];
  let index = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
  for (let round = 0; round < rounds; round++) {
    const middles = new Map<string, number>();
    const middle = (a: number, b: number): number => {
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      if (!middles.has(key)) {
        const sum = points[a]!.map((p, k) => p + points[b]![k]!);
        const length = Math.sqrt(sum.reduce((square, p) => square + p * p, 0));
        middles.set(key, points.length);
        points = [...points, sum.map((p) => p / length) as Vec3];
      }
      return middles.get(key)!;
    };
    const finer: number[] = [];
    for (let t = 0; t < index.length; t += 3) {
      const [a, b, c] = index.slice(t, t + 3) as Vec3;
      const ab = middle(a, b);
      const bc = middle(b, c);
      const ca = middle(c, a);
      finer.push(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca);
    }
    index = finer;
  }
  return { points: points.flat().map((p) => radius * p), index };
}

/** Steps that a material's own parts are long, with what falls and what brakes. */
export class Run {
  readonly material: Material;
  readonly masses: Masses;
  readonly rest: Float64Array;
  time = 0;
  /** Seconds. */
  private readonly length: number;
  private readonly hold: () => void;

  /** `hold` acts on velocities before points go. */
  constructor(material: Material, hold: () => void = () => {}) {
    this.material = material;
    this.masses = material.masses;
    this.rest = material.masses.places.slice();
    this.length = 1 / material.parts(1);
    this.hold = hold;
  }

  /** So many parts more: with m/s² in each direction, and braking that takes a share of all velocities, 1/s. */
  part(count = 1, gravity: Readonly<Vec3> = [0, 0, 0], braking = 0): this {
    const { places, velocities, inverse } = this.masses;
    const h = this.length;
    for (let n = 0; n < count; n++) {
      this.material.push(h);
      for (let j = 0; j < velocities.length; j++) {
        if (inverse[Math.floor(j / 3)]! > 0) velocities[j]! += h * gravity[j % 3]!;
        velocities[j]! /= 1 + h * braking;
      }
      this.hold();
      for (let j = 0; j < velocities.length; j++) places[j]! += h * velocities[j]!;
      this.time += h;
    }
    return this;
  }

  /** Goes on for `seconds`, or a little longer. */
  go(seconds: number, gravity: Readonly<Vec3> = [0, 0, 0], braking = 0): this {
    return this.part(Math.ceil(seconds / this.length), gravity, braking);
  }

  /** Until nothing moves: braked as what swings `seconds` to and fro wants, for ten times that. */
  settle(seconds: number, gravity: Readonly<Vec3> = [0, 0, 0]): this {
    return this.go(10 * seconds, gravity, (4 * Math.PI) / seconds);
  }

  /** Numbers of points whose rest place is at `value` along an axis. */
  at(axis: number, value: number): number[] {
    return Array.from({ length: this.masses.count }, (_, i) => i).filter(
      (i) => Math.abs(this.rest[3 * i + axis]! - value) < 1e-9,
    );
  }

  /** How far points have gone along an axis, on average. */
  gone(points: readonly number[], axis: number): number {
    const sum = points.reduce(
      (all, i) => all + this.masses.places[3 * i + axis]! - this.rest[3 * i + axis]!,
      0,
    );
    return sum / points.length;
  }
}

export const holding = (material: Material, points: readonly number[]): void => {
  for (const i of points) material.masses.inverse[i] = 0;
};

/** N on each point. */
export function forces({ masses }: { masses: Masses }, push: (time: number) => void): Float64Array {
  const kept = masses.velocities.slice();
  masses.velocities.fill(0);
  const time = 1e-9;
  push(time);
  const of = masses.velocities.map((v, j) => (v * masses.masses[Math.floor(j / 3)]!) / time);
  masses.velocities.set(kept);
  return of;
}

/** Gauss's five points between 0 and 1: exact for polynomials up to the ninth degree. */
const GAUSS = [
  [0.046910077030668, 0.118463442528095],
  [0.230765344947158, 0.239314335249683],
  [0.5, 0.284444444444444],
  [0.769234655052842, 0.239314335249683],
  [0.953089922969332, 0.118463442528095],
] as const;

/** J that forces do not give back on the straight way from rest: the energy of a deformation, if they have one. */
export function stored(material: Material, rest: Float64Array): number {
  const { places } = material.masses;
  const now = places.slice();
  let energy = 0;
  for (const [share, weight] of GAUSS) {
    for (let j = 0; j < now.length; j++) places[j] = rest[j]! + share * (now[j]! - rest[j]!);
    const acting = forces(material, (time) => material.push(time));
    for (let j = 0; j < now.length; j++) energy -= weight * acting[j]! * (now[j]! - rest[j]!);
  }
  places.set(now);
  return energy;
}

/** J of motion. */
export const moving = ({ masses, velocities }: Masses): number =>
  velocities.reduce((sum, v, j) => sum + (masses[Math.floor(j / 3)]! * v * v) / 2, 0);

/** kg m/s, and kg m²/s about the origin. */
export function momenta({ masses, places, velocities }: Masses): { along: Vec3; about: Vec3 } {
  const along: Vec3 = [0, 0, 0];
  const about: Vec3 = [0, 0, 0];
  for (let i = 0; i < masses.length; i++)
    for (let k = 0; k < 3; k++) {
      const a = 3 * i + ((k + 1) % 3);
      const b = 3 * i + ((k + 2) % 3);
      along[k]! += masses[i]! * velocities[3 * i + k]!;
      about[k]! += masses[i]! * (places[a]! * velocities[b]! - places[b]! * velocities[a]!);
    }
  return { along, about };
}

/** Turns places about z, then about x. */
export function turn(places: Float64Array, angle: number): void {
  const c = cos(angle);
  const s = sin(angle);
  for (let i = 0; i < places.length; i += 3) {
    const x = places[i]!;
    const y = places[i + 1]!;
    const z = places[i + 2]!;
    const turned = s * x + c * y;
    places[i] = c * x - s * y;
    places[i + 1] = c * turned - s * z;
    places[i + 2] = s * turned + c * z;
  }
}

/** m³ inside a surface. */
export function volumeOf(places: ArrayLike<number>, triangles: ArrayLike<number>): number {
  let six = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((n) => 3 * triangles[t + n]!) as Vec3;
    for (let k = 0; k < 3; k++) {
      const l = (k + 1) % 3;
      const m = (k + 2) % 3;
      six += places[a + k]! * (places[b + l]! * places[c + m]! - places[b + m]! * places[c + l]!);
    }
  }
  return six / 6;
}
