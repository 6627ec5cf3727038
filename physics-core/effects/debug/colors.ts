/** Red, green, blue, from 0 to 1. */
export type Color = readonly [number, number, number];

/** Told apart on light and on dark grounds. */
export const COLOR = {
  awake: [0.1, 0.75, 0.25],
  sleeping: [0.35, 0.5, 0.95],
  fixed: [0.55, 0.57, 0.6],
  kinematic: [0.9, 0.55, 0.05],
  /** Taken out of the simulation: disabled, or without finite numbers. */
  out: [0.75, 0.25, 0.25],
  mass: [0, 0.7, 0.8],
  joint: [0.8, 0.25, 0.85],
  limit: [1, 0.5, 0.8],
  contact: [0.95, 0.75, 0],
  /** Bullet watches it, but nothing touches there. */
  near: [0.6, 0.5, 0.25],
} as const satisfies Record<string, Color>;
