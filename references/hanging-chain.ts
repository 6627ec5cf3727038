import type { Vec3 } from '../physics-core/fields/types.js';

// A chain of equal straight links without any thickness, each half of its mass at either of its ends: how it hangs and swings.

/** Of so many equal links, each half to either of its ends, kg. */
export const chainMasses = (links: number, mass: number): number[] =>
  Array.from({ length: links + 1 }, (_, i) => ((i % links ? 1 : 0.5) * mass) / links);

/** The slowest swing of one that hangs by its end: the square of its rate, 1/s², and its shape, 1 at the lower end. */
export function slowestSwing(
  links: number,
  length: number,
  gravity: number,
): { square: number; shape: number[] } {
  const weights = chainMasses(links, 1).slice(1);
  const bears = weights.map((_, i) => gravity * weights.slice(i).reduce((sum, m) => sum + m));
  let shape = weights.map((_, i) => (i + 1) / links);
  let square = 0;
  for (let n = 0; n < 200; n++) {
    // How it would hang if its own shape pulled it aside.
    let aside = shape.reduce((sum, x, i) => sum + x * weights[i]!, 0);
    let at = 0;
    const next = shape.map((x, i) => {
      at += (aside * length) / links / bears[i]!;
      aside -= x * weights[i]!;
      return at;
    });
    square = 1 / at;
    shape = next.map((x) => x / at);
  }
  return { square, shape };
}

/** Its points from the origin down, as that swing has it at its widest. */
export function swungChain(links: number, length: number, wide: number): Vec3[] {
  // How fast it swings by its weight has no part in its shape.
  const { shape } = slowestSwing(links, length, 1);
  const points: Vec3[] = [[0, 0, 0]];
  shape.forEach((x, i) => {
    const [before, y] = points[i]!;
    points.push([wide * x, y - Math.sqrt((length / links) ** 2 - (wide * x - before) ** 2), 0]);
  });
  return points;
}

/** How far one hangs through between two ends of one height: each link points the way of what it bears. */
export function chainSag(links: number, length: number, span: number): number {
  const link = length / links;
  const hang = (pull: number): [wide: number, deep: number] => {
    let [wide, deep] = [0, 0];
    for (let i = 0.5; i < links / 2; i++) {
      const bears = Math.hypot(pull, i);
      wide += (2 * link * pull) / bears;
      deep += (link * i) / bears;
    }
    return [wide, deep];
  };
  let [low, high] = [0, 1e6];
  for (let n = 0; n < 100; n++) {
    const middle = (low + high) / 2;
    if (hang(middle)[0] < span) low = middle;
    else high = middle;
  }
  return hang(low)[1];
}
