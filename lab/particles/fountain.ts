/** Kilograms of one particle. */
export const MASS = 0.001;

/** The system that all are measured with: a fountain, of which as many live all the time as it may have. */
export const FOUNTAIN = {
  /** Seconds that each of them lives. */
  life: 3,
  /** Radians between its axis, which is up, and its edge. */
  angle: 0.3,
  /** Metres per second, and the share by which that of one is more or less. */
  speed: 12,
  variation: 0.25,
  /** Metres. */
  size: 0.08,
  gravity: -9.8,
  /** From birth to death, evenly spread; the last number of each is its opacity. */
  colors: [
    [0.1, 0.3, 0.8, 1],
    [0.5, 0.7, 0.9, 1],
    [1, 1, 1, 1],
  ],
} as const;

/** The same colours, of which the last can't be seen any more. */
export const FADING = FOUNTAIN.colors.map(([r, g, b], i) => [r, g, b, 1 - i / 2] as const);

/** Where it is looked at from. */
export const EYE = [0, 4, 14] as const;
