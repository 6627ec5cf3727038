import { levels } from '../../physics-core/inside.js';
import type { CaseScene } from '../case.js';
import { ammo } from '../engines/ammo.js';
import { NotOffered, type Engine, type Running } from '../engines/engine.js';
import { jolt } from '../engines/jolt.js';
import { ours } from '../engines/ours.js';
import { rapier } from '../engines/rapier.js';

/** Who takes turns, in this order. */
export const engines: readonly Engine[] = [ours, ammo, rapier, jolt];

export const levelNames: readonly string[] = levels.map(({ name }) => name);

/** Ours at a level; others with its step and the iterations that they have by themselves. */
function settingOf(engine: Engine, level: string) {
  const own = ours.settings.find((setting) => setting.level === level)!;
  if (engine === ours) return own;
  return { step: own.step, iterations: engine.settings[0]!.iterations };
}

/** The scene in an engine that never rests; what the engine lacks where it has no words for it. */
export async function running(
  engine: Engine,
  scene: CaseScene,
  level: string,
): Promise<Running | string> {
  try {
    return await engine.make(scene, settingOf(engine, level));
  } catch (error) {
    if (error instanceof NotOffered) return error.message;
    throw error;
  }
}
