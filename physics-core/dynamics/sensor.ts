import type { Collidable } from './collidable.js';
import type { Collider } from './pairs.js';
import type { SimulationNode } from './node.js';

/** Is told after each step what touches among the members of a collider. */
export interface Sensor extends SimulationNode {
  readonly collider: Collider | undefined;
  beginSensing(): void;
  noteTouch(first: Collidable, second: Collidable): void;
  finishSensing(): void;
}
