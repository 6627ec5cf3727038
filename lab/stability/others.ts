import { ammo } from '../engines/ammo.js';
import { cannon } from '../engines/cannon.js';
import type { Engine } from '../engines/engine.js';
import { jolt } from '../engines/jolt.js';
import { rapier } from '../engines/rapier.js';
import type { Cell, StabilityCase } from './case.js';
import type { Told } from './told.js';

/** With the step of `standard` and the iterations that they have by themselves. */
export const OTHERS: [engine: Engine, name: string, iterations: number][] = [
  [ammo, 'raw Ammo', 10],
  [jolt, 'Jolt', 10],
  [rapier, 'Rapier', 4],
  [cannon, 'cannon-es', 10],
];
const STEP = 1 / 120;

/** Judged by the case's own criterion alone. */
export async function runOther(
  { seconds, criterion }: StabilityCase,
  { scene, look }: Told,
  [engine, , iterations]: (typeof OTHERS)[number],
): Promise<Cell> {
  const running = await engine.make(scene, { step: STEP, iterations });
  const now = look(running);
  let measured = 0;
  for (let i = 0; i < seconds / STEP && !Number.isNaN(measured); i++) {
    running.step();
    const found = now();
    measured = Number.isNaN(found) ? NaN : Math.max(measured, found);
  }
  running.destroy();
  return { holds: measured <= criterion.most, measured };
}
