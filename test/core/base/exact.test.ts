import assert from 'node:assert/strict';
import {
  atan2,
  cos,
  exp,
  hypot,
  lengthOf,
  log,
  sin,
} from '../../../physics-core/base/exact/index.js';
import { asin } from '../../../physics-core/base/exact/asin.js';
import { expm1 } from '../../../physics-core/base/exact/expm1.js';
import { below, fact } from '../helpers.js';
import { EXACT_BITS, exactBits } from './exact-bits.js';

const numbers = Array.from({ length: 2001 }, (_, i) => (i - 1000) * 0.0137);
/** Two doubles side by side. */
const ULPS = 2 * 2 ** -52;

/** The largest difference, of the value; near zero of the argument's own rounding. */
const apart = (f: (x: number) => number, g: (x: number) => number, of = numbers): number =>
  Math.max(...of.map((x) => Math.abs(f(x) - g(x)) / Math.max(Math.abs(g(x)), 1e-3)));

fact('sines, arcs, exponentials and lengths have the bits that they have everywhere', () => {
  assert.equal(exactBits(), EXACT_BITS);
});

fact('they are those of the platform to the last digits', () => {
  const shares = numbers.map((x) => x / 13.8);
  const sizes = numbers.map(Math.abs).filter((x) => x > 0);
  below(apart(sin, Math.sin), ULPS, 'of the sine');
  below(apart(cos, Math.cos), ULPS, 'of the cosine');
  below(apart(asin, Math.asin, shares), ULPS, 'of the arc');
  below(apart(exp, Math.exp), ULPS, 'of the exponential');
  below(apart(expm1, Math.expm1), ULPS, 'of what it is beyond one');
  below(apart(log, Math.log, sizes), ULPS, 'of the logarithm');
  for (const y of [-3, 0, 1e-9, 7]) {
    const length = (x: number) => Math.hypot(x, y);
    below(
      apart(
        (x) => atan2(y, x),
        (x) => Math.atan2(y, x),
      ),
      ULPS,
      'of the turn',
    );
    below(
      apart((x) => hypot(x, y), length),
      ULPS,
      'of the length',
    );
    below(
      apart((x) => hypot(x, y, 0), length),
      ULPS,
      'of the length',
    );
    below(
      apart((x) => lengthOf([x, 0, y, 0]), length),
      ULPS,
      'of the length',
    );
  }
});

fact('what has no number, no end or no sign stays so', () => {
  for (const f of [sin, cos, asin, exp, expm1, log]) assert.equal(f(NaN), NaN);
  assert.equal(exp(Infinity), Infinity);
  assert.equal(exp(-Infinity), 0);
  assert.equal(log(0), -Infinity);
  assert.equal(log(-1), NaN);
  assert.equal(asin(2), NaN);
  assert.equal(hypot(0, -Infinity), Infinity);
  assert.equal(lengthOf([]), 0);
  assert.ok(Object.is(sin(-0), -0));
  assert.equal(atan2(0, -1), Math.PI);
  assert.equal(atan2(-0, -1), -Math.PI);
});

fact('angles of a million radians have their sine', () => {
  below(Math.abs(sin(1e6) - -0.3499935021712929), 1e-15, '');
  below(Math.abs(cos(1e6) - 0.9367521275331447), 1e-15, '');
});
