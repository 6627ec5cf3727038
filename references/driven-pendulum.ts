import { follow } from './runge-kutta.js';

/** A bob on a rigid arm, its pivot moved to and fro: `way` (1 - cos(`rate` t)) after t seconds. */
export interface DrivenPendulum {
  /** From the pivot to the centre of mass, metres. */
  arm: number;
  /** About the pivot, per mass, m². */
  moment: number;
  /** Metres. */
  way: number;
  gravity: number;
  /** Across or up, x by default. */
  along?: 'x' | 'y';
  /** rad/s, a whole turn in a second by default. */
  rate?: number;
  /** Radians from straight below, 0 by default; let go at rest. */
  start?: number;
}

const TURN = 2 * Math.PI;

export const pivotAt = ({ way, rate = TURN }: DrivenPendulum, time: number): number =>
  way * (1 - Math.cos(rate * time));

/** Its angle from straight below each 1/60 s. */
export function drivenPendulum(pendulum: DrivenPendulum, perFrame: number) {
  const { arm, moment, way, gravity, along = 'x', rate = TURN, start = 0 } = pendulum;
  const states = follow(
    [0, start, 0],
    ([time, angle, turning]) => {
      const pull = way * rate ** 2 * Math.cos(rate * time!);
      const [across, down] = along === 'x' ? [pull, gravity] : [0, gravity + pull];
      const sped = -(down * Math.sin(angle!) + across * Math.cos(angle!)) * (arm / moment);
      return [1, turning!, sped];
    },
    perFrame,
  );
  return (frame: number): number => states(frame)[1]!;
}
