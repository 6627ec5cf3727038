import { readFileSync, writeFileSync } from 'node:fs';
import type { Case } from '../case.js';
import { cases } from '../cases/index.js';
import { MACHINE, today } from './machine.js';
import type { Results, Run } from './row.js';

// The numbers of the report: all that is kept of it. Pages and pictures are drawn from them.

const ROWS = new URL('../report/rows.json', import.meta.url);

export const readReport = (): Results => JSON.parse(readFileSync(ROWS, 'utf8')) as Results;

/** One row per line, so that a new run shows what changed. */
export function writeReport({ runs, rows, notOffered }: Results): void {
  const lines = (list: readonly object[]) => list.map((one) => JSON.stringify(one)).join(',\n');
  const parts = Object.entries({ runs, rows, notOffered }).map(
    ([name, list]) => `"${name}":[\n${lines(list)}\n]`,
  );
  writeFileSync(ROWS, `{${parts.join(',')}}\n`);
}

/** Here and now. */
export const runOf = (measured: readonly Case[]): Results['runs'][number] => ({
  machine: MACHINE,
  date: today(),
  cases: measured.map(({ id }) => id),
});

/** What the same machine measured on the same day is one run. */
function joined(runs: readonly Run[]): Run[] {
  const all = new Map<string, Run>();
  for (const { machine, date, cases: ids } of runs) {
    const same = all.get(machine + date)?.cases ?? [];
    all.set(machine + date, { machine, date, cases: [...same, ...ids] });
  }
  return [...all.values()];
}

/** A report with cases measured anew: their rows in place of those of before. */
export function withCases(before: Results, fresh: Results): Results {
  const anew = new Set(fresh.runs.flatMap((run) => run.cases));
  const place = new Map(cases.map(({ id }, i) => [id, i]));
  const together = <T extends { case: string }>(old: readonly T[], now: readonly T[]): T[] =>
    [...old.filter((one) => !anew.has(one.case)), ...now].sort(
      (a, b) => place.get(a.case)! - place.get(b.case)!,
    );
  const kept = before.runs
    .map((run) => ({ ...run, cases: run.cases.filter((id) => !anew.has(id)) }))
    .filter((run) => run.cases.length > 0);
  return {
    runs: joined([...kept, ...fresh.runs]),
    rows: together(before.rows, fresh.rows),
    notOffered: together(before.notOffered, fresh.notOffered),
  };
}
