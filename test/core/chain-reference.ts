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

/** Where links point, and how fast that turns: three numbers each. */
interface State {
  u: Float64Array;
  v: Float64Array;
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

const dot = (a: Float64Array, i: number, b: Float64Array, j: number): number =>
  a[3 * i]! * b[3 * j]! + a[3 * i + 1]! * b[3 * j + 1]! + a[3 * i + 2]! * b[3 * j + 2]!;

/** The second derivative of all u: free fall, and along each u what keeps it of length 1. */
function accelerator(chain: Chain): (state: State) => Float64Array {
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
  return ({ u, v }) => {
    const pull = solve(
      masses.map((_, i) => masses.map((_, j) => columns[j]![i]! * dot(u, i, u, j))),
      masses.map((_, i) => -dot(v, i, v, i) - fall[i]! * u[3 * i + 1]!),
    );
    const a = new Float64Array(3 * n);
    for (let i = 0; i < n; i++) {
      a[3 * i + 1] = fall[i]!;
      for (let j = 0; j < n; j++)
        for (let x = 0; x < 3; x++) a[3 * i + x]! += columns[j]![i]! * pull[j]! * u[3 * j + x]!;
    }
    return a;
  };
}

const moved = (a: Float64Array, b: Float64Array, h: number): Float64Array =>
  a.map((x, i) => x + h * b[i]!);

/** One step of Runge and Kutta. */
function step({ u, v }: State, h: number, acceleration: (state: State) => Float64Array): State {
  const a1 = acceleration({ u, v });
  const v2 = moved(v, a1, h / 2);
  const a2 = acceleration({ u: moved(u, v, h / 2), v: v2 });
  const v3 = moved(v, a2, h / 2);
  const a3 = acceleration({ u: moved(u, v2, h / 2), v: v3 });
  const v4 = moved(v, a3, h);
  const a4 = acceleration({ u: moved(u, v3, h), v: v4 });
  return {
    u: u.map((x, i) => x + (h / 6) * (v[i]! + 2 * v2[i]! + 2 * v3[i]! + v4[i]!)),
    v: v.map((x, i) => x + (h / 6) * (a1[i]! + 2 * a2[i]! + 2 * a3[i]! + a4[i]!)),
  };
}

/**
 * The end of the last link, from the first joint, each 1/60 s up to `seconds`. Released along x, each link turning to
 * the side (z) at `push` rad/s; `perFrame` steps in 1/60 s.
 */
export function chainEnd(chain: Chain, seconds: number, perFrame: number, push = 0): number[][] {
  const n = chain.masses.length;
  const acceleration = accelerator(chain);
  let state: State = { u: new Float64Array(3 * n), v: new Float64Array(3 * n) };
  for (let i = 0; i < n; i++) [state.u[3 * i], state.v[3 * i + 2]] = [1, push];
  const ends: number[][] = [];
  for (let frame = 0; frame <= Math.round(60 * seconds); frame++) {
    if (frame)
      for (let k = 0; k < perFrame; k++) state = step(state, 1 / 60 / perFrame, acceleration);
    ends.push(
      [0, 1, 2].map((x) => {
        let sum = 0;
        for (let i = 0; i < n; i++) sum += chain.link * state.u[3 * i + x]!;
        return sum;
      }),
    );
  }
  return ends;
}
