import type { Sight, Vec3, Watch } from '../case.js';

/** Where a body's centre is after so many seconds. */
export type Path = (time: number) => Vec3;

export const distance = (a: Vec3, b: Vec3): number =>
  Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

const alongFloor = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[2] - b[2]);

type Paths = Record<string, Path>;

const worstOff =
  (paths: Paths, off: typeof distance) =>
  (sight: Sight): Watch => {
    let worst = 0;
    return {
      look(time) {
        for (const [body, path] of Object.entries(paths))
          worst = Math.max(worst, off(sight.position(body), path(time)));
      },
      error: () => worst,
    };
  };

/** The farthest that any of the named bodies was off its path, metres. */
export const offPaths = (paths: Paths) => worstOff(paths, distance);

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
