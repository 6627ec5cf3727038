/** What contact parameters ask of the solver as a whole. */
export interface SolverDemands {
  /** Overlaps are pushed apart without adding velocity, however shallow. */
  pushing: boolean;
  /** Something bounces. */
  bouncing: boolean;
  /** Friction has directions of its own. */
  directed: boolean;
  /** The last step's change of every velocity is known. */
  changes: boolean;
}

export const NO_DEMANDS: SolverDemands = {
  pushing: false,
  bouncing: false,
  directed: false,
  changes: false,
};
