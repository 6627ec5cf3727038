import { add } from '../../base/math.js';
import type { Body, Load } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { Effect, type Cause, type EffectDescriptor, type Numbered } from '../effect/effect.js';

const isZero = (v: Vec3): boolean => v[0] === 0 && v[1] === 0 && v[2] === 0;

/** RigidBody.forces and torques in every step, and what `applyForce` and `applyTorque` ask for the next one. */
export class AuthoredForces extends Effect {
  readonly #simulation: Simulation;
  readonly #constant = new Set<Body>();
  readonly #once = new Map<Body, Load>();

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  /** Its `forces` or `torques` are others. */
  override need(body: Body, reason: string): void {
    this.#constant.add(body);
    super.need(body, reason);
  }

  override release(body: Body): void {
    this.#constant.delete(body);
    if (!this.#once.has(body)) super.release(body);
  }

  push(body: Body, force: Vec3, torque: Vec3): void {
    const before = this.#once.get(body) ?? { force: [0, 0, 0], torque: [0, 0, 0] };
    this.#once.set(body, { force: add(before.force, force), torque: add(before.torque, torque) });
    if (!this.#constant.has(body)) super.need(body, 'applyForce');
  }

  override reset(): void {
    for (const body of this.#once.keys()) if (!this.#constant.has(body)) super.release(body);
    this.#once.clear();
  }

  override save(): [id: number, load: Load][] | undefined {
    if (this.#once.size === 0) return undefined;
    return [...this.#once].map(([{ id }, load]) => [id, structuredClone(load)]);
  }

  override load(saved: readonly [id: number, load: Load][], nodes: Numbered): void {
    for (const [id, { force, torque }] of saved) {
      const body = nodes.body(id);
      if (body) this.push(body, force, torque);
    }
  }

  /** What waits for the next step. */
  pending(body: Body): Load | undefined {
    return this.#once.get(body);
  }

  override unmade(node: Cause): void {
    this.#once.delete(node as Body);
    this.release(node as Body);
  }

  override beforeStep(): void {
    for (const body of this.#constant) this.#apply(body, body.constantLoad);
    for (const [body, load] of this.#once) this.#apply(body, load);
  }

  #apply(body: Body, { force, torque }: Load): void {
    if (!body.active || !body.movable || body.sleeping) return;
    const { scratch } = this.#simulation.engine;
    body.body.applyCentralForce(scratch.vector(...force));
    body.body.applyTorque(scratch.vector(...torque));
  }

  /** What was asked for one step is spent. */
  override stepOver(): void {
    for (const body of this.#once.keys()) if (!this.#constant.has(body)) super.release(body);
    this.#once.clear();
  }
}

export const forces: EffectDescriptor<AuthoredForces> = {
  name: 'forces',
  causes: 'forces or torques of a RigidBody, applyForce and applyTorque',
  body: {
    on: ['load'],
    reason({ constantLoad: { force, torque } }) {
      if (!isZero(force)) return 'forces';
      return isZero(torque) ? undefined : 'torques';
    },
  },
  load: (simulation) => new AuthoredForces(simulation),
};
