import { GIVEN_SHARE, ROUND_WAYS, UNEXPLAINED } from '../tolerances.js';

/**
 * What keeps contacts from giving energy, each as one function as in base/guards.ts, and here since pages without contacts
 * need none of it.
 */
export const energyGuards = {
  /** What contacts that bounce give, as a share of all their work. */
  energyOfBounce: (share: number): boolean => share <= GIVEN_SHARE,

  /** Energy of jointed bodies after contacts, J, and the most that it may be. */
  energyOfJoints: (energy: number, most: number): boolean =>
    energy <= ROUND_WAYS.share * most + ROUND_WAYS.energy,

  /** By how much velocities are off from where impulses lead, as those of a solution that runs away are, of bodies this fast. */
  explained: (off: number, fastest: number): boolean =>
    off <= UNEXPLAINED.share * fastest + UNEXPLAINED.speed,
};
