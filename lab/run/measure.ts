import type { Case } from '../case.js';
import { NotOffered, type Engine, type Setting } from '../engines/engine.js';
import { follow, type Findings } from './follow.js';
import type { Progress } from './progress.js';
import type { Measured, Row } from './row.js';
import { Store } from './store.js';

/**
 * A run is repeated until it has worked this long, but so often at least and at most; the fastest repetition counts: a
 * first one may be ten times slower, before the compiler knows it. All runs of a case take turns, so that what else the
 * machine does hits them alike.
 */
export interface Pains {
  seconds: number;
  least: number;
  rounds: number;
}

export const THOROUGH: Pains = { seconds: 0.15, least: 3, rounds: 16 };
export const ONCE: Pains = { seconds: 0, least: 1, rounds: 1 };

/** One engine at one setting. */
export interface Entry {
  engine: Engine;
  setting: Setting;
}

interface Run extends Entry {
  /** Seconds of work so far. */
  worked: number;
  /** Of the fastest repetition. */
  ms: number;
  findings?: Findings;
}

/** Once more; the same scene must come to the same bits. */
async function repeat(which: Case, run: Run): Promise<void> {
  const running = await run.engine.make(which.scene, run.setting);
  const { ms, ...findings } = follow(which, running);
  running.destroy();
  if (run.findings && run.findings.hash !== findings.hash)
    throw new Error(`${which.id}: ${run.engine.name} came to another end than the first time`);
  run.findings = findings;
  run.worked += (ms * which.seconds) / 1000;
  run.ms = Math.min(run.ms, ms);
}

/** For the compiler: once through each engine, which does not count. */
async function warmUp(which: Case, runs: readonly Run[]): Promise<void> {
  const first = new Map(runs.toReversed().map((run) => [run.engine.id, run]));
  for (const run of first.values()) await repeat(which, { ...run });
}

const rowOf = (which: Case, { engine, setting, ms, findings }: Run): Row => ({
  case: which.id,
  scene: which.name,
  engine: engine.id,
  level: setting.level ?? null,
  step: setting.step,
  iterations: setting.iterations,
  effects: findings!.effects,
  error: findings!.error,
  unit: which.unit,
  gap: findings!.gap,
  energyChange: findings!.energyChange,
  ms: Number(ms.toPrecision(4)),
  contacts: findings!.contacts,
  joints: which.scene.joints?.length ?? 0,
  hash: findings!.hash,
});

/** The entries whose engine has words for the scene, and why the others have not. */
async function offered(which: Case, entries: readonly Entry[]) {
  const reasons = new Map<string, string>();
  for (const { engine, setting } of new Map(
    entries.map((entry) => [entry.engine.id, entry]),
  ).values())
    try {
      (await engine.make(which.scene, setting)).destroy();
    } catch (error) {
      if (!(error instanceof NotOffered)) throw error;
      reasons.set(engine.id, error.message);
    }
  return {
    runs: entries
      .filter(({ engine }) => !reasons.has(engine.id))
      .map((entry): Run => ({ ...entry, worked: 0, ms: Infinity })),
    notOffered: [...reasons].map(([engine, reason]) => ({ case: which.id, engine, reason })),
  };
}

interface Manner {
  pains: Pains;
  /** Measure anew what the store has, too. */
  fresh: boolean;
  progress: Progress;
}

/** Runs a case through all entries that the store does not have yet. */
export async function measure(
  which: Case,
  entries: readonly Entry[],
  { pains, fresh, progress }: Manner,
): Promise<Measured> {
  const store = new Store(which.id, fresh);
  const { runs, notOffered } = await offered(which, entries);
  const missing = runs.filter(({ engine, setting }) => !store.get(engine.id, setting));
  if (pains !== ONCE) await warmUp(which, missing);
  for (let round = 0; round < pains.rounds; round++) {
    const due =
      round < pains.least ? missing : missing.filter(({ worked }) => worked < pains.seconds);
    for (const [i, run] of due.entries()) {
      progress(`round ${round + 1}, run ${i + 1} of ${due.length}`);
      await repeat(which, run);
    }
  }
  for (const run of missing) store.set(run.engine.id, run.setting, rowOf(which, run));
  if (pains !== ONCE) store.save();
  const rows = runs.map((run) => store.get(run.engine.id, run.setting) ?? rowOf(which, run));
  return { rows, notOffered };
}

/** One case after the other, and says how long each took. */
export async function measureCases(
  cases: readonly Case[],
  entries: readonly Entry[],
  manner: Manner,
): Promise<Measured> {
  const all: Measured = { rows: [], notOffered: [] };
  for (const [i, which] of cases.entries()) {
    const start = performance.now();
    const { rows, notOffered } = await measure(which, entries, {
      ...manner,
      progress: (doing) =>
        manner.progress(`case ${i + 1} of ${cases.length}, ${which.name}: ${doing}`),
    });
    all.rows.push(...rows);
    all.notOffered.push(...notOffered);
    manner.progress('');
    console.error(`${which.id}: ${((performance.now() - start) / 1000).toFixed(1)} s`);
  }
  return all;
}
