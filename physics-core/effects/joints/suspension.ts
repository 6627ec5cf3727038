import { expm1 } from '../../base/exact/expm1.js';
import type { Joint, Spring } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Effects } from '../effect/effects.js';
import { JointRows } from './joint-rows.js';
import { jointSolve } from './effects.js';
import { Effect } from '../effect/effect.js';
import { Oscillator } from './oscillator.js';

/**
 * Springs softer than what Bullet's solver can take as a row. Where nothing but joints and gravity acts, spring and
 * damper do exactly what they do in the time of the step. Where contacts bear the load, which are solved later, the
 * spring has the force of the step's start, so that what it carries sinks in as far as it should.
 */
export class Suspension extends Effect {
  readonly #effects: Effects;
  readonly #rows: JointRows;
  readonly #oscillator = new Oscillator();

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#effects = effects;
    this.#rows = new JointRows(simulation);
  }

  override beforeStep(dt: number): void {
    const rows = this.#rows;
    for (const node of this.inOrder) {
      const joint = node as Joint;
      if (!joint.spring || !rows.read(joint, dt)) continue;
      rows.look(joint.spring.row);
      rows.push(
        joint.spring.row,
        this.#change(joint, joint.spring, dt) / rows.inverseEffectiveMass,
      );
    }
  }

  /** What spring and damper do to the rate of their row. */
  #change(joint: Joint, { row, stiffness, damping }: Spring, dt: number): number {
    const rows = this.#rows;
    const joints = this.#effects.get(jointSolve);
    const { rate, inverseEffectiveMass } = rows;
    const x = rows.values[row]!;
    const omega2 = stiffness * inverseEffectiveMass;
    const delta = (damping * inverseEffectiveMass) / 2;
    const oscillator = this.#oscillator;
    const body = joint.body1?.movable ? joint.body1 : joint.body2!;
    const starts = joints.lastStep(body) === 0;
    if (!starts && !joints.alone(body)) return expm1(-2 * delta * dt) * rate - omega2 * x * dt;
    if (starts) oscillator.start(omega2, delta, dt);
    else oscillator.goOn(omega2, delta, dt);
    // A body's first step takes half of all forces.
    const share = starts ? 0.5 : 1;
    const change = (oscillator.kept - 1) * rate - oscillator.pull * x;
    return (change + (oscillator.load - share * dt) * rows.pull(row)) / share;
  }
}
