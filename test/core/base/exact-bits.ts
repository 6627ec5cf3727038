import { atan2, cos, exp, hypot, log, sin } from '../../../physics-core/base/exact/index.js';
import { asin } from '../../../physics-core/base/exact/asin.js';
import { expm1 } from '../../../physics-core/base/exact/expm1.js';

const SIZES = [1e-9, 1e-4, 0.1, 1, 3, 10, 60, 700, 1e4];

/** Numbers of all sizes, the same in every run. */
function* numbers(count: number): Generator<number> {
  let state = 1;
  for (let i = 0; i < count; i++) {
    state = (state * 16807) % 2147483647;
    yield (state / 2147483647 - 0.5) * SIZES[i % SIZES.length]!;
  }
}

/** FNV-1a over the bytes of what each function makes of them. */
export function exactBits(): string {
  const values: number[] = [];
  let before = 1;
  for (const x of numbers(20_000)) {
    const small = x % 1;
    values.push(sin(x), cos(x), asin(small), atan2(x, before), exp(small), exp(x % 700));
    values.push(expm1(small), log(Math.abs(x)), hypot(x, before), hypot(x, before, small));
    before = x;
  }
  let hash = 0x811c9dc5;
  for (const byte of new Uint8Array(new Float64Array(values).buffer))
    hash = Math.imul(hash ^ byte, 0x01000193);
  return (hash >>> 0).toString(16);
}

/** What it is everywhere. */
export const EXACT_BITS = '9caeb3d3';
