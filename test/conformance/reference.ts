/** A state and its rate of change. */
export type Rate = (state: number[]) => number[];

/** One step of Runge and Kutta's fourth-order method, in double precision. */
function rk4(rate: Rate, y: number[], h: number): number[] {
  const at = (k: number[], by: number): number[] => y.map((value, i) => value + k[i]! * by);
  const k1 = rate(y);
  const k2 = rate(at(k1, h / 2));
  const k3 = rate(at(k2, h / 2));
  const k4 = rate(at(k3, h));
  return y.map((value, i) => value + (h / 6) * (k1[i]! + 2 * k2[i]! + 2 * k3[i]! + k4[i]!));
}

function integrate(rate: Rate, start: number[], seconds: number, steps: number): number[] {
  let state = start;
  for (let i = 0; i < steps; i++) state = rk4(rate, state, seconds / steps);
  return state;
}

/** Far below any tolerance of a fact. */
const AGREED = 1e-7;

/** The state after `seconds`. Halving the step must not change it, or it is no reference. */
export function solve(rate: Rate, start: number[], seconds: number): number[] {
  const steps = Math.ceil(seconds * 1000);
  const [once, twice] = [1, 2].map((n) => integrate(rate, start, seconds, steps * n)) as [
    number[],
    number[],
  ];
  const worst = Math.max(...once.map((value, i) => Math.abs(value - twice[i]!)));
  if (!(worst < AGREED)) throw new Error(`the reference is off by ${worst}`);
  return twice;
}

/** A pendulum of 1 kg with its centre `l` metres from the pivot: angle from hanging, and its rate. */
export const pendulum =
  (l: number, moment: number, g = 9.8): Rate =>
  ([angle, rate]) => [rate!, (-g * l * Math.sin(angle!)) / (l * l + moment)];

/** Two such pendulums of a metre, the second hung on the centre of the first: both angles, then both rates. */
export const doublePendulum =
  (moment: number, g = 9.8): Rate =>
  ([a, b, u, v]) => {
    const [cos, sin] = [Math.cos(a! - b!), Math.sin(a! - b!)];
    // [2 + I, cos; cos, 1 + I] (u', v') = (p, q)
    const p = -v! * v! * sin - 2 * g * Math.sin(a!);
    const q = u! * u! * sin - g * Math.sin(b!);
    const determinant = (2 + moment) * (1 + moment) - cos * cos;
    return [
      u!,
      v!,
      ((1 + moment) * p - cos * q) / determinant,
      ((2 + moment) * q - cos * p) / determinant,
    ];
  };
