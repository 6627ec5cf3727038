// Jacobi's elliptic functions by arithmetic-geometric means: to the last digits of double precision, whatever the modulus.

interface Means {
  /** The arithmetic means, the last one the limit. */
  a: number[];
  /** Half the differences that they came from; the first is the modulus. */
  c: number[];
}

/** The means of 1 and √(1 - k²). */
function meansOf(modulus: number): Means {
  const [a, c] = [[1], [modulus]];
  for (let b = Math.sqrt(1 - modulus ** 2); Math.abs(c.at(-1)!) > 1e-16;) {
    const last = a.at(-1)!;
    a.push((last + b) / 2);
    c.push((last - b) / 2);
    b = Math.sqrt(last * b);
  }
  return { a, c };
}

/** K(k): where sn first is 1. */
export const quarterPeriod = (modulus: number): number => Math.PI / 2 / meansOf(modulus).a.at(-1)!;

/** sn(u, k), a sine whose period is 4 K(k). */
export function sn(u: number, modulus: number): number {
  const { a, c } = meansOf(modulus);
  let angle = 2 ** (a.length - 1) * a.at(-1)! * u;
  for (let n = a.length - 1; n > 0; n--)
    angle = (angle + Math.asin((c[n]! / a[n]!) * Math.sin(angle))) / 2;
  return Math.sin(angle);
}

/** The angle from straight below of what swings at `rate` when it swings little, let go at rest at `start`. */
export function pendulumAngle(start: number, rate: number): (time: number) => number {
  const modulus = Math.sin(start / 2);
  const quarter = quarterPeriod(modulus);
  return (time) => 2 * Math.asin(modulus * sn(quarter + rate * time, modulus));
}
