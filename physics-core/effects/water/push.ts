import { sin } from '../../base/exact/index.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Flat } from '../../shapes/cut/cut.js';
import { BodyFrame } from './body-frame.js';
import type { BodyInWater } from './body-in-water.js';
import { SIX, solveSix } from './six.js';
import { HASTY } from './tolerances.js';
import type { Volume } from './volume.js';
import { Wetting } from './wetting.js';

const load = new Float64Array(3);
const weight = new Float64Array(3);
const matrix = new Float64Array(SIX * SIX);
const after = new Float64Array(SIX);
const inertia = new Float64Array(SIX);
const push = new Float64Array(SIX);

/**
 * What water does to a body in a step.
 *
 * It lifts it by the weight of what it displaces (Archimedes), where the body is in the middle of the step if it moves
 * freely: so heaving keeps its energy (leapfrog). Of what a stiff surface does in a long step that share counts which a
 * spring would give on average, so that what heaves a little has the right period at any step, and nothing is flung.
 * Drag grows with the square of the speed: its rate at the start of the step, used for all of it, is exact for drag alone
 * and at the terminal speed, and never turns a motion round.
 */
export class WaterPush {
  readonly #simulation: Simulation;
  readonly #frame = new BodyFrame();
  readonly wetting = new Wetting();
  /** World frame: newtons and newton metres. */
  readonly force: Flat = new Float64Array(3);
  readonly torque: Flat = new Float64Array(3);
  /** World frame: what a free body gains in the step with its weight, m/s. */
  readonly gain: Flat = new Float64Array(3);

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  /** False: it is in none. `free`: nothing else was seen to act on it but its weight. */
  reckon(
    body: Body,
    shape: BodyInWater,
    volumes: readonly Volume[],
    dt: number,
    free: boolean,
  ): boolean {
    const { mass, moments } = body.mass;
    const frame = this.#frame;
    frame.take(body, this.#simulation, free ? dt / 2 : 0);
    this.#wet(body, shape, volumes, frame.velocity, dt);
    if (!(this.wetting.volume > 0)) return false;
    for (let k = 0; k < 3; k++) {
      inertia[k] = mass;
      inertia[3 + k] = moments[k]!;
      load[k] = mass * body.appliedGravity[k]! + body.constantLoad.force[k]!;
    }
    frame.inward(load, 0, weight, 0);
    const { lift, stiffness, addedMass } = this.wetting;
    const even = evenShare((stiffness * dt * dt) / (mass + addedMass));
    for (let k = 0; k < SIX; k++) push[k] = even * (lift[k]! + (k < 3 ? weight[k]! : 0));
    if (free) this.#move(dt, this.#rushes(body, shape, volumes, dt));
    else this.#hold(dt);
    return true;
  }

  #wet(
    body: Body,
    shape: BodyInWater,
    volumes: readonly Volume[],
    velocity: Flat,
    dt: number,
  ): void {
    this.wetting.clear();
    for (const volume of volumes)
      this.wetting.add(volume, shape, body.mass, body.reach, this.#frame, velocity);
    this.wetting.bound(body.mass.mass);
    this.wetting.giveWay(dt);
  }

  /**
   * What is light may gain so much speed within the step that drag as of its start would hold nothing: then it is that of
   * the speed at the end. The share of the drag at the speed that it would have without that; 1: as of the start.
   */
  #rushes(body: Body, shape: BodyInWater, volumes: readonly Volume[], dt: number): number {
    const { velocity } = this.#frame;
    let before = 0;
    let rushed = 0;
    for (let k = 0; k < SIX; k++) {
      after[k] = velocity[k]! + (push[k]! * dt) / inertia[k]!;
      if (k > 2) continue;
      before += velocity[k]! ** 2;
      rushed += after[k]! ** 2;
    }
    if (!(rushed > before)) return 1;
    let most = 0;
    for (const { settings } of volumes) most = Math.max(most, settings.density * settings.drag);
    const bound = (most * shape.skin.area * Math.sqrt(rushed) * dt) / 2 / body.mass.mass;
    if (bound < HASTY) return 1;
    this.#wet(body, shape, volumes, after, dt);
    return 2 / (1 + Math.sqrt(1 + 4 * this.#rateAlong(after, dt)));
  }

  /** How many times over its resistance would stop such a motion in the step. */
  #rateAlong(motion: Flat, dt: number): number {
    const { resistance } = this.wetting;
    let power = 0;
    let energy = 0;
    for (let i = 0; i < SIX; i++) {
      for (let j = 0; j < SIX; j++) power += motion[i]! * resistance[SIX * i + j]! * motion[j]!;
      energy += inertia[i]! * motion[i]! ** 2;
    }
    return energy > 0 ? (power * dt) / energy : 0;
  }

  /** The same of the motion that it would stop first. */
  #rate(dt: number): number {
    let rate = 0;
    for (let k = 0; k < SIX; k++)
      rate = Math.max(rate, (this.wetting.resistance[7 * k]! * dt) / inertia[k]!);
    return rate;
  }

  /** It goes on freely: (M + D dt) u' = M u + (push + drift) dt. */
  #move(dt: number, share: number): void {
    const { velocity } = this.#frame;
    const { resistance, drift, addedMass } = this.wetting;
    for (let i = 0; i < SIX; i++) {
      for (let j = 0; j < SIX; j++) matrix[SIX * i + j] = share * resistance[SIX * i + j]! * dt;
      const heavy = inertia[i]! + (i < 3 ? addedMass : 0);
      matrix[7 * i] = matrix[7 * i]! + heavy;
      after[i] = heavy * velocity[i]! + (push[i]! + share * drift[i]!) * dt;
    }
    solveSix(matrix, after);
    for (let k = 0; k < SIX; k++) {
      after[k] = after[k]! - velocity[k]!;
      push[k] = (inertia[k]! * after[k]!) / dt - (k < 3 ? weight[k]! : 0);
    }
    this.#frame.outward(after, 0, this.gain, 0);
    this.#tell();
  }

  /** Something may hold it: it feels all, as long as that would not stop it within the step. */
  #hold(dt: number): void {
    const { velocity } = this.#frame;
    const { resistance, drift } = this.wetting;
    const rate = this.#rate(dt);
    const felt = 1 / Math.sqrt(1 + rate * rate);
    for (let i = 0; i < SIX; i++) {
      let braked = drift[i]!;
      for (let j = 0; j < SIX; j++) braked -= resistance[SIX * i + j]! * velocity[j]!;
      push[i] = push[i]! + felt * braked - (i < 3 ? weight[i]! : 0);
      after[i] = ((push[i]! + (i < 3 ? weight[i]! : 0)) * dt) / inertia[i]!;
    }
    this.#frame.outward(after, 0, this.gain, 0);
    this.#tell();
  }

  #tell(): void {
    this.#frame.outward(push, 0, this.force, 0);
    this.#frame.outward(push, 3, this.torque, 0);
  }
}

/**
 * The share of a spring's force with which leapfrog has its period exactly, where it turns by h radians in a step: the square
 * of sin(h / 2) / (h / 2), up to half a turn. Beyond that no step can show it, and it stays as it is.
 */
function evenShare(square: number): number {
  if (!(square > 0)) return 1;
  const half = Math.sqrt(square) / 2;
  return half < Math.PI / 2 ? (sin(half) / half) ** 2 : 1 / (half * half);
}
