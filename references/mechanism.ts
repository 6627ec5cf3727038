import { follow } from './runge-kutta.js';

/** Bodies that one coordinate moves: the crank of a machine, the angle of a pendulum. */
export interface Mechanism {
  /** Metres and radians that have energy, by the coordinate. */
  places(at: number): number[];
  /** Kilograms or kg m² that move along each. */
  inertias: readonly number[];
  /** Newtons or newton metres that pull along each, at every place. */
  pulls?: readonly number[];
}

/** Radians or metres between the places from which slopes are taken: errors of 1e-12 in `places` (fourth order). */
const BETWEEN = 2e-3;

/** First and second derivatives of all places. */
function slopes({ places }: Mechanism, at: number): { first: number[]; second: number[] } {
  const h = BETWEEN;
  const [a, b, c, d, e] = [-2, -1, 0, 1, 2].map((i) => places(at + i * h)) as number[][];
  return {
    first: c!.map((_, i) => (8 * (d![i]! - b![i]!) - (e![i]! - a![i]!)) / (12 * h)),
    second: c!.map((x, i) => (16 * (b![i]! + d![i]!) - (a![i]! + e![i]!) - 30 * x) / (12 * h * h)),
  };
}

/** The coordinate and its rate each 1/60 s: Lagrange's equation for one coordinate, in double precision. */
export function move(
  mechanism: Mechanism,
  at: number,
  rate: number,
  perFrame = 16,
): (frame: number) => { at: number; rate: number } {
  const { inertias, pulls = [] } = mechanism;
  const states = follow(
    [at, rate],
    ([x, v]) => {
      const { first, second } = slopes(mechanism, x!);
      let [inertia, force] = [0, 0];
      inertias.forEach((m, i) => {
        inertia += m * first[i]! ** 2;
        force += (pulls[i] ?? 0) * first[i]! - m * first[i]! * second[i]! * v! ** 2;
      });
      return [v!, force / inertia];
    },
    perFrame,
  );
  return (frame) => {
    const [x, v] = states(frame);
    return { at: x!, rate: v! };
  };
}
