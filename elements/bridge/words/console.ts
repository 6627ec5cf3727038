import { logProblem, type ProblemReport } from '../../../physics-core/inside.js';
import { nameOf } from './dom.js';

/** In the console. An element that its message can't name comes along, so that one can click it. */
export function logInPage(problem: ProblemReport, element: unknown): void {
  if (element instanceof Element && !nameOf(element)) logProblem(problem, element);
  else logProblem(problem);
}
