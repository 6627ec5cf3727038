import type { Drag, Vector } from '../physics-core/index.js';
import type { PhysicsNode } from '../physics-core/inside.js';
import { X3DNodeElement } from './node-element.js';

/** The node of a rope, a cloth or a soft body, and what its element hands on to it. */
type SoftNode = PhysicsNode & { drag(point: Vector): Drag | undefined };

/** The methods of ropes, cloth and soft bodies; before they run they do nothing. */
export class X3DSoftElement extends X3DNodeElement {
  /** Takes hold of it at the place nearest to a point of the world, metres, until `end` or `cancel`. */
  drag(point: Vector): Drag | undefined {
    return (this.binding.node as SoftNode | null)?.drag(point);
  }
}
