import type { Pose } from '../base/math.js';
import type { Outline } from '../shapes/outline.js';
import type { Geometry } from '../shapes/geometry.js';
import type { SimulationNode } from './node.js';

/** What makes the shape of a body, and is a member of CollisionCollections. */
export type Collidable = SimulationNode;

/** A geometry and its pose in the body's frame. */
export interface CollidablePart {
  geometry: Geometry;
  pose: Pose;
  collidable: Collidable;
  /** Made as triangles; Bullet numbers those, not the part. */
  mesh?: boolean;
  /** What it is exactly; undefined where it has no shape in Bullet. */
  outline?: Outline;
}
