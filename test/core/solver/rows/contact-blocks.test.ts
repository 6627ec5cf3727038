import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cross, dot, length } from '../../../../physics-core/base/math.js';
import { C, speeds, takePush } from '../../../../physics-core/solver/rows/cone-contacts.js';
import {
  addContact,
  PLACES,
  placesOf,
} from '../../../../physics-core/solver/rows/contact-blocks.js';
import { SparseCholesky } from '../../../../physics-core/solver/matrix/block-cholesky.js';
import { below, type Vec3 } from '../../helpers.js';
import { anyContact, fullOf, minus, some, three } from './contacts.js';

// Speeds, pushes and blocks of a contact against its Jacobian, in full.

/** J: the speed of A against B at the contact, world frame, for velocities of both, 3 × 12. */
function jacobian(c: Float64Array, at: number): number[][] {
  const rows = [0, 1, 2].map(() => new Array<number>(12).fill(0));
  for (const [body, arm, sign] of [
    [0, C.armA, 1],
    [1, C.armB, -1],
  ] as const) {
    const r = three(c, at + arm);
    for (let k = 0; k < 3; k++) {
      const unit = [0, 1, 2].map((x) => +(x === k)) as Vec3;
      rows[k]![6 * body + k] = sign;
      cross(unit, r).forEach((value, x) => (rows[x]![6 * body + 3 + k] = sign * value));
    }
  }
  return rows;
}

void test('a push is the transpose of speeds, and its wrenches on both bodies have no sum about any point', () => {
  for (let i = 0; i < 50; i++) {
    const { c, at } = anyContact();
    const v = Float64Array.from({ length: 12 }, some);
    speeds(c, at, v, 0, 1, C.miss);
    const J = jacobian(c, at);
    const against = J.map((row) => row.reduce((sum, value, k) => sum + value * v[k]!, 0)) as Vec3;
    for (let k = 0; k < 3; k++)
      below(Math.abs(c[at + C.miss + k]! - dot(three(c, at + 3 * k), against)), 1e-14);
    const g = new Float64Array(12);
    takePush(c, at, g, 0, 1, C.impulse, 2);
    const power = g.reduce((sum, value, k) => sum + value * v[k]!, 0);
    const expected = dot(three(c, at + C.impulse), three(c, at + C.miss));
    below(Math.abs(power + 2 * expected), 1e-13, 'W');
    for (let k = 0; k < 3; k++) below(Math.abs(g[k]! + g[6 + k]!), 1e-15, 'N s');
    // About the point of contact, which is at armA from one centre and at armB from the other.
    const about = (body: number, arm: number): Vec3 => {
      const force = three(g, 6 * body);
      const turned = cross(three(c, at + arm), force);
      return minus(three(g, 6 * body + 3), turned);
    };
    below(length(about(0, C.armA)), 1e-14, 'N m s');
    below(length(about(1, C.armB)), 1e-14, 'N m s');
  }
});

void test('the blocks of a contact are Jᵀ W J, whichever of its bodies comes first, or moves', () => {
  for (const [p, q] of [
    [0, 1],
    [1, 0],
    [0, -1],
    [-1, 1],
  ] as const) {
    const { c, at } = anyContact();
    const W = new Float64Array(9);
    for (let i = 0; i < 3; i++) for (let k = 0; k <= i; k++) W[3 * i + k] = W[3 * k + i] = some();
    const matrix = new SparseCholesky();
    matrix.begin(2);
    matrix.connect(0, 1);
    assert.ok(matrix.analyse(1000));
    matrix.clear();
    const places = new Int32Array(PLACES);
    placesOf(matrix, p, q, places, 0);
    addContact(matrix.values, W, c, at, places, 0);
    const full = fullOf(matrix, 2, [[0, 1]]);
    const J = jacobian(c, at);
    const numbers = [p, q];
    for (let i = 0; i < 12; i++)
      for (let k = 0; k < 12; k++) {
        const [x, y] = [numbers[Math.floor(i / 6)]!, numbers[Math.floor(k / 6)]!];
        if (x < 0 || y < 0) continue;
        let expected = 0;
        for (let r = 0; r < 3; r++)
          for (let s = 0; s < 3; s++) expected += J[r]![i]! * W[3 * r + s]! * J[s]![k]!;
        below(Math.abs(full[6 * x + (i % 6)]![6 * y + (k % 6)]! - expected), 1e-13);
      }
  }
});
