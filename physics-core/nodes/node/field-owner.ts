import type { ProblemReport } from '../../base/problems.js';
import type { Value } from '../../fields/types.js';
import type { FieldState } from './field-state.js';
import type { NodeType } from './table.js';

/** What has fields, as those see it who look after their values. */
export interface FieldOwner {
  readonly type: NodeType;
  readonly label: string;
  readonly fieldState: FieldState;
  /** The author's own value, or X3D's default. */
  asked(name: string): Value;
  report(report: ProblemReport): void;
  settle(attribute?: string, code?: string): void;
}
