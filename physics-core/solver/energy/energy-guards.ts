/**
 * What keeps contacts from giving energy, each as one function as in base/guards.ts, and here since pages without contacts
 * need none of it.
 */
export const energyGuards = {
  /** What contacts that bounce give, as a share of all their work: more than rounding comes from nowhere. */
  energyOfBounce: (share: number): boolean => share <= 1e-3,

  /** Energy of jointed bodies after contacts, J, and the most that it may be: what joints lead along round ways is rounded. */
  energyOfJoints: (energy: number, most: number): boolean => energy <= 1.01 * most + 1e-9,

  /**
   * Velocities that the impulses found with them do not lead to, as a solution that runs away leaves them, m/s or rad/s, of
   * bodies this fast. What only is not quite done mostly has less than a hundredth (measured in 5000 parts).
   */
  explained: (off: number, fastest: number): boolean => off <= 0.03 * fastest + 0.05,
};
