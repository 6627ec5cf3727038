import type { ProblemReport } from '../base/problems.js';

/** Something of the scene that effects act for: it can be named in reports and told of events. */
export interface SimulationNode {
  readonly id: number;
  /** Whatever stands for it outside: its element in a page. */
  readonly host: unknown;
  /** How messages call it. */
  readonly label: string;
  /** Gone for good. */
  readonly removed: boolean;
  heard(event: string): boolean;
  emit(event: string, detail: unknown): void;
  report(report: ProblemReport): void;
}
