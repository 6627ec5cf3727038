import { isDirected, isSoft, type ContactParameters } from '../../dynamics/contact-parameters.js';
import { NO_DEMANDS, type SolverDemands } from './solver-demands.js';

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

/** The union of what many ask for; each comes and goes at the same cost, however many there are. */
export class DemandCount {
  readonly #counts = new Map<keyof SolverDemands, number>();

  #add(demands: SolverDemands | undefined, count: 1 | -1): void {
    for (const key of KEYS)
      if (demands?.[key]) this.#counts.set(key, (this.#counts.get(key) ?? 0) + count);
  }

  /** One demand takes the place of another. */
  replace(before: SolverDemands | undefined, after: SolverDemands | undefined): void {
    this.#add(before, -1);
    this.#add(after, 1);
  }

  get union(): SolverDemands {
    const any = (key: keyof SolverDemands): boolean => (this.#counts.get(key) ?? 0) > 0;
    return {
      pushing: any('pushing'),
      bouncing: any('bouncing'),
      directed: any('directed'),
      changes: any('changes'),
    };
  }
}

const KEYS = Object.keys(NO_DEMANDS) as (keyof SolverDemands)[];
