import type { SheetSolid } from './collide/sheet.js';

/** How particles of a system meet bodies and walls. */
export interface Surface {
  /** Whether they meet bodies, and the mass by which each pushes them, kg: 0 pushes nothing. */
  bodies: boolean;
  mass: number;
  /** What throws them back with the speed with which they came; undefined: nothing. */
  walls: SheetSolid | undefined;
  /** Of the balls that are met, metres. */
  radius: number;
  /** Share of the approach speed that comes back. */
  bounce: number;
  /** Coulomb's. */
  friction: number;
}
