// What is to be said about a text, at its places.
import type { Diagnostic } from '@codemirror/lint';
import type { Told } from './scene/stage.js';
import type { LeftOut } from './text/left-out.js';
import type { Fault } from './text/parse.js';

export const ofFault = ({ from, to, message }: Fault): Diagnostic => ({
  ...{ from, to, message },
  severity: 'error',
  source: 'The scene goes on as it was',
});

export const ofLeftOut = ({ from, to, message }: LeftOut): Diagnostic => ({
  ...{ from, to, message },
  severity: 'info',
});

/** A slow machine is no matter of the text, nor is what is only said of a file brought in. */
export const isOfText = ({ problem, source }: Told): boolean =>
  !!source || problem.severity === 'error';

/** At the attribute concerned, else at the opening tag, else at the text's first character. */
export function ofProblem({ problem, source }: Told): Diagnostic {
  const { attribute, severity, message, code } = problem;
  const key = attribute?.toLowerCase() ?? '';
  const { from, to } = source?.attributes.get(key) ?? source ?? { from: 0, to: 0 };
  return { from, to, severity, message, source: code };
}
