import type { Sight, Vec3, Watch } from '../case.js';
import { apart, worst } from './judging.js';

/** Where a body's centre is after so many seconds. */
export type Path = (time: number) => Vec3;

const alongFloor = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[2] - b[2]);

type Paths = Record<string, Path>;

const worstOff =
  (paths: Paths, off: typeof apart) =>
  ({ position }: Sight): Watch =>
    worst((time) =>
      Math.max(...Object.entries(paths).map(([body, path]) => off(position(body), path(time)))),
    );

/** The farthest that any of the named bodies was off its path, metres. */
export const offPaths = (paths: Paths) => worstOff(paths, apart);

/** The same along the floor: how deep an engine lets things lie on it is another matter. */
export const offPathsOnFloor = (paths: Paths) => worstOff(paths, alongFloor);

/** Single precision's last digit of a number of this size. */
const lastDigit = (size: number): number => 2 ** (Math.floor(Math.log2(size)) - 23);

/**
 * What rounding leaves of a place up to `size` metres from the origin after so many seconds: half of the last digit at
 * every step of 1/960 s, by chance this way or that.
 */
export const roundingOf = (size: number, seconds: number): number =>
  (lastDigit(size) / 2) * Math.sqrt(960 * seconds);
