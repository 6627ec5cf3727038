import type { ProblemReport } from '../../../physics-core/inside.js';

/** Code that a page calls for can't be had: `code` is that of the problem without its end, `what` the sentence's subject. */
export const loadFailed = (code: string, what: string, error: unknown): ProblemReport => ({
  code: `${code}-load-failed`,
  severity: 'error',
  value: String(error),
  used: 'nothing',
  message: `${what} could not be loaded: ${String(error)}`,
});
