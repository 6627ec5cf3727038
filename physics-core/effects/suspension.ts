import type { JointNode } from '../nodes/joint.js';
import type { World } from '../world/world.js';
import { Effect } from './effect.js';

/** A row of a joint that a spring and a damper hold at zero. */
export interface Spring {
  row: number;
  /** N/m. */
  stiffness: number;
  /** N s/m. */
  damping: number;
}

/** Joints that have one; undefined while a stiffer row of Bullet's own stands for it. */
interface Sprung extends JointNode {
  readonly spring: Spring | undefined;
}

/**
 * Springs softer than what Bullet's solver can take as a row. The force of the spring is the one it has at the step's
 * start, so that what it carries sinks in as far as it should even where contacts and other joints bear the load; the
 * damper takes its exact share of the rate, whatever its strength.
 */
export class Suspension extends Effect {
  readonly name = 'suspension';
  readonly #world: World;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  override beforeStep(dt: number): void {
    const { rows } = this.#world.registry;
    for (const node of this.causes) {
      const joint = node as Sprung;
      if (!joint.spring || !rows.read(joint, dt)) continue;
      const { row, stiffness, damping } = joint.spring;
      rows.look(row);
      const damped = (rows.rate * -Math.expm1(-damping * rows.ease * dt)) / rows.ease;
      rows.push(row, -stiffness * rows.values[row]! * dt - damped);
    }
  }
}
