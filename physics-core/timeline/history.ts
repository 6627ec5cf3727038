import {
  RUN_FORMAT,
  type Call,
  type Run,
  type StepHash,
  type TimelineMark,
} from '../world/recording.js';
import { CloudPictures } from './cloud-pictures.js';
import { Pictures } from './pictures.js';
import type { Beginning } from './twin.js';

/** With when it was made and how long a step was then, simulated seconds: at another level that is another step. */
export interface KeptCall extends Call {
  time: number;
  timeStep: number;
}

/** What is kept of a world's past. */
export class History {
  readonly pictures = new Pictures();
  readonly clouds = new CloudPictures();
  beginnings: Beginning[] = [];
  calls: KeptCall[] = [];
  hashes: StepHash[] = [];
  problems: TimelineMark[] = [];
  /** Steps since it begins. */
  steps = 0;

  get from(): number {
    return this.pictures.at(0).time;
  }

  get to(): number {
    return this.pictures.at(this.pictures.length - 1).time;
  }

  /** Where a run to a step begins. */
  before(step: number): Beginning {
    return this.beginnings.findLast((one) => one.step <= step)!;
  }

  /** What is older is kept no more, as far as nothing begins there that is. */
  forget(oldest: number): void {
    const { beginnings } = this;
    while (beginnings.length > 1 && beginnings[1]!.snapshot.time <= oldest) beginnings.shift();
    const { step, snapshot } = beginnings[0]!;
    if (step === this.pictures.at(0).step) return;
    this.pictures.drop(step);
    this.clouds.drop(step);
    this.calls = this.calls.filter((call) => call.step >= step);
    this.hashes = this.hashes.filter((hash) => hash.step > step);
    this.problems = this.problems.filter(({ time }) => time >= snapshot.time);
  }

  /** What came after a step has not been. At the last one that is nothing, and what was done since stays. */
  cut(after: number): void {
    if (after === this.steps) return;
    this.steps = after;
    this.pictures.cut(after);
    this.clouds.cut(after);
    this.beginnings = this.beginnings.filter(({ step }) => step <= after);
    this.calls = this.calls.filter(({ step }) => step < after);
    this.hashes = this.hashes.filter(({ step }) => step <= after);
    this.problems = this.problems.filter(({ time }) => time <= this.to);
  }

  export(): Run {
    const [{ step: from, snapshot, drags }] = this.beginnings as [Beginning];
    const since = <T extends { step: number }>(all: readonly T[]): T[] =>
      all.map((one) => ({ ...one, step: one.step - from }));
    return {
      x3dPhysicsRun: RUN_FORMAT,
      start: snapshot,
      drags: [...drags],
      steps: this.steps - from,
      calls: since(this.calls).map(({ time: _, timeStep: __, ...call }) => call),
      hashes: since(this.hashes),
    };
  }
}
