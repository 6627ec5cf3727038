import { cross, normalize, perpendicular } from '../../../../physics-core/base/math.js';
import { C, ConeContacts } from '../../../../physics-core/solver/rows/cone-contacts.js';
import {
  SIZE,
  type SparseCholesky,
} from '../../../../physics-core/solver/matrix/block-cholesky.js';
import { random, type Vec3 } from '../../helpers.js';

// Any contacts, and matrices in full.

export const next = random(11);
export const some = (): number => 2 * next() - 1;
export const vector = (): Vec3 => [some(), some(), some()];

export const minus = (a: Vec3, b: Vec3): Vec3 => a.map((value, i) => value - b[i]!) as Vec3;

/** Three numbers of a contact. */
export const three = (c: Float64Array, from: number): Vec3 => [
  c[from]!,
  c[from + 1]!,
  c[from + 2]!,
];

/** A contact of bodies `a` and `b` with any directions, arms, friction, impulse and miss. */
export function anyContact(a = 0, b = 1): { contacts: ConeContacts; c: Float64Array; at: number } {
  const contacts = new ConeContacts();
  const at = contacts.add(0, a, b);
  const c = contacts.values;
  const normal = normalize(vector());
  const first = perpendicular(normal);
  const all = { normal, direction1: first, direction2: cross(normal, first) };
  for (const [name, value] of Object.entries(all)) c.set(value, at + C[name as 'normal']);
  c.set(vector(), at + C.armA);
  c.set(vector(), at + C.armB);
  c.set(vector(), at + C.impulse);
  c.set(vector(), at + C.miss);
  c.set(vector(), at + C.change);
  c[at + C.friction] = 0.2 + next();
  c[at + C.penalty] = 1 + next();
  c[at + C.lift] = 0.1 * next();
  return { contacts, c, at };
}

/** The matrix as it stands, full; `pairs` are the blocks off its diagonal. */
export function fullOf(
  matrix: SparseCholesky,
  bodies: number,
  pairs: readonly [number, number][],
): number[][] {
  const n = SIZE * bodies;
  const full = Array.from({ length: n }, () => new Array<number>(n).fill(0));
  const put = (i: number, k: number, from: number): void => {
    for (let r = 0; r < SIZE; r++)
      // Of blocks on the diagonal only the lower half is written.
      for (let s = 0; s < (i === k ? r + 1 : SIZE); s++) {
        const value = matrix.values[from + r * SIZE + s]!;
        full[SIZE * i + r]![SIZE * k + s] = value;
        full[SIZE * k + s]![SIZE * i + r] = value;
      }
  };
  for (let i = 0; i < bodies; i++) put(i, i, matrix.diagonal(i));
  for (const [a, b] of pairs) {
    const between = matrix.between(a, b);
    if (between >= 0) put(a, b, between);
    else put(b, a, -1 - between);
  }
  return full;
}
