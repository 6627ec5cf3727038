import type { Chain } from './chain.js';

// Chains that the tests and the lab let go.

const GRAVITY = 9.81;

/** Eight balls of 0.1 m and 0.1 kg, 1 m apart, the last `ratio` times as heavy. */
export function ballChain(ratio: number): Chain {
  const masses = Array.from({ length: 8 }, (_, i) => (i === 7 ? 0.1 * ratio : 0.1));
  const moments = masses.map((m) => 0.4 * m * 0.1 ** 2);
  return { link: 1, centre: 1, masses, moments, gravity: GRAVITY };
}

/** `count` boxes of 0.1 kg in a row, hinged end to end, each `link` metres long. */
export function boxChain(count: number, link = 0.1): Chain {
  const masses: number[] = Array<number>(count).fill(0.1);
  const moments = masses.map((m) => (m / 12) * ((0.9 * link) ** 2 + (0.4 * link) ** 2));
  return { link, centre: link / 2, masses, moments, gravity: GRAVITY };
}
