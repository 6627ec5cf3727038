import { exp } from '../../base/exact/index.js';
import { compose, conjugate, rotate } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { areEqualMoments } from '../../dynamics/moments.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { Effect, type EffectDescriptor } from '../effect/effect.js';

/**
 * X3D's angular damping is a torque, -factor × spin, so a body has as many rates as moments. Bullet's damping has one:
 * where the moments differ, this effect damps each axis by itself.
 */
export class AxisDamping extends Effect {
  readonly #simulation: Simulation;

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  override beforeStep(dt: number): void {
    for (const node of this.causes) {
      const body = node as Body;
      if (body.active && !body.sleeping) this.#damp(body, dt);
    }
  }

  #damp(body: Body, dt: number): void {
    const { angular } = body.velocityAtOrigin();
    const { q } = compose(body.pose(), body.centerOfMass);
    const local = rotate(conjugate(q), angular).map(
      (w, i) => w * exp((-body.angularDamping * dt) / body.mass.moments[i]!),
    ) as Vec3;
    body.body.setAngularVelocity(this.#simulation.engine.scratch.vector(...rotate(q, local)));
  }
}

export const axisDamping: EffectDescriptor<AxisDamping> = {
  name: 'axis damping',
  causes: 'autoDamp with an angularDampingFactor on a body of unequal moments of inertia',
  body: {
    on: ['mass', 'damping'],
    reason: ({ angularDamping, mass }) =>
      angularDamping > 0 && !areEqualMoments(mass.moments)
        ? 'angularDampingFactor on unequal moments'
        : undefined,
  },
  load: (simulation) => new AxisDamping(simulation),
};
