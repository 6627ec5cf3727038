import { ammo } from './ammo.js';
import { cannon } from './cannon.js';
import type { Engine } from './engine.js';
import { jolt } from './jolt.js';
import { ours } from './ours.js';
import { rapier } from './rapier.js';
import { xIte } from './x-ite.js';

export const engines: readonly Engine[] = [ours, ammo, xIte, cannon, rapier, jolt];
