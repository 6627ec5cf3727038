import { ammo } from '../engines/ammo.js';
import { cannon } from '../engines/cannon.js';
import type { Engine, Setting } from '../engines/engine.js';
import { jolt } from '../engines/jolt.js';
import { rapier } from '../engines/rapier.js';
import { xIte } from '../engines/x-ite.js';
import type { Cell, StabilityCase } from './case.js';
import type { Told } from './told.js';

/** Another engine, and how it is set: with the iterations that it has by itself. */
export interface Other {
  engine: Engine;
  name: string;
  setting: Setting;
}

/** Of `standard`. */
const step = 1 / 120;

export const OTHERS: Other[] = [
  { engine: ammo, name: 'raw Ammo', setting: { step, iterations: 10 } },
  // A frame of 1/60 s in ten, as X_ITE does by itself.
  { engine: xIte, name: "X_ITE's rule", setting: { step: 1 / 600, iterations: 10 } },
  { engine: jolt, name: 'Jolt', setting: { step, iterations: 10 } },
  { engine: rapier, name: 'Rapier', setting: { step, iterations: 4 } },
  { engine: cannon, name: 'cannon-es', setting: { step, iterations: 10 } },
];

/** Judged by the case's own criterion alone. */
export async function runOther(
  { seconds, criterion }: StabilityCase,
  { scene, play }: Told,
  { engine, setting }: Other,
): Promise<Cell> {
  const running = await engine.make(scene, setting);
  const { after, measured, noted } = play(running);
  const steps = Math.round(seconds / running.timeStep);
  for (let i = 0; i < steps && !Number.isNaN(measured()); i++) {
    running.step();
    after?.();
  }
  running.destroy();
  const found = measured();
  return {
    holds: found <= criterion.most,
    measured: found,
    ...(noted && { noted: noted() }),
  };
}
