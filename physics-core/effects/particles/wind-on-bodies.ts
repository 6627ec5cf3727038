import { isHeld } from '../../dynamics/jointed.js';
import { compose7 } from '../../base/flat-math.js';
import { grown } from '../../base/grown.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { same } from '../../engine/free-fall.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { BodySilhouette } from '../../dynamics/body-silhouette.js';
import { FREE, HELD, WindPush } from './wind-push.js';
import type { Wind } from './wind.js';

const NOTHING = new Float64Array(3);

const now = new Float64Array(VELOCITY);
const before = new Float64Array(POSE);
const after = new Float64Array(POSE);
/** What gravity and its author's forces give to a body in half of the step, m/s. */
const half = new Float64Array(3);

/**
 * Winds push bodies by a steady force in each step, which what they hang on or stand on feels, too. Of a body on which, as
 * its velocity shows, nothing else acted but gravity and its author's forces it is known how it gives way: that is put in the
 * place of what the force has done.
 */
export class WindOnBodies {
  readonly #simulation: Simulation;
  /** By slot. */
  readonly #silhouettes: (BodySilhouette | undefined)[] = [];
  readonly #held: WindPush;
  readonly #free: WindPush;
  /** That were pushed in this step; by slot, what the force is to give them. */
  readonly #blown: Body[] = [];
  #gains = new Float64Array(16 * VELOCITY);

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
    this.#held = new WindPush(simulation, HELD);
    this.#free = new WindPush(simulation, FREE);
  }

  /** What rests stood in the winds that there were. */
  wake(): void {
    const { bodies } = this.#simulation;
    const { slots, pointers, asleep } = bodies.moving;
    for (let slot = 0; slot < slots; slot++)
      if (pointers[slot] !== 0 && asleep[slot] === 1) bodies.in(slot)?.wake();
  }

  /** In a step of Bullet that begins, `dt` seconds. */
  blow(winds: readonly Wind[], dt: number): void {
    const { bodies } = this.#simulation;
    const { slots, pointers, asleep } = bodies.moving;
    this.#blown.length = 0;
    if (this.#gains.length < slots * VELOCITY)
      this.#gains = grown(this.#gains, 2 * slots * VELOCITY);
    for (let slot = 0; slot < slots; slot++) {
      const body = pointers[slot] !== 0 && asleep[slot] === 0 ? bodies.in(slot) : undefined;
      if (!body) continue;
      this.#held.reckon(body, this.#silhouetteOf(body), winds, dt, NOTHING);
      this.#give(body, dt);
      this.#blown.push(body);
    }
  }

  #silhouetteOf(body: Body): BodySilhouette {
    const known = this.#silhouettes[body.slot];
    if (known?.isOf(body)) return known;
    return (this.#silhouettes[body.slot] = new BodySilhouette(body));
  }

  #give({ body, slot, mass }: Body, dt: number): void {
    const { scratch } = this.#simulation.engine;
    const { gain, moment } = this.#held;
    const share = mass.mass / dt;
    body.applyCentralForce(scratch.vector(gain[0]! * share, gain[1]! * share, gain[2]! * share));
    body.applyTorque(scratch.vector(moment[0]! / dt, moment[1]! / dt, moment[2]! / dt));
    this.#gains.set(gain, slot * VELOCITY);
  }

  /** When Bullet has taken that step. */
  settle(winds: readonly Wind[], dt: number): void {
    for (const body of this.#blown) {
      if (isHeld(body) || body.dampedShare.linear > 0 || !this.#isFree(body, dt)) continue;
      this.#free.reckon(body, this.#silhouetteOf(body), winds, dt, half);
      this.#place(body, dt);
      this.#hasten(body);
    }
    this.#blown.length = 0;
  }

  #isFree({ pointer, slot, mass, appliedGravity, constantLoad }: Body, dt: number): boolean {
    const { engine, bodies } = this.#simulation;
    const { force } = constantLoad;
    const at = slot * VELOCITY;
    engine.reader.velocity(pointer, now, 0);
    for (let i = 0; i < 3; i++) {
      half[i] = ((appliedGravity[i]! + force[i]! / mass.mass) * dt) / 2;
      const gain = 2 * half[i]! + this.#gains[at + i]!;
      if (!same(now[i]!, bodies.velocities[at + i]!, gain)) return false;
    }
    return true;
  }

  /** Where it goes, from where it was when the step began. */
  #place({ pointer, slot, centerOfMass }: Body, dt: number): void {
    const { engine, poses, bodies } = this.#simulation;
    compose7(before, 0, poses.current, slot * POSE, centerOfMass);
    engine.reader.pose(pointer, after, 0);
    for (let i = 0; i < 3; i++) {
      const way = (bodies.velocities[slot * VELOCITY + i]! + half[i]!) * dt + this.#free.gone[i]!;
      after[i] = way - (after[i]! - before[i]!);
    }
    engine.reader.shift(pointer, after[0]!, after[1]!, after[2]!);
  }

  #hasten({ body, slot }: Body): void {
    const { scratch } = this.#simulation.engine;
    const at = slot * VELOCITY;
    for (let i = 0; i < VELOCITY; i++)
      now[i] = now[i]! + (this.#free.gain[i]! - this.#gains[at + i]!);
    body.setLinearVelocity(scratch.vector(now[0]!, now[1]!, now[2]!));
    body.setAngularVelocity(scratch.vector(now[3]!, now[4]!, now[5]!));
  }
}
