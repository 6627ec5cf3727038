/** Of each corner: the mean over the triangle of how deep it is, times the corner's share, metres; and the share that is below. */
export const DIP = { depth: 0, share: 3 } as const;
export const DIPS = 6;

/**
 * What of a triangle lies below a plane, by how deep its corners are, metres (negative: above). Depth and shares of corners go
 * evenly from corner to corner, so these are the integrals themselves: all of it together is the weight of the water above
 * it, and no moment is lost. Adds `factor` times that.
 */
export function addDip(a: number, b: number, c: number, factor: number, out: Float64Array): void {
  const below = +(a > 0) + +(b > 0) + +(c > 0);
  if (below === 0) return;
  if (below >= 2) {
    const sum = a + b + c;
    out[0]! += (factor * (sum + a)) / 12;
    out[1]! += (factor * (sum + b)) / 12;
    out[2]! += (factor * (sum + c)) / 12;
    for (let k = 3; k < DIPS; k++) out[k]! += factor / 3;
    if (below === 3) return;
  }
  // One corner is alone on its side: that much more than all of it, or by itself.
  const sign = below === 1 ? 1 : -1;
  const alone = a > 0 === b > 0 ? 2 : a > 0 === c > 0 ? 1 : 0;
  if (alone === 0) addCorner(a, b, c, 0, 1, 2, sign, factor, out);
  else if (alone === 1) addCorner(b, c, a, 1, 2, 0, sign, factor, out);
  else addCorner(c, a, b, 2, 0, 1, sign, factor, out);
}

/** Of the piece at a corner, between it and where both its sides go through the plane. */
function addCorner(
  p: number,
  q: number,
  r: number,
  i: number,
  j: number,
  m: number,
  sign: number,
  factor: number,
  out: Float64Array,
): void {
  const t = p / (p - q);
  const s = p / (p - r);
  const area = factor * t * s;
  // What is above counts against a mean that has it as below.
  const deep = (area * sign * p) / 12;
  out[i]! += deep * (4 - t - s);
  out[j]! += deep * t;
  out[m]! += deep * s;
  const share = (area * sign) / 3;
  out[3 + i]! += share * (3 - t - s);
  out[3 + j]! += share * t;
  out[3 + m]! += share * s;
}
