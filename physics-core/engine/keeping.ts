import type { Ammo } from './ammo.js';
import type { BulletWorld } from './bullet-world.js';
import type { KeptWorld } from './kept-world.js';
import type { SolveOrder } from './solve-order.js';

/** What comes with the code of contacts: without them bodies are all that a world goes back to, and nothing is solved. */
export const keeping: {
  of?: (bullet: BulletWorld, broadphase: number) => KeptWorld;
  orderOf?: (ammo: Ammo, world: number, dispatcher: number) => SolveOrder;
} = {};
