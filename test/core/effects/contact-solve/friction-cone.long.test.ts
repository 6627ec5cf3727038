import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dot, length } from '../../../../physics-core/base/math.js';
import {
  C,
  OPEN,
  project,
  SLIDES,
  STICKS,
  stiffnessOf,
} from '../../../../physics-core/solver/rows/cone-contacts.js';
import { above, below, type Vec3 } from '../../helpers.js';
import { anyContact, minus, next, three, vector } from '../../solver/rows/contacts.js';

// What a contact pushes: the nearest point of its friction cone, and how it answers speeds.

const STATES = ['open', 'sticks', 'slides'] as const;

/** What a contact would push at a miss that has changed by s, if it could pull and rub as it liked. */
const wanted = (c: Float64Array, at: number, s: number): Vec3 =>
  [0, 1, 2].map(
    (k) =>
      c[at + C.impulse + k]! -
      c[at + C.penalty]! *
        (c[at + C.miss + k]! + s * c[at + C.change + k]! + (k === 0 ? c[at + C.lift]! : 0)),
  ) as Vec3;

const pushed = (c: Float64Array, at: number): Vec3 => three(c, at + C.pushed);

/** A point of the cone n ≥ 0, √(t² + u²) ≤ μ n. */
function inCone(friction: number, size: number): Vec3 {
  const n = size * next();
  const r = friction * n * Math.sqrt(next());
  const angle = 2 * Math.PI * next();
  return [n, r * Math.cos(angle), r * Math.sin(angle)];
}

void test('what a contact pushes is the nearest point of the friction cone, in each of its states', () => {
  const seen = [0, 0, 0];
  for (let i = 0; i < 600; i++) {
    const { c, at } = anyContact();
    const s = next();
    project(c, at, s);
    seen[c[at + C.state]!]!++;
    const p = pushed(c, at);
    const w = wanted(c, at, s);
    const friction = c[at + C.friction]!;
    below(Math.hypot(p[1], p[2]), friction * p[0] + 1e-12, 'within the cone');
    // Of a convex set p is the nearest point if and only if (w − p)·(q − p) ≤ 0 for all of its points q.
    const off = minus(w, p);
    below(Math.abs(dot(off, p)), 1e-12, 'a cone: at right angles to the push');
    for (let k = 0; k < 40; k++) {
      const q = inCone(friction, 2 * length(w));
      below(dot(off, minus(q, p)), 1e-12, 'no point is nearer');
      above(length(minus(w, q)), length(off) - 1e-12, 'm, of any other');
    }
  }
  STATES.forEach((name, state) => above(seen[state]!, 10, name));
});

void test('what only lifts pushes nothing, what only presses sticks, and on ice nothing rubs', () => {
  const { c, at } = anyContact();
  c.fill(0, at + C.impulse, at + C.lift + 1);
  c[at + C.miss] = 1;
  project(c, at, 0);
  assert.equal(c[at + C.state], OPEN);
  assert.deepEqual(pushed(c, at), [0, 0, 0]);
  c[at + C.miss] = -1;
  project(c, at, 0);
  assert.equal(c[at + C.state], STICKS);
  assert.deepEqual(
    pushed(c, at),
    [c[at + C.penalty]!, 0, 0].map((x) => x + 0),
  );
  c[at + C.friction] = 0;
  c[at + C.miss + 1] = 3;
  project(c, at, 0);
  assert.equal(c[at + C.state], SLIDES);
  assert.deepEqual(pushed(c, at).map(Math.abs), [c[at + C.penalty]!, 0, 0]);
});

void test('the stiffness of a contact is the derivative of its push by the speeds, in each of its states', () => {
  const seen = [0, 0, 0];
  const w = new Float64Array(9);
  for (let i = 0; i < 300; i++) {
    const { c, at } = anyContact();
    project(c, at, 0);
    const state = c[at + C.state]!;
    seen[state]!++;
    const answers = stiffnessOf(c, at, w);
    assert.equal(answers, state !== OPEN);
    if (!answers) w.fill(0);
    const d = [0, 1, 2].map((k) => three(c, at + 3 * k));
    const direction = vector();
    // Speeds along the three directions of a motion of A against B.
    d.forEach((axis, k) => (c[at + C.change + k] = dot(axis, direction)));
    const h = 1e-6;
    project(c, at, h);
    const more = pushed(c, at);
    project(c, at, -h);
    const less = pushed(c, at);
    for (let x = 0; x < 3; x++) {
      let by = 0;
      d.forEach((axis, k) => (by += (axis[x]! * (more[k]! - less[k]!)) / (2 * h)));
      let found = 0;
      for (let y = 0; y < 3; y++) found -= w[3 * x + y]! * direction[y]!;
      below(Math.abs(by - found), 1e-5, STATES[state]);
    }
  }
  STATES.forEach((name, state) => above(seen[state]!, 10, name));
});
