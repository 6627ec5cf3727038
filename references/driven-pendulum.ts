import { follow } from './runge-kutta.js';

/** A bob on a rigid arm, its pivot moved to and fro along x: `way` (1 - cos(2π t)) after t seconds. */
export interface DrivenPendulum {
  /** From the pivot to the centre of mass, metres. */
  arm: number;
  /** About the pivot, per mass, m². */
  moment: number;
  /** Metres. */
  way: number;
  gravity: number;
}

const TURN = 2 * Math.PI;

export const pivotAt = ({ way }: DrivenPendulum, time: number): number =>
  way * (1 - Math.cos(TURN * time));

/** Its angle from straight below each 1/60 s, let go at rest straight below. */
export function drivenPendulum(pendulum: DrivenPendulum, perFrame: number) {
  const { arm, moment, way, gravity } = pendulum;
  const states = follow(
    [0, 0, 0],
    ([time, angle, rate]) => {
      const pull = way * TURN ** 2 * Math.cos(TURN * time!);
      const turning = -(gravity * Math.sin(angle!) + pull * Math.cos(angle!)) * (arm / moment);
      return [1, rate!, turning];
    },
    perFrame,
  );
  return (frame: number): number => states(frame)[1]!;
}
