import { inSlices } from '../accuracy/slices.js';
import type { Pose, Quaternion } from '../base/math.js';
import { mix } from '../base/mix.js';
import type { Level } from '../dynamics/levels.js';
import { POSE, type Poses } from '../dynamics/poses.js';
import type { Vec3 } from '../fields/types.js';
import type { Watching } from '../world/measuring.js';
import type { World } from '../world/world.js';
import type { History, KeptCall } from './history.js';
import { Pictures, type Moment } from './pictures.js';
import { Twin, type Beginning } from './twin.js';

/** Share of a step by which times that are meant to be the same may differ: sums of seconds round. */
const SAME = 1e-3;

/** What acts for one step, however long that is. */
const FOR_A_STEP = ['applyForce', 'applyTorque'];

/** A recorded run at another level: where its bodies are at the times of the run's own pictures. */
export class Ghost {
  readonly level: Level;
  /** All of it was run. */
  whole = false;
  /** The step of the run, not of its own, up to which it goes. */
  end: number;
  readonly #from: number;
  readonly #beginning: Beginning;
  readonly #calls: KeptCall[];
  readonly #moments: Moment[];
  readonly #pictures = new Pictures();

  constructor({ beginnings, calls, pictures, steps }: History, level: Level) {
    this.level = level;
    this.end = steps;
    this.#from = beginnings[0]!.snapshot.time;
    this.#beginning = { ...beginnings[0]!, step: 0 };
    this.#calls = calls.map((call) => this.#atLevel(call));
    this.#moments = pictures.moments;
  }

  /** At the time it was made at. A force for a step of another length has the same impulse. */
  #atLevel(call: KeptCall): KeptCall {
    const step = this.#stepAt(call.time);
    const [force, ...at] = call.args;
    if (!FOR_A_STEP.includes(call.method) || !Array.isArray(force)) return { ...call, step };
    const share = call.timeStep / this.level.timeStep;
    return { ...call, step, args: [(force as number[]).map((value) => value * share), ...at] };
  }

  /** Its first step that begins at a time or after it, counted from where it begins. */
  #stepAt(time: number): number {
    return Math.ceil((time - this.#from) / this.level.timeStep - SAME);
  }

  /** Beside the world, in slices, for as long as it is wanted. */
  async run(world: World, watching: Watching, isWanted: () => boolean): Promise<void> {
    const twin = new Twin(this.#calls, this.level);
    try {
      await inSlices(this.#runWhile(isWanted, twin, world), watching);
    } finally {
      twin.world.destroy();
    }
  }

  *#runWhile(isWanted: () => boolean, twin: Twin, world: World): Generator<number, void> {
    for (const done of this.#run(twin, world)) {
      if (!isWanted()) return;
      yield done;
    }
    this.whole = true;
  }

  *#run(twin: Twin, world: World): Generator<number, void> {
    yield* twin.begin(world, this.#beginning);
    const moments = this.#moments.splice(0);
    for (const [i, moment] of moments.entries()) {
      for (const _ of twin.runTo(this.#stepAt(moment.time))) yield i / moments.length;
      if (moment.step > this.end) return;
      this.#picture(moment, twin.world);
    }
  }

  /** Between two steps where the run has a step and it has none. */
  #picture(moment: Moment, { bodies, poses, time }: World): void {
    const beyond = (time - moment.time) / this.level.timeStep;
    const at = beyond < SAME ? poses.current : between(poses, 1 - beyond);
    this.#pictures.add(moment, [...bodies], at);
  }

  /** Says where each body is at the end of a step of the run. False: it has no picture of that. */
  show(step: number, put: (id: number, pose: Float32Array) => void): boolean {
    const at = this.#pictures.firstFrom('step', step);
    if (!this.whole || at === this.#pictures.length || this.#pictures.at(at).step !== step)
      return false;
    this.#pictures.show(at, put);
    return true;
  }

  /** What came after a step of the run has not been. */
  cut(after: number): void {
    this.end = Math.min(this.end, after);
    this.#pictures.cut(after);
  }
}

/** Where bodies are between the last two steps; 1: at the last one. */
function between({ previous, current }: Poses, share: number): Float64Array {
  const poses = new Float64Array(current.length);
  for (let at = 0; at < poses.length; at += POSE) {
    const { p, q } = mix(poseIn(previous, at), poseIn(current, at), share);
    poses.set(p, at);
    poses.set(q, at + 3);
  }
  return poses;
}

const poseIn = (poses: Float64Array, at: number): Pose => ({
  p: [...poses.subarray(at, at + 3)] as Vec3,
  q: [...poses.subarray(at + 3, at + POSE)] as Quaternion,
});
