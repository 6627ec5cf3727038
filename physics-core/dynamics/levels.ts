/** The levels, coarse to fine. Figures: project measurements over the ladder of Bullet's own knobs. */
export type LevelName = 'game' | 'standard' | 'fine' | 'precise' | 'reference';

export interface Level {
  name: LevelName;
  /** Seconds that one step of Bullet takes. */
  timeStep: number;
  /** Solver iterations per step. */
  iterations: number;
  /** Share of a joint's position error repaired per step. */
  errorCorrection: number;
  /** Two friction directions instead of one: towers stand longer, +15 to 45 % time where much touches. */
  twoFrictionDirections: boolean;
  /**
   * Blocks of matrices, one for each body that moves and each point in which one touches, that a step has for what touches
   * and moves: up to so many are solved directly; of more, all have Bullet's iterations. What is calm, or a net, is solved
   * directly anyway, and so is each car, ragdoll or chain that has no more by itself.
   */
  effort: number;
  /**
   * Share of its speed, or of what weight gives it in a step, that what hangs together and touches may miss by, besides what
   * rounding leaves. What joints hold is brought together after the step all the same.
   */
  miss: number;
}

/**
 * Three boxes that slide, or ten balls that roll, have 24 blocks; ten boxes that tumble have 40 and more, and take ten times
 * Bullet's step where all of them are solved directly (measured, boxes in a drum).
 */
const EFFORT_OF_GAME = 24;

/**
 * Twice that keeps all that the stability matrix promises, and a row of dominoes its energy. Twenty boxes that tumble cost 7
 * of Ammo's steps and not 34, a hundred 4 and not 36 (measured, boxes in a drum).
 */
const EFFORT_OF_STANDARD = 48;

/** Some forty boxes that tumble. Chosen, and fixed by no case: the stability matrix holds with it. */
const EFFORT_OF_FINE = 192;

/**
 * Five micrometres in a step of what lies: a chain on the ground takes 6 matrices in a step then, and not 16. A tenth of that,
 * in half the step, at each level that is finer: a third fewer matrices at `standard`.
 */
const MISS_OF_GAME = 2e-3;

export const levels: readonly Level[] = [
  {
    name: 'game',
    timeStep: 1 / 60,
    iterations: 10,
    errorCorrection: 0.8,
    twoFrictionDirections: false,
    effort: EFFORT_OF_GAME,
    miss: MISS_OF_GAME,
  },
  {
    name: 'standard',
    timeStep: 1 / 120,
    iterations: 10,
    errorCorrection: 0.8,
    twoFrictionDirections: true,
    effort: EFFORT_OF_STANDARD,
    miss: MISS_OF_GAME / 10,
  },
  {
    name: 'fine',
    timeStep: 1 / 240,
    iterations: 20,
    errorCorrection: 0.8,
    twoFrictionDirections: true,
    effort: EFFORT_OF_FINE,
    miss: MISS_OF_GAME / 100,
  },
  {
    name: 'precise',
    timeStep: 1 / 480,
    iterations: 30,
    errorCorrection: 0.8,
    twoFrictionDirections: true,
    effort: Infinity,
    miss: 0,
  },
  {
    name: 'reference',
    timeStep: 1 / 960,
    iterations: 50,
    errorCorrection: 0.8,
    twoFrictionDirections: true,
    effort: Infinity,
    miss: 0,
  },
];

export const levelNames: readonly LevelName[] = levels.map(({ name }) => name);
export const DEFAULT_LEVEL: LevelName = 'standard';
/** Not a level: the finest that fits a time budget. */
export const AUTO = 'auto';
/** What X3D's `preferAccuracy` asks for. */
export const ACCURATE_LEVEL: LevelName = 'precise';

/** All levels; `active` marks one of them. */
export const ladder = (active: LevelName): (Level & { active: boolean })[] =>
  levels.map((level) => ({ ...level, active: level.name === active }));

export const levelNamed = (name: string): Level => levels.find((level) => level.name === name)!;

/** What X3D says of constraints is of steps this long, the frame it was written for, seconds. */
export const FRAME = 1 / 60;

/** X3D's errorCorrection is per 1/60 s; this is its share per step of `dt`. */
export const perStep = (errorCorrection: number, dt: number): number =>
  1 - (1 - errorCorrection) ** (60 * dt);

/**
 * Softness (X3D's constantForceMix, velocity per force) of a row that repairs the share `errorCorrection` per 1/60 s, for
 * steps of `dt`: under a steady force it gives way as far as X3D's own step of 1/60 s would let it.
 */
export const softnessAtStep = (softness: number, errorCorrection: number, dt: number): number =>
  errorCorrection > 0
    ? (softness * perStep(errorCorrection, dt)) / (60 * dt * errorCorrection)
    : softness;
