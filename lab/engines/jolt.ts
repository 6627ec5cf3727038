import initJolt from 'jolt-physics/wasm-compat';
import type { CaseScene } from '../case.js';
import { sweep, type Engine, type Running, type Setting } from './engine.js';
import type { Jolt } from './jolt-joints.js';
import { JoltScene } from './jolt-scene.js';
import { plansOf } from './joints.js';

let loading: Promise<Jolt> | undefined;

async function make(scene: CaseScene, { step, iterations }: Setting): Promise<Running> {
  const plans = plansOf(scene);
  const made = new JoltScene(await (loading ??= initJolt()), scene);
  try {
    made.iterations = iterations;
    for (const body of scene.bodies) made.add(body);
    for (const plan of plans.joints) made.join(plan);
    for (const push of plans.pushes) made.push(push);
  } catch (error) {
    made.destroy();
    throw error;
  }
  return made.running(step);
}

export const jolt: Engine = {
  id: 'jolt',
  name: 'Jolt',
  says: 'Jolt 5 (jolt-physics 1.1), its defaults (10 velocity steps) and 50 velocity steps, gyroscopic force on.',
  settings: sweep([10, 50]),
  make,
};
