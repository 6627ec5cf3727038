import type { Measured } from '../world/measuring.js';
import { copyInto } from '../world/snapshot/copy.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import { World } from '../world/world.js';
import { Comparison } from './comparison.js';
import { LevelRun } from './level-run.js';
import { levelNamed, levels, type LevelName } from '../dynamics/levels.js';
import { workPerMoment } from './work.js';

/** Seconds between two moments where all levels stop: a step of the coarsest. */
const MOMENT = levels[0]!.timeStep;

/** Share of the run after which gaps and overlaps are a level's own, and not those it began with. */
const SETTLED = 0.25;

/** m/s by which the twin's bodies are pushed: what single precision leaves of a speed of a hundred. */
const PUSH = 1e-5;

/** A level is timed again until it was at work for so long, milliseconds, or so often. */
const ENOUGH = 300;
const MOST_TIMES = 5;

/** What is to be measured; plain data. */
export interface Job {
  snapshot: Snapshot;
  /** Coarse to fine. */
  levels: readonly LevelName[];
  seconds: number;
}

type Engine = World['engine'];

/**
 * Runs a scene at all levels from one snapshot; each `next` takes one step, and tells the share that is done. Its worlds
 * are never taken down: they go with the engine, which should be one of its own.
 */
export class Measurement {
  readonly #job: Job;
  readonly #engine: Engine;
  readonly #moments: number;
  #done = 0;
  #all = 0;

  constructor(job: Job, engine: Engine) {
    this.#job = job;
    this.#engine = engine;
    this.#moments = Math.max(1, Math.round(job.seconds / MOMENT));
  }

  *run(): Generator<number, Measured[]> {
    const runs = yield* this.#make(this.#job.levels);
    const [twin] = yield* this.#make([(runs.at(-2) ?? runs[0]!).level.name]);
    push(twin!);
    const comparison = new Comparison(runs, twin!);
    const all = [...runs, twin!];
    this.#all = this.#moments * all.reduce((sum, run) => sum + stepsOf(run), 0);
    yield* this.#race(all, (time) => comparison.compare(time));
    const contacts = runs.map(({ world }) => world.stats.contacts);
    const work = yield* this.#workOf(runs);
    return runs.map((run, i) => ({
      ...this.#result(run, comparison, i),
      msPerSecond: workPerMoment(work[i]!) / MOMENT,
      contacts: contacts[i]!,
    }));
  }

  *#make(names: readonly LevelName[]): Generator<number, LevelRun[]> {
    const made: LevelRun[] = [];
    for (const name of names) {
      const world = new World();
      for (const _ of copyInto(world, this.#job.snapshot, this.#engine, { accuracy: name }))
        yield this.#share;
      made.push(new LevelRun(world, levelNamed(name)));
    }
    return made;
  }

  get #share(): number {
    return this.#all ? Math.min(1, this.#done / this.#all) : 0;
  }

  /** All take turns, a moment each: what disturbs the machine disturbs all alike. */
  *#race(runs: readonly LevelRun[], compare?: (time: number) => void): Generator<number> {
    for (let moment = 1; moment <= this.#moments; moment++) {
      for (const run of runs) {
        run.work.push(0);
        for (let step = 0; step < stepsOf(run); step++) {
          run.step();
          if (compare && step === 0) run.lookBack();
          this.#done++;
          yield this.#share;
        }
        if (compare) run.look(moment < SETTLED * this.#moments);
      }
      compare?.(moment * MOMENT);
    }
  }

  /** Milliseconds of work, moment by moment. What takes little is run again; its first run then was to warm up. */
  *#workOf(first: readonly LevelRun[]): Generator<number, number[][]> {
    const work = first.map((run) => [run.work]);
    for (let again = 1; again < MOST_TIMES; again++) {
      const short = first.filter((_, i) => workOf(work[i]!.flat()) < ENOUGH);
      const runs = yield* this.#make(short.map(({ level }) => level.name));
      yield* this.#race(runs);
      for (const run of runs)
        work[first.findIndex(({ level }) => level === run.level)]!.push(run.work);
    }
    return work.map((each) => (each.length > 1 ? each.slice(1) : each).flat());
  }

  #result(
    run: LevelRun,
    comparison: Comparison,
    i: number,
  ): Omit<Measured, 'msPerSecond' | 'contacts'> {
    const { position, worst } = comparison.differences[i]!;
    const { joint, penetration, level } = run;
    const seconds = this.#moments * MOMENT;
    return {
      level: level.name,
      timeStep: level.timeStep,
      error: { position, energy: comparison.energyError(i), joint, penetration },
      worst: position > 0 ? run.bodies[worst]?.id : undefined,
      chaotic: comparison.horizon !== undefined,
      horizon: comparison.horizon ?? seconds,
      tolerance: comparison.tolerance,
      seconds,
    };
  }
}

const stepsOf = ({ level }: LevelRun): number => Math.round(MOMENT / level.timeStep);

/** Each body another way; the same ways at every measurement. */
function push({ bodies }: LevelRun): void {
  let state = 1;
  const random = (): number => {
    state = (state * 16807) % 2147483647;
    return (2 * state) / 2147483647 - 1;
  };
  for (const body of bodies) {
    const { mass } = body.mass;
    const way = [random(), random(), random()].map((x) => x * PUSH * mass);
    if (!body.sleeping) body.applyImpulse(way as [number, number, number]);
  }
}

/** Milliseconds, without what disturbed it. */
const workOf = (times: readonly number[]): number => workPerMoment(times) * times.length;
