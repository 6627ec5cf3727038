import { isDirected, isSoft, type ContactParameters } from '../nodes/contact-parameters.js';

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

export const demandsOf = (parameters: ContactParameters): SolverDemands => ({
  pushing: parameters.bounce > 0 || isSoft(parameters),
  bouncing: parameters.bounce > 0,
  directed: isDirected(parameters),
  changes: parameters.softness > 0 || parameters.slip.some((value) => value > 0),
});

export const union = (all: readonly SolverDemands[]): SolverDemands => ({
  pushing: all.some(({ pushing }) => pushing),
  bouncing: all.some(({ bouncing }) => bouncing),
  directed: all.some(({ directed }) => directed),
  changes: all.some(({ changes }) => changes),
});
