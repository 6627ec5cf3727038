import { follow } from './runge-kutta.js';

/** A board whose upper edge slides down a smooth wall at x = 0 while its lower one slides away on a smooth floor, y = 0. */
export interface SlidingRod {
  /** Metres along the board, and how thick it is; without any thickness it is the rod of the textbooks. */
  length: number;
  thickness: number;
  /** Radians from the wall, let go at rest. */
  start: number;
  gravity: number;
}

/** Its centre and its angle from the wall. */
export interface RodPlace {
  x: number;
  y: number;
  angle: number;
}

/** Of the centre while both edges touch; x = y' and y = x' turned about: one is the other's rate by the angle. */
const centreOf = ({ length, thickness }: SlidingRod, angle: number): [x: number, y: number] => {
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  return [(length * sine + thickness * cosine) / 2, (length * cosine + thickness * sine) / 2];
};

/** Of the centre by the angle. */
const slopesOf = ({ length, thickness }: SlidingRod, angle: number): [x: number, y: number] => {
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  return [(length * cosine - thickness * sine) / 2, (thickness * cosine - length * sine) / 2];
};

/** Angular acceleration, with the wall or without, and what the wall pushes per mass. */
function pushed(rod: SlidingRod, angle: number, rate: number, wall: boolean) {
  const [x, y] = centreOf(rod, angle);
  const [across, down] = slopesOf(rod, angle);
  const moment = (rod.length ** 2 + rod.thickness ** 2) / 12;
  // The second slopes of x and y are -x and -y.
  const inertia = moment + down ** 2 + (wall ? across ** 2 : 0);
  const turning = rate ** 2 * (down * y + (wall ? across * x : 0));
  const sped = (turning - rod.gravity * down) / inertia;
  return { sped, push: wall ? across * sped - x * rate ** 2 : 0 };
}

/** The angle at which the wall has nothing left to push: cos of it is 2/3 of that at the start, of a thin rod. */
export function leavesAt(rod: SlidingRod): number {
  const [, height] = centreOf(rod, rod.start);
  const pushAt = (angle: number): number => {
    const [across, down] = slopesOf(rod, angle);
    const moment = (rod.length ** 2 + rod.thickness ** 2) / 12;
    const fallen = height - centreOf(rod, angle)[1];
    const rate2 = (2 * rod.gravity * fallen) / (moment + across ** 2 + down ** 2);
    return pushed(rod, angle, Math.sqrt(rate2), true).push;
  };
  let [low, high] = [rod.start + 1e-6, Math.PI / 2];
  while (high - low > 1e-15) {
    const middle = (low + high) / 2;
    if (middle === low || middle === high) break;
    if (pushAt(middle) > 0) low = middle;
    else high = middle;
  }
  return low;
}

/** Where it is each 1/60 s until it lies: Lagrange's equations with the wall, then without, in double precision. */
export function slidingRod(rod: SlidingRod, perFrame: number): (frame: number) => RodPlace {
  const leaves = leavesAt(rod);
  const states = follow(
    [rod.start, 0, centreOf(rod, rod.start)[0], 0],
    ([angle, rate, , along]) => {
      // What the wall pushes ends without a jump, so a step across the end is as exact as others.
      const { sped, push } = pushed(rod, angle!, rate!, angle! < leaves);
      return [rate!, sped, along!, push];
    },
    perFrame,
  );
  return (frame) => {
    const [angle, , x] = states(frame);
    return { x: x!, y: centreOf(rod, angle!)[1], angle: angle! };
  };
}
