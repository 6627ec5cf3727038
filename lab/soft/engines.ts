import { ammo } from './ammo.js';
import type { SoftEngine } from './engine.js';
import { jolt } from './jolt.js';
import { ours } from './ours.js';

/** Who is measured, in the order of tables and pictures. */
export const softEngines: readonly SoftEngine[] = [ours, jolt, ammo];

export const others: readonly SoftEngine[] = [jolt, ammo];
