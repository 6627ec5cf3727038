import { loadavg } from 'node:os';
import type { CaseScene } from '../case.js';
import type { Running } from '../engines/engine.js';
import { collect, collectYoung } from '../run/collect.js';
import { machine, MACHINE, today } from '../run/machine.js';
import type { Progress } from '../run/progress.js';
import { timeOf } from '../run/time-of.js';
import { estimate, median, shareOf, type Estimate, type Share } from '../statistics.js';
import { engines, running } from './engines.js';
import { Looks, type Errors } from './errors.js';
import type { PriceScene } from './scene.js';

/** Seconds of the scene that an engine takes before the next has its turn. */
export const TURN = 0.1;

/** What a step of one engine costs, milliseconds, and what it leaves. */
export interface Side {
  /** Of a step, the first one apart. */
  median: number;
  mean: number;
  first: number;
  worst: number;
  /** To Ammo's steps of the same turns. */
  toAmmo: { median: Estimate; mean: Share } | null;
  errors: Errors;
}

/** One scene at one level; what an engine lacks stands in the place of its numbers. */
export interface PriceCell {
  scene: string;
  level: string;
  /** Seconds. */
  step: number;
  turns: number;
  bodies: number;
  joints: number;
  machine: string;
  date: string;
  /** How many processes wanted to run on each core in the minute before it ended. */
  load: number;
  sides: Record<string, Side | string>;
}

/** An engine under way. */
interface Run {
  engine: string;
  running: Running;
  looks: Looks;
  /** Milliseconds of every step, by turns. */
  turns: number[][];
}

function takeTurn({ running: { step, timeStep }, turns }: Run): void {
  collectYoung();
  turns.push(Array.from({ length: Math.round(TURN / timeStep) }, () => timeOf(step)));
}

/** Each engine takes its turns; none is always the first. */
async function takeTurns(runs: readonly Run[], turns: number, progress: Progress): Promise<void> {
  for (let turn = 0; turn < turns; turn++)
    for (const i of runs.keys()) {
      const run = runs[(i + turn) % runs.length]!;
      progress(`turn ${turn + 1} of ${turns}, ${run.engine}`);
      takeTurn(run);
      await run.looks.look(2 * turn >= turns);
    }
}

const sum = (values: readonly number[]): number => values.reduce((all, value) => all + value, 0);

/** Without the first step of all. */
const steady = ({ turns: [first, ...rest] }: Run): number[][] => [first!.slice(1), ...rest];

const totals = (run: Run): number[] => steady(run).map(sum);

function toAmmo(run: Run, ammo: Run | undefined): Side['toAmmo'] {
  if (!ammo || run === ammo) return null;
  const theirs = totals(ammo);
  const pairs = totals(run).map((time, i) => [time, theirs[i]!] as const);
  return { median: estimate(pairs.map(([mine, other]) => mine / other)), mean: shareOf(pairs) };
}

function sideOf(run: Run, ammo: Run | undefined): Side {
  const steps = steady(run).flat();
  return {
    median: median(steps),
    mean: sum(steps) / steps.length,
    first: run.turns[0]![0]!,
    worst: Math.max(...steps),
    toAmmo: toAmmo(run, ammo),
    errors: run.looks.errors,
  };
}

/** The scene in every engine that has words for it, and what the others lack. */
async function begin(scene: CaseScene, level: string, driven: boolean) {
  const runs: Run[] = [];
  const lacking: Record<string, string> = {};
  for (const engine of engines) {
    const made = await running(engine, scene, level);
    if (typeof made === 'string') lacking[engine.id] = made;
    else
      runs.push({
        engine: engine.id,
        running: made,
        looks: new Looks(scene, made, driven),
        turns: [],
      });
  }
  return { runs, lacking };
}

async function measured(
  scene: CaseScene,
  level: string,
  driven: boolean,
  turns: number,
  progress: Progress,
) {
  const { runs, lacking } = await begin(scene, level, driven);
  // What building a scene leaves is no cost of its steps.
  collect();
  await takeTurns(runs, turns, progress);
  const ammo = runs.find(({ engine }) => engine === 'ammo');
  const sides = runs.map((run): [string, Side] => [run.engine, sideOf(run, ammo)]);
  const step = runs[0]!.running.timeStep;
  destroy(runs);
  return { step, sides: { ...Object.fromEntries(sides), ...lacking } };
}

/**
 * Seconds of the clock that the scene itself runs in all engines before, for the compiler: a step of code that it has not come
 * to yet takes two to three times as long (tumbling-20 and chain-100 at `game`), and a page that runs for a minute has few.
 */
const WARM_UP = 8;

/**
 * From its beginning, time and again: what moves there is what is measured. The worlds made last are handed back alive: with
 * the last objects of their shapes V8 drops, at the next full collection, all code that it has compiled for them.
 */
async function warmUp(scene: CaseScene, level: string, turns: number): Promise<Run[]> {
  const end = performance.now() + 1000 * WARM_UP;
  let last: Run[] = [];
  do {
    const before = last;
    last = (await begin(scene, level, false)).runs;
    destroy(before);
    for (let turn = 0; turn < turns && performance.now() < end; turn++)
      for (const run of last) takeTurn(run);
  } while (performance.now() < end);
  return last;
}

function destroy(runs: readonly Run[]): void {
  for (const { running } of runs) running.destroy();
}

export async function measureCell(
  { id, size, driven, build }: PriceScene,
  level: string,
  turns: number,
  progress: Progress,
): Promise<PriceCell> {
  const drives = driven !== undefined;
  const scene = build(size);
  progress('warming up');
  const warm = await warmUp(scene, level, turns);
  const { step, sides } = await measured(scene, level, drives, turns, progress);
  destroy(warm);
  return {
    scene: id,
    level,
    step,
    turns,
    bodies: scene.bodies.filter(({ fixed }) => !fixed).length,
    joints: scene.joints?.length ?? 0,
    machine: MACHINE,
    date: today(),
    load: loadavg()[0]! / machine.cores,
    sides,
  };
}
