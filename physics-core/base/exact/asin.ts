// After fdlibm's e_asin.c: see index.ts.
import { EIGHTH, QUARTER, QUARTER_LEFT } from './arcs.js';
import { SIZE, fromWords, high } from './words.js';

/** (asin √t − √t) / √t³, times t. */
function asinShare(t: number): number {
  const p =
    t *
    (1.66666666666666657415e-1 +
      t *
        (-3.25565818622400915405e-1 +
          t *
            (2.01212532134862925881e-1 +
              t *
                (-4.00555345006794114027e-2 +
                  t * (7.91534994289814532176e-4 + t * 3.4793310759602116757e-5)))));
  const q =
    1 +
    t *
      (-2.40339491173441421878 +
        t *
          (2.02094576023350569471 +
            t * (-6.8828397160545329303e-1 + t * 7.70381505559019352791e-2)));
  return p / q;
}

export function asin(x: number): number {
  const word = high(x) & SIZE;
  if (Math.abs(x) > 1 || x !== x) return NaN;
  if (word === 0x3ff00000) return x * QUARTER + x * QUARTER_LEFT;
  if (word < 0x3e400000) return x;
  if (word < 0x3fe00000) return x + x * asinShare(x * x);
  const t = (1 - Math.abs(x)) * 0.5;
  const share = asinShare(t);
  const root = Math.sqrt(t);
  if (word >= 0x3fef3333) {
    const near = QUARTER - (2 * (root + root * share) - QUARTER_LEFT);
    return x > 0 ? near : -near;
  }
  const head = fromWords(high(root), 0);
  const left = (t - head * head) / (root + head);
  const p = 2 * root * share - (QUARTER_LEFT - 2 * left);
  const angle = EIGHTH - (p - (EIGHTH - 2 * head));
  return x > 0 ? angle : -angle;
}
