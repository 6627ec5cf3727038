import type { JointNode } from '../../nodes/joint.js';
import type { World } from '../../world/world.js';
import { Effect } from '../effect.js';
import { Oscillator } from './oscillator.js';

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
 * Springs softer than what Bullet's solver can take as a row. Where nothing but joints and gravity acts, spring and
 * damper do exactly what they do in the time of the step. Where contacts bear the load, which are solved later, the
 * spring has the force of the step's start, so that what it carries sinks in as far as it should.
 */
export class Suspension extends Effect {
  readonly name = 'suspension';
  readonly #world: World;
  readonly #oscillator = new Oscillator();

  constructor(world: World) {
    super();
    this.#world = world;
  }

  override beforeStep(dt: number): void {
    const { rows } = this.#world.registry;
    for (const node of this.causes) {
      const joint = node as Sprung;
      if (!joint.spring || !rows.read(joint, dt)) continue;
      rows.look(joint.spring.row);
      rows.push(
        joint.spring.row,
        this.#change(joint, joint.spring, dt) / rows.inverseEffectiveMass,
      );
    }
  }

  /** What spring and damper do to the rate of their row. */
  #change(joint: Sprung, { row, stiffness, damping }: Spring, dt: number): number {
    const { rows, joints } = this.#world.registry;
    const { rate, inverseEffectiveMass } = rows;
    const x = rows.values[row]!;
    const [omega2, delta] = [
      stiffness * inverseEffectiveMass,
      (damping * inverseEffectiveMass) / 2,
    ];
    const oscillator = this.#oscillator;
    const body = joint.body1?.movable ? joint.body1 : joint.body2!;
    const starts = joints.lastStep(body) === 0;
    if (!starts && !joints.alone(body)) return Math.expm1(-2 * delta * dt) * rate - omega2 * x * dt;
    if (starts) oscillator.start(omega2, delta, dt);
    else oscillator.goOn(omega2, delta, dt);
    // A body's first step takes half of all forces.
    const share = starts ? 0.5 : 1;
    const change = (oscillator.kept - 1) * rate - oscillator.pull * x;
    return (change + (oscillator.load - share * dt) * rows.pull(row)) / share;
  }
}
