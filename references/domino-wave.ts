import { step } from './runge-kutta.js';

/** Dominoes of so many metres in a row, of even mass; they do not slip on the floor. */
export interface DominoRow {
  height: number;
  thickness: number;
  /** Between two that stand. */
  gap: number;
  /** Of one domino on the next. */
  friction: number;
  gravity: number;
}

/** How one leans on the next, which has tipped so far, and what its angle does when that one's changes. */
function leaning({ height, thickness, gap, friction }: DominoRow, next: number) {
  const pitch = gap + thickness;
  const more = Math.asin((pitch * Math.cos(next) - thickness) / height);
  const along = height * Math.cos(more);
  const slope = (-pitch * Math.sin(next)) / along;
  const bend = (-pitch * (Math.cos(next) + Math.sin(next) * Math.tan(more) * slope)) / along;
  // Arms of the force between them: about the next one's foot, and about its own.
  const arm = along - pitch * Math.sin(next) - friction * thickness;
  const ownArm = along + friction * height * Math.sin(more);
  return { more, rate: 1 + slope, rateOfRate: bend, share: arm / ownArm };
}

/** Of all that lean on the first: inertia, torque, and what the square of its rate takes from its acceleration; per mass. */
function train(row: DominoRow, first: number, behind: number) {
  const { height, thickness, gravity } = row;
  const moment = (height ** 2 + thickness ** 2) / 3;
  let [angle, rate, rateOfRate, weight] = [first, 1, 0, 1];
  const sums = { inertia: 0, torque: 0, drag: 0 };
  for (let i = 0; i <= behind; i++) {
    const tip = height * Math.sin(angle) - thickness * Math.cos(angle);
    sums.inertia += weight * moment * rate;
    sums.torque += (weight * gravity * tip) / 2;
    sums.drag += weight * moment * rateOfRate;
    const next = leaning(row, angle);
    rateOfRate = next.rateOfRate * rate ** 2 + next.rate * rateOfRate;
    rate *= next.rate;
    weight *= next.share;
    angle += next.more;
  }
  return { ...sums, moment };
}

const STEPS = 200;

/** From upright until it hits the next: its rate then, and the seconds. */
function fall(row: DominoRow, rate: number, behind: number, steps: number) {
  const hits = Math.asin(row.gap / row.height);
  let state: readonly number[] = [0, rate ** 2, 0];
  for (let i = 0; i < steps; i++)
    state = step(state, hits / steps, ([angle, square]) => {
      const { inertia, torque, drag } = train(row, angle!, behind);
      return [1, (2 * (torque - drag * square!)) / inertia, 1 / Math.sqrt(square!)];
    });
  const [, square, seconds] = state;
  return { rate: Math.sqrt(square!), seconds: seconds! };
}

/** The rate of the one that was hit: those behind stay in touch with it. */
function hit(row: DominoRow, rate: number, behind: number): number {
  const { inertia, moment } = train(row, Math.asin(row.gap / row.height), behind);
  const { share, rate: passed } = leaning(row, 0);
  return (inertia * rate) / (inertia * passed + moment / share);
}

/** More behind it change nothing. */
const BEHIND = 40;

/**
 * Metres a second of the wave, when it has found its speed; after J. M. J. van Leeuwen, The domino effect, American Journal of
 * Physics 78, 721 (2010): each leans on the next from the hit on, and their friction acts.
 */
export function dominoSpeed(row: DominoRow, steps = STEPS): number {
  let [rate, seconds] = [2, 0];
  for (let fallen = 0; fallen < 2 * BEHIND; fallen++) {
    const behind = Math.min(fallen, BEHIND);
    ({ rate, seconds } = fall(row, rate, behind, steps));
    rate = hit(row, rate, behind);
  }
  return (row.gap + row.thickness) / seconds;
}
