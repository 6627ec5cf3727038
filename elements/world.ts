import type * as Core from '../physics-core/index.js';
import { shown, type World as WorldObject } from '../physics-core/inside.js';

/** The first thing on the way of a ray in a page. */
export interface RayHit extends Core.RayHit {
  /** The element of `node`. */
  element: Element;
}

/** The world of elements: that of the core, which knows them. */
export interface World extends Core.World {
  /** By DEF or id in a page or one of its Inlines, or by element, plain or custom. */
  node<Type extends Core.Node = Core.Body>(
    nameOrElement: string | number | Element | null | undefined,
  ): Type | undefined;

  /** The first thing on the way between two points (world frame, metres), or null. */
  raycast(from: Core.Vector, to: Core.Vector): RayHit | null;
  /** The same, and with `water` the surface of a WaterVolume, whichever comes first. */
  raycast(
    from: Core.Vector,
    to: Core.Vector,
    also: { water?: boolean },
  ): RayHit | Omit<RayHit, 'collidable'> | null;
}

/** A world of the page as people see it. */
export const shownInPage = (world: WorldObject | undefined): World | undefined =>
  world && (shown(world) as World);
