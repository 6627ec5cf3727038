import type { ProblemReport } from '../../base/problems.js';

/** A node that says what is odd about it. */
export interface Reported {
  readonly label: string;
  /** Reports while it is the case, and takes it back. */
  reportWhile(is: boolean, report: ProblemReport): void;
}
