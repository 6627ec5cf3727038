import { createHash } from 'node:crypto';
import type { Case, Sight } from '../case.js';
import type { Running } from '../engines/engine.js';
import { energyIn } from './energy.js';
import { widestGap } from './gap.js';

/** What a run shows of itself, the same in every repetition. */
export interface Findings {
  error: number | null;
  gap: number | null;
  energyChange: number | null;
  contacts: number | null;
  effects: string[];
  hash: string;
}

/** Seconds between two looks where a case says nothing. */
const FRAME = 1 / 60;

const finite = (value: number): number | null => (Number.isFinite(value) ? value : null);

/** Of all poses and velocities, bit for bit. */
export function hashOf({ scene }: Case, sight: Sight): string {
  const state = scene.bodies.flatMap(({ name }) => [
    ...sight.position(name),
    ...sight.orientation(name),
    ...sight.linearVelocity(name),
    ...sight.angularVelocity(name),
  ]);
  return createHash('sha256').update(new Float64Array(state)).digest('hex').slice(0, 16);
}

/** Looks and steps of a run. */
export interface Course {
  looks: number;
  stepsPerLook: number;
  /** Seconds between two looks. */
  every: number;
}

export function courseOf({ seconds, every = FRAME }: Case, { timeStep }: Running): Course {
  const stepsPerLook = Math.round(every / timeStep);
  if (stepsPerLook < 1 || Math.abs(stepsPerLook * timeStep - every) > 1e-9)
    throw new Error(`steps of ${timeStep} s don't meet looks every ${every} s`);
  return { looks: Math.round(seconds / every), stepsPerLook, every };
}

/** Steps a case to its end and looks at it on the way; only the steps are timed. */
export function follow(which: Case, running: Running): Findings & { ms: number } {
  const { looks, stepsPerLook, every } = courseOf(which, running);
  const gapNow = widestGap(which.scene);
  const watch = which.watch(running);
  const before = energyIn(which.scene, running);
  let [gap, ms] = [0, 0];
  watch.look(0);
  for (let look = 1; look <= looks; look++) {
    const start = performance.now();
    for (let i = 0; i < stepsPerLook; i++) running.step();
    ms += performance.now() - start;
    watch.look(look * every);
    gap = Math.max(gap, gapNow(running));
  }
  return {
    error: finite(watch.error()),
    gap: finite(gap),
    energyChange: finite(energyIn(which.scene, running) - before),
    contacts: running.contacts(),
    effects: running.effects(),
    hash: hashOf(which, running),
    ms: ms / which.seconds,
  };
}
