import { loadavg } from 'node:os';
import { collect, collectYoung } from '../run/collect.js';
import { machine, MACHINE, today } from '../run/machine.js';
import { median } from '../run/median.js';
import type { Progress } from '../run/progress.js';
import { timeOf } from '../run/time-of.js';
import type { SoftCase } from './case.js';
import type { SoftEngine, SoftSetting } from './engine.js';
import { softEngines } from './engines.js';
import { levelNames, nameOf } from './levels.js';
import type { SoftRow, SoftCell } from './numbers.js';
import { threadsOf, type SoftRunning, type SoftScene } from './scene.js';

/** Seconds of the scene that one takes before the next has its turn, and turns of each. */
const [TURN, TURNS] = [0.1, 10];

/** Threads times rounds in a second of the scene: what takes more takes a minute of ours for a few seconds. */
const MOST_ROUNDS = 5e7;

/** One side under way: it has been run, and is now timed. */
interface Side {
  engine: SoftEngine;
  setting: SoftSetting;
  running: SoftRunning;
  errors: SoftRow['errors'];
  /** Milliseconds of its turns. */
  turns: number[];
}

const bearable = (scene: SoftScene, { step, iterations }: SoftSetting): boolean =>
  (threadsOf(scene).length * (iterations ?? 1)) / step <= MOST_ROUNDS;

const fineEnough = ({ finest }: SoftCase, { level }: SoftSetting): boolean =>
  !finest || !level || levelNames.indexOf(level) <= levelNames.indexOf(finest);

/** Null where it flew apart, or did not do what it is judged by. */
const errorsOf = ({ judged, run }: SoftCase, running: SoftRunning): SoftRow['errors'] => {
  const found = run(running);
  return Object.fromEntries(
    judged.map(({ id }) => [id, Number.isFinite(found[id]) ? found[id]! : null]),
  );
};

async function runAll(which: SoftCase, progress: Progress): Promise<Side[]> {
  const sides: Side[] = [];
  for (const engine of softEngines)
    for (const setting of engine.settings(which.scene)) {
      if (!bearable(which.scene, setting) || !fineEnough(which, setting)) continue;
      progress(`${which.id}: ${engine.name}, ${nameOf(setting)}`);
      const running = await engine.make(which.scene, setting);
      sides.push({ engine, setting, running, errors: errorsOf(which, running), turns: [] });
    }
  return sides;
}

const stepsOf = ({ setting: { step } }: Side): number => Math.max(1, Math.round(TURN / step));

/** None is always the first. */
function takeTurns(sides: readonly Side[]): void {
  collect();
  for (let turn = 0; turn < TURNS; turn++)
    for (const i of sides.keys()) {
      const side = sides[(i + turn) % sides.length]!;
      const steps = stepsOf(side);
      collectYoung();
      const time = timeOf(() => {
        for (let n = 0; n < steps; n++) side.running.step();
      });
      side.turns.push(time);
    }
}

const rowOf = (side: Side): SoftRow => ({
  engine: side.engine.id,
  ...side.setting,
  ms: median(side.turns) / stepsOf(side),
  errors: side.errors,
});

/** Each library at each of its settings, one after the other for errors, and in turns at what is left in the end for costs. */
export async function measureCase(which: SoftCase, progress: Progress): Promise<SoftCell> {
  const sides = await runAll(which, progress);
  progress(`${which.id}: costs`);
  takeTurns(sides);
  for (const { running } of sides) running.destroy();
  return {
    case: which.id,
    machine: MACHINE,
    date: today(),
    load: loadavg()[0]! / machine.cores,
    rows: sides.map(rowOf),
  };
}
