import type { Check, Driver, Fact } from './fact.js';

export interface Verdict extends Check {
  pass: boolean;
}

export interface Judged {
  fact: Fact;
  pass: boolean;
  checks: Verdict[];
  /** Why it could not be measured to its end. */
  error?: string;
  /** That browser has no field that would tell: it counts neither way. */
  untold?: true;
}

const numbers = (value: Check['actual']): number[] | undefined => {
  const list: unknown[] = Array.isArray(value) ? value : [value];
  return list.every((item) => typeof item === 'number') ? (list as number[]) : undefined;
};

/** Whether what was measured is what was expected. */
export function passes({ actual, expected, tolerance = 0 }: Check): boolean {
  const [a, e] = [numbers(actual), numbers(expected)];
  if (!a || !e || Array.isArray(actual) !== Array.isArray(expected))
    return JSON.stringify(actual) === JSON.stringify(expected);
  return a.length === e.length && e.every((value, i) => Math.abs(a[i]! - value) <= tolerance);
}

/** Runs a fact on a stage that shows its scene. Nothing throws: what can't be measured is not passed. */
export async function judge(fact: Fact, driver: Driver): Promise<Judged> {
  try {
    const checks = (await fact.run(driver)).map((check) => ({ ...check, pass: passes(check) }));
    return { fact, checks, pass: checks.length > 0 && checks.every(({ pass }) => pass) };
  } catch (error) {
    return { fact, checks: [], pass: false, error: String((error as Error)?.message ?? error) };
  }
}

/** Numbers to four places. */
export const describeValue = (value: Check['actual']): string =>
  JSON.stringify(value, (_, item: unknown) =>
    typeof item === 'number' ? Number(item.toPrecision(4)) : item,
  );

/** A check in one line. */
export const describeCheck = ({ what, actual, expected, tolerance, unit, pass }: Verdict): string =>
  `${pass ? '✓' : '✗'} ${what}: ${describeValue(actual)}, expected ${describeValue(expected)}` +
  `${tolerance === undefined ? '' : ` ± ${describeValue(tolerance)}`}${unit ? ` ${unit}` : ''}`;

/** All that went wrong; empty where nothing did. */
export const failures = ({ checks, pass, error, untold }: Judged): string[] => {
  if (pass || untold) return [];
  if (error) return [error];
  const failed = checks.filter((check) => !check.pass).map(describeCheck);
  return failed.length > 0 ? failed : ['it measures nothing'];
};

/** What a test of our library has to say against it: an unmet fact that is met shall be marked so no more. */
export function objections(judged: Judged): string[] {
  if (!judged.fact.unmet) return failures(judged);
  return judged.pass ? ['it is met now: it is not `unmet` any more'] : [];
}
