import { follow } from './runge-kutta.js';

/**
 * A chain of straight links that hangs on a fixed ball joint, in double precision: the truth that solvers are measured
 * by. A link is a direction u in space; it turns across itself only, which is all that ball joints in its line (or
 * hinges, in a plane) make it do while its inertia is round about that line.
 */
export interface Chain {
  /** Metres from joint to joint, and from the upper joint to the centre of mass. */
  link: number;
  centre: number;
  /** By link: kilograms, and kg·m² about the centre of mass across the link. */
  masses: readonly number[];
  moments: readonly number[];
  /** m/s², along -y. */
  gravity: number;
}

/** Σ m aᵀa + I: the same along x, y and z, and the same for ever. */
function inertia({ link, centre, masses, moments }: Chain): number[][] {
  const arm = (k: number, i: number): number => (i < k ? link : i === k ? centre : 0);
  return masses.map((_, i) =>
    masses.map((_, j) =>
      masses.reduce((sum, m, k) => sum + m * arm(k, i) * arm(k, j), i === j ? moments[i]! : 0),
    ),
  );
}

/** By Gauss without pivots: all matrices here are positive definite. `a` and `b` are used up. */
function solve(a: number[][], b: number[]): number[] {
  const n = b.length;
  for (let i = 0; i < n; i++) {
    for (let r = i + 1; r < n; r++) {
      const factor = a[r]![i]! / a[i]![i]!;
      for (let c = i; c < n; c++) a[r]![c]! -= factor * a[i]![c]!;
      b[r]! -= factor * b[i]!;
    }
  }
  for (let i = n - 1; i >= 0; i--) {
    for (let c = i + 1; c < n; c++) b[i]! -= a[i]![c]! * b[c]!;
    b[i]! /= a[i]![i]!;
  }
  return b;
}

type Numbers = readonly number[];

const dot = (a: Numbers, i: number, b: Numbers, j: number): number =>
  a[3 * i]! * b[3 * j]! + a[3 * i + 1]! * b[3 * j + 1]! + a[3 * i + 2]! * b[3 * j + 2]!;

/** The second derivative of all u: free fall, and along each u what keeps it of length 1. */
function accelerator(chain: Chain): (u: Numbers, v: Numbers) => number[] {
  const { masses, link, centre, gravity } = chain;
  const n = masses.length;
  const columns = masses.map((_, j) =>
    solve(
      inertia(chain),
      masses.map((_, i) => +(i === j)),
    ),
  );
  const below = masses.map(
    (m, i) => m * centre + link * masses.slice(i + 1).reduce((a, b) => a + b, 0),
  );
  const fall = masses.map(
    (_, i) => -gravity * below.reduce((sum, m, j) => sum + columns[j]![i]! * m, 0),
  );
  return (u, v) => {
    const pull = solve(
      masses.map((_, i) => masses.map((_, j) => columns[j]![i]! * dot(u, i, u, j))),
      masses.map((_, i) => -dot(v, i, v, i) - fall[i]! * u[3 * i + 1]!),
    );
    const a: number[] = new Array<number>(3 * n).fill(0);
    for (let i = 0; i < n; i++) {
      a[3 * i + 1] = fall[i]!;
      for (let j = 0; j < n; j++)
        for (let x = 0; x < 3; x++) a[3 * i + x]! += columns[j]![i]! * pull[j]! * u[3 * j + x]!;
    }
    return a;
  };
}

/**
 * The end of the last link, from the first joint, each 1/60 s up to `seconds`. Released along x, each link turning to
 * the side (z) at `push` rad/s; `perFrame` steps in 1/60 s.
 */
export function chainEnd(chain: Chain, seconds: number, perFrame: number, push = 0): number[][] {
  const numbers = 3 * chain.masses.length;
  const acceleration = accelerator(chain);
  // Where links point, and behind it how fast that turns: three numbers each.
  const start = new Array<number>(2 * numbers).fill(0);
  for (let i = 0; i < numbers; i += 3) [start[i], start[numbers + i + 2]] = [1, push];
  const states = follow(
    start,
    (state) => {
      const [u, v] = [state.slice(0, numbers), state.slice(numbers)];
      return [...v, ...acceleration(u, v)];
    },
    perFrame,
  );
  return Array.from({ length: Math.round(60 * seconds) + 1 }, (_, frame) =>
    [0, 1, 2].map((x) => {
      let sum = 0;
      for (let i = x; i < numbers; i += 3) sum += chain.link * states(frame)[i]!;
      return sum;
    }),
  );
}
