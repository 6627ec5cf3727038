/** Rates of change of a state. */
export type Derivative = (state: readonly number[]) => number[];

const moved = (state: readonly number[], rate: readonly number[], h: number): number[] =>
  state.map((x, i) => x + h * rate[i]!);

/** One step of Runge and Kutta, fourth order. */
export function step(state: readonly number[], h: number, derivative: Derivative): number[] {
  const k1 = derivative(state);
  const k2 = derivative(moved(state, k1, h / 2));
  const k3 = derivative(moved(state, k2, h / 2));
  const k4 = derivative(moved(state, k3, h));
  return state.map((x, i) => x + (h / 6) * (k1[i]! + 2 * k2[i]! + 2 * k3[i]! + k4[i]!));
}

/** The states each 1/60 s from `start` on, worked out as they are asked for; `perFrame` steps in 1/60 s. */
export function follow(
  start: readonly number[],
  derivative: Derivative,
  perFrame: number,
): (frame: number) => readonly number[] {
  const states = [start];
  return (frame) => {
    while (states.length <= frame) {
      let state = states.at(-1)!;
      for (let i = 0; i < perFrame; i++) state = step(state, 1 / 60 / perFrame, derivative);
      states.push(state);
    }
    return states[frame]!;
  };
}
