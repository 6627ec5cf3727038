import { writeAxes } from '../../base/matrix.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { between } from './collide/between.js';

/** Where the emitter of a system stands during a step, and how that moves: with a body, or in the world. */
export class EmitterPlace {
  readonly #simulation: Simulation;
  readonly #pose = new Float64Array(POSE);
  /** Columns: how the body's frame is turned. */
  readonly #axes = new Float64Array(9);
  readonly #arm = new Float64Array(3);
  /** Of the body's origin: linear, then angular. */
  readonly #velocity = new Float64Array(6);

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  /** The body moved so in the step that was taken; one that is not simulated stands. */
  begin(body: Body): void {
    if (!body.active) {
      this.#velocity.fill(0);
      return;
    }
    const { linear, angular } = body.velocityAtOrigin();
    this.#velocity.set(linear);
    this.#velocity.set(angular, 3);
  }

  /**
   * What is born in a body's frame is born in the world, moving with it; `share`: of the step that was taken. Returns the
   * velocity with which it is thrown from there, in the world.
   */
  carry(body: Body, share: number, birth: Float64Array): Float64Array {
    this.#stand(body.slot, share);
    this.#turn(birth, 0, this.#arm);
    const [ox, oy, oz] = this.#simulation.poses.origin;
    const pose = this.#pose;
    const arm = this.#arm;
    birth[0] = ox + pose[0]! + arm[0]!;
    birth[1] = oy + pose[1]! + arm[1]!;
    birth[2] = oz + pose[2]! + arm[2]!;
    this.#addSpeed(birth);
    return this.#arm;
  }

  #stand(slot: number, share: number): void {
    const { previous, current } = this.#simulation.poses;
    between(previous, current, slot * POSE, share, this.#pose);
    writeAxes(this.#axes, this.#pose, 3);
  }

  #turn(vector: Float64Array, at: number, out: Float64Array): void {
    const axes = this.#axes;
    const x = vector[at]!;
    const y = vector[at + 1]!;
    const z = vector[at + 2]!;
    for (let i = 0; i < 3; i++) out[i] = axes[i]! * x + axes[3 + i]! * y + axes[6 + i]! * z;
  }

  /** Its own speed is in the body's frame; that of the body's origin, and what its turning adds, come to it. */
  #addSpeed(birth: Float64Array): void {
    const velocity = this.#velocity;
    const arm = this.#arm;
    const wx = velocity[3]!;
    const wy = velocity[4]!;
    const wz = velocity[5]!;
    const x = arm[0]!;
    const y = arm[1]!;
    const z = arm[2]!;
    this.#turn(birth, 3, arm);
    birth[3] = arm[0]! + velocity[0]! + wy * z - wz * y;
    birth[4] = arm[1]! + velocity[1]! + wz * x - wx * z;
    birth[5] = arm[2]! + velocity[2]! + wx * y - wy * x;
  }
}
