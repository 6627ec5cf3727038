export type Severity = 'error' | 'warning' | 'info';

/** Something an author should know: what is wrong, where, and what is used instead. */
export interface Problem {
  /** Stable, for programs: `bad-value`, `unknown-reference`, … */
  code: string;
  severity: Severity;
  /** One sentence for people. */
  message: string;
  /** The element in a page; the node in the core. */
  element: unknown;
  attribute?: string | undefined;
  value?: unknown;
  used?: unknown;
}

export type ProblemReport = Omit<Problem, 'element'>;

const LOG = { error: 'error', warning: 'warn', info: 'info' } as const;

/** One line in the console, and behind it what else can be shown there. */
export function logProblem(problem: ProblemReport, ...details: unknown[]): void {
  console[LOG[problem.severity]](`x3d-physics: ${problem.message} [${problem.code}]`, ...details);
}

/** Each problem once per element, attribute and code until it changes or is settled. */
export class ProblemLog {
  readonly #byElement = new Map<unknown, Map<string, Problem>>();
  /** Who reported it: several nodes may stand for one element. */
  readonly #reporters = new WeakMap<Problem, unknown>();
  /** What was known when all was made anew, and has not come again since. */
  #before = new Map<unknown, Map<string, Problem>>();
  /** @param again whether it was told before all was made anew */
  onreport?: (problem: Problem, again: boolean) => void;

  get all(): Problem[] {
    return [...this.#byElement.values()].flatMap((problems) => [...problems.values()]);
  }

  of(element: unknown): Problem[] {
    return [...(this.#byElement.get(element)?.values() ?? [])];
  }

  report(element: unknown, report: ProblemReport, reporter: unknown = element): void {
    const key = `${report.attribute ?? ''} ${report.code}`;
    const known = this.#byElement.get(element) ?? new Map<string, Problem>();
    const before = known.get(key);
    if (isSame(before, report)) return;
    const problem = { ...report, element };
    known.set(key, problem);
    this.#byElement.set(element, known);
    this.#reporters.set(problem, reporter);
    const once = this.#before.get(element);
    const again = isSame(once?.get(key), report);
    once?.delete(key);
    this.onreport?.(problem, again);
  }

  /** All is made anew: what is reported again, in the same words, was told. */
  anew(make: () => void): void {
    const copies = [...this.#byElement].map(([of, known]) => [of, new Map(known)] as const);
    this.#before = new Map(copies);
    make();
    // What never went may go and come again later, and is new then.
    for (const [of, known] of this.#byElement)
      for (const key of known.keys()) this.#before.get(of)?.delete(key);
  }

  /** What one of those that stand for an element has reported. */
  by(reporter: unknown, element: unknown): Problem[] {
    return this.of(element).filter((problem) => this.#reporters.get(problem) === reporter);
  }

  /** Takes reports back whose cause is gone. */
  settle(element: unknown, attribute?: string, code?: string): void {
    const known = this.#byElement.get(element);
    if (!known) return;
    for (const [key, problem] of known) {
      const meant =
        (!attribute || problem.attribute === attribute) && (!code || problem.code === code);
      if (meant) known.delete(key);
    }
    if (known.size === 0) this.#byElement.delete(element);
  }
}

const isSame = (known: Problem | undefined, report: ProblemReport): boolean =>
  known?.message === report.message && Object.is(known.value, report.value);
