// What is to be said about a text, at its places.
import type { Diagnostic } from '@codemirror/lint';
import type { Problem, ScriptFault } from './scene/frame.js';
import type { Said } from './scene/stage.js';
import type { LeftOut } from './text/left-out.js';
import type { Fault } from './text/parse.js';
import type { Place } from './text/tree.js';

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
export const isOfText = ({ said, source }: Said<Problem>): boolean =>
  !!source || said.severity === 'error';

/** Of what was recorded, and of no place in the text. */
export const ofRunFault = (message: string): Diagnostic => ({
  ...{ from: 0, to: 0, message },
  severity: 'error',
});

/** It goes another way here than it went. */
export const isOfRun = ({ said }: Said<Problem>): boolean => said.code === 'run-diverged';

const START: Place = { from: 0, to: 0 };

/** At the attribute concerned, else at the opening tag, else at the text's first character. */
export function ofProblem({ said, source }: Said<Problem>): Diagnostic {
  const { attribute, severity, message, code } = said;
  const { from, to } = source?.attributes.get(attribute?.toLowerCase() ?? '') ?? source ?? START;
  return { from, to, severity, message, source: code };
}

/** At the line of the script; `text` is what the script's tree is of. */
export function ofScript({ said, source }: Said<ScriptFault>, text: string): Diagnostic {
  const { from, to } = source ? lineIn(text, source, said.line) : START;
  return { from, to, severity: 'error', message: said.message, source: 'The script' };
}

/** A script's first line is the one of its tag. */
function lineIn(text: string, { from, to }: Place, line: number): Place {
  if (line < 1) return { from, to };
  let start = to;
  for (let i = 1; i < line; i++) start = text.indexOf('\n', start) + 1 || start;
  const end = text.indexOf('\n', start);
  return { from: start, to: end < 0 ? text.length : end };
}
