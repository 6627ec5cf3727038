import { dot3 } from './flat-math.js';

const one = new Float64Array(3);
const two = new Float64Array(3);
const off = new Float64Array(3);

const within = (share: number): number => (share > 0 ? (share < 1 ? share : 1) : 0);

/**
 * Where two segments, from a point at `a` to one at `b` and from `c` to `d`, are nearest: their shares of the ways there, to
 * `out` (Ericson, Real-Time Collision Detection, 5.1.9). Where they are parallel any of those places.
 */
export function nearestOnSegments(
  p: Float64Array,
  a: number,
  b: number,
  q: Float64Array,
  c: number,
  d: number,
  out: Float64Array,
): void {
  for (let k = 0; k < 3; k++) {
    one[k] = p[b + k]! - p[a + k]!;
    two[k] = q[d + k]! - q[c + k]!;
    off[k] = p[a + k]! - q[c + k]!;
  }
  const aa = dot3(one, 0, one, 0);
  const bb = dot3(two, 0, two, 0);
  const ab = dot3(one, 0, two, 0);
  const ao = dot3(one, 0, off, 0);
  const bo = dot3(two, 0, off, 0);
  const crossed = aa * bb - ab * ab;
  let s = crossed > 0 ? within((ab * bo - ao * bb) / crossed) : 0;
  const t = bb > 0 ? within((ab * s + bo) / bb) : 0;
  s = aa > 0 ? within((ab * t - ao) / aa) : 0;
  out[0] = s;
  out[1] = t;
}
