import type { Case } from '../case.js';
import { engines } from '../engines/index.js';
import { measure, ONCE, type Entry } from './measure.js';
import type { Progress } from './progress.js';
import type { Measured, Row } from './row.js';

/** Seconds that a run may take to be among those that are compared; our levels always are. */
const CHEAP = 0.1;

type Compared = Pick<Row, 'engine' | 'level' | 'step' | 'iterations'>;

const same = (a: Compared, b: Compared): boolean =>
  a.engine === b.engine &&
  a.level === b.level &&
  a.step === b.step &&
  a.iterations === b.iterations;

const comparedOf = ({ engine, setting: { level, step, iterations } }: Entry): Compared => ({
  engine: engine.id,
  level: level ?? null,
  step,
  iterations,
});

const nameOf = (row: Row): string =>
  `${row.case}, ${row.engine} ${row.level ?? `step ${row.step} s, ${row.iterations} iterations`}`;

/** What came out otherwise for one case, and how much was compared. */
async function compareCase(which: Case, before: readonly Row[], progress: Progress) {
  const cheap = before.filter(
    ({ ms, level }) => level !== null || (ms * which.seconds) / 1000 < CHEAP,
  );
  const entries = engines
    .flatMap((engine) => engine.settings.map((setting): Entry => ({ engine, setting })))
    .filter((entry) => cheap.some((row) => same(row, comparedOf(entry))));
  const { rows } = await measure(which, entries, { pains: ONCE, fresh: true, progress });
  const wrong = cheap.flatMap((row) => {
    const now = rows.find((one) => same(one, row));
    if (now && now.error === row.error && now.hash === row.hash) return [];
    return `${nameOf(row)}: error ${now ? now.error : 'not run'}, was ${row.error}`;
  });
  return { compared: cheap.length, wrong };
}

/** Runs anew, once, what is cheap in these results, and says where error or state came out otherwise. */
export async function compareWith(
  { rows }: Measured,
  cases: readonly Case[],
  progress: Progress,
  say: (line: string) => void = console.log,
): Promise<number> {
  const start = performance.now();
  const wrong: string[] = [];
  let compared = 0;
  for (const which of cases) {
    const before = rows.filter((row) => row.case === which.id);
    if (before.length === 0) wrong.push(`${which.id} is not in the report`);
    const found = await compareCase(which, before, (doing) => progress(`${which.id}: ${doing}`));
    wrong.push(...found.wrong);
    compared += found.compared;
  }
  progress('');
  for (const line of wrong) say(line);
  const seconds = Math.round((performance.now() - start) / 1000);
  say(`${compared} runs compared in ${seconds} s, ${wrong.length} came out otherwise`);
  return wrong.length > 0 ? 1 : 0;
}
