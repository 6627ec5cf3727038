import { doublesOf, pack } from '../../base/packed.js';
import { atan2, hypot } from '../../base/exact/index.js';
import type { Body } from '../../dynamics/body.js';
import { turnsAlike } from '../../dynamics/moments.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { Effect, type Cause, type EffectDescriptor, type Numbered } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { jointSolve } from '../joints/effects.js';
import {
  applyInertia,
  applyInverseInertia,
  cross3,
  dot3,
  multiply4,
  writeTurn,
} from '../../base/flat-math.js';
import { writeAxes } from '../../base/matrix.js';
import { topOf, turnFreely, type Top } from './top.js';

/** Radians per step below which the torque is left out: it grows with the square. */
const SLOW = 1e-3;

/**
 * Thinness times the square of the radians per step. Kept as momentum, a turn that a joint forbids comes back half so
 * many times as large in the next step: from 2 on it grows without bound.
 */
const MOST_TURN = 1;

/** Of a body in this step. */
export interface Spin {
  momentum: Float64Array;
  /** The spin given to Bullet for the step, and the one that belongs to the momentum at its end. */
  given: Float64Array;
  end: Float64Array;
  /** The spin left to Bullet: as long as it stands, the momentum is known better than from there. */
  left: Float64Array;
  /** Its orientation and its axes at the start of the step. */
  from: Float64Array;
  axes: Float64Array;
  /** It turns little enough in the step that what joints and contacts give it may be kept as momentum. */
  slow: boolean;
  /** It was pushed evenly in the step. */
  even: boolean;
  /** By how much its spin then came out otherwise than `end` and the push say: the push turned it, and its axes with it. */
  missed: Float64Array;
  /** It is turned aside: its axes are elsewhere at the end. */
  beyond: boolean;
  /** By how much it is turned aside, radians; `displaced` where its spin does not turn along. */
  aside: Float64Array;
  displaced: Float64Array;
}

/**
 * Bullet keeps the spin of a free body; nature keeps its angular momentum. Before each step this gives the body the one
 * spin that turns it as far as its free motion would, after it the change to the spin at the end of that motion. What
 * joints did meanwhile, or contacts that it turns about, is added to the momentum; what other contacts did, to the spin (as
 * momentum it would spin up thin bodies). The motion is that of a round top, which is known exactly, with half a turn for what is uneven before and
 * after it: momentum is kept to rounding, however thin the body and fast the spin, and the axis wanders as it should.
 */
export class Gyroscopic extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #tops = new Map<Body, Top>();
  readonly #spinning = new Map<Body, Spin>();
  readonly #pose = new Float64Array(POSE);
  readonly #velocity = new Float64Array(6);
  readonly #axes = new Float64Array(9);
  readonly #spin = new Float64Array(3);
  readonly #change = new Float64Array(3);
  readonly #orientation = new Float64Array(4);
  readonly #turn = new Float64Array(4);

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
  }

  /** Its mass, inertia or mobility may be others. */
  override need(body: Body, reason: string): void {
    this.forget(body);
    this.#tops.set(body, topOf(body.mass.moments));
    super.need(body, reason);
  }

  override release(node: Cause): void {
    super.release(node);
    this.#tops.delete(node as Body);
    this.forget(node as Body);
  }

  /** It jumps and keeps its spin: with another pose that is another momentum. */
  forget(body: Body): void {
    this.#spinning.delete(body);
  }

  override reset(): void {
    this.#spinning.clear();
  }

  override save(): [id: number, kept: string][] | undefined {
    if (this.#spinning.size === 0) return undefined;
    return [...this.#spinning].map(([{ id }, { momentum, left, missed, even }]) => [
      id,
      pack(Float64Array.of(...momentum, ...left, ...missed, +even)),
    ]);
  }

  override load(saved: readonly [id: number, kept: string][], nodes: Numbered): void {
    for (const [id, kept] of saved) {
      const body = nodes.body(id);
      if (!body || !this.#tops.has(body)) continue;
      const numbers = doublesOf(kept);
      const spin = newSpin();
      spin.momentum.set(numbers.subarray(0, 3));
      spin.left.set(numbers.subarray(3, 6));
      spin.missed.set(numbers.subarray(6, 9));
      spin.even = numbers[9] === 1;
      this.#spinning.set(body, spin);
    }
  }

  /** It is turned aside within the step, by so many radians, and that is no motion: its spin turns along. */
  turnAside(body: Body, radians: Float64Array, at: number): void {
    const state = this.#spinning.get(body);
    if (!state) return;
    for (let i = 0; i < 3; i++) state.aside[i] = radians[at + i]!;
    state.beyond = true;
  }

  /** The spin that it was given for this step; undefined: its own. */
  given(body: Body): Float64Array | undefined {
    return this.#spinning.get(body)?.given;
  }

  /** What is known of it in this step; undefined: it hardly turns. */
  spinOf(body: Body): Spin | undefined {
    return this.#spinning.get(body);
  }

  topOf(body: Body): Top {
    return this.#tops.get(body)!;
  }

  override beforeStep(dt: number): void {
    for (const [body, top] of this.#tops) {
      if (body.active && !body.sleeping) this.#lead(body, top, dt);
      // What wakes within the step has a spin that none of this is about.
      else this.#spinning.delete(body);
    }
  }

  override afterStep(): void {
    for (const [body, spin] of this.#spinning)
      if (body.active && !body.sleeping) this.#follow(body, spin);
  }

  #read({ pointer }: Body): void {
    const { reader } = this.#simulation.engine;
    reader.pose(pointer, this.#pose, 0);
    reader.velocity(pointer, this.#velocity, 0);
    writeAxes(this.#axes, this.#pose, 3);
  }

  #lead(body: Body, top: Top, dt: number): void {
    this.#read(body);
    const v = this.#velocity;
    const turn = hypot(v[3]!, v[4]!, v[5]!) * dt;
    if (turn < SLOW) {
      this.#spinning.delete(body);
      return;
    }
    const state = this.#spinning.get(body) ?? newSpin();
    this.#spinning.set(body, state);
    const { momentum, given, left } = state;
    state.axes.set(this.#axes);
    for (let i = 0; i < 4; i++) state.from[i] = this.#pose[3 + i]!;
    if (!state.even) state.missed.fill(0);
    state.even = false;
    state.slow = top.thinness * turn * turn < MOST_TURN;
    const { moments } = body.mass;
    if (!same3(left, v, 3)) {
      applyInertia(momentum, 0, this.#axes, moments, v, 3);
      state.missed.fill(0);
    }
    this.#orientation.set(state.from);
    turnFreely(this.#orientation, top, momentum, dt);
    this.#writeSpin(given, dt);
    state.aside.fill(0);
    state.displaced.fill(0);
    state.beyond = false;
    this.#writeEnd(body, state, this.#orientation, 0);
    this.#give(body, given);
  }

  /** The spin that goes with the momentum at an orientation. */
  #writeEnd({ mass }: Body, { end, momentum }: Spin, q: Float64Array, at: number): void {
    writeAxes(this.#axes, q, at);
    applyInverseInertia(end, 0, this.#axes, mass.moments, momentum, 0);
  }

  /** The spin that turns the body from its pose to `#orientation` in one step, as Bullet keeps it. */
  #writeSpin(out: Float64Array, dt: number): void {
    const turn = this.#turn;
    for (let i = 0; i < 3; i++) turn[i] = -this.#pose[3 + i]!;
    turn[3] = this.#pose[6]!;
    multiply4(turn, this.#orientation, 0, turn, 0);
    const sign = turn[3]! < 0 ? -1 : 1;
    const sine = hypot(turn[0]!, turn[1]!, turn[2]!);
    const angle = 2 * atan2(sine, sign * turn[3]!);
    const per = sine > 1e-12 ? (sign * angle) / (sine * dt) : 0;
    for (let i = 0; i < 3; i++) out[i] = Math.fround(turn[i]! * per);
  }

  #follow(body: Body, state: Spin): void {
    const { given, end, left } = state;
    const spin = this.#spin;
    const v = this.#velocity;
    this.#simulation.engine.reader.velocity(body.pointer, v, 0);
    const free = same3(given, v, 3) && !state.beyond;
    const kept =
      state.slow && (state.even || (this.#effects.caused(jointSolve)?.alone(body) ?? false));
    for (let i = 0; i < 3; i++) spin[i] = v[3 + i]! - given[i]!;
    if (kept) this.#takeMomentum(body, state);
    else {
      for (let i = 0; i < 3; i++) spin[i]! += end[i]!;
      if (state.beyond) this.#turnSpin(state.aside);
    }
    if (!free && !state.slow) this.#bound(body, state);
    for (let i = 0; i < 3; i++) spin[i] = Math.fround(spin[i]!);
    if (free || kept) left.set(spin);
    else left.fill(NaN);
    this.#give(body, spin);
    this.#simulation.bodies.readVelocity(body);
  }

  #turnSpin(radians: Float64Array): void {
    writeTurn(this.#turn, radians, 1);
    turnVector(this.#spin, this.#turn);
  }

  /**
   * What turns far in a step ends it with its axes elsewhere: what joints or contacts took of the spin at its start, taken
   * from the spin at its end, may leave more than there was. No more energy is left than they left.
   */
  #bound(body: Body, { axes, momentum, given, left }: Spin): void {
    const { moments } = body.mass;
    applyInverseInertia(left, 0, axes, moments, momentum, 0);
    const before = energyOf(axes, moments, left, 0);
    const change = energyOf(axes, moments, this.#velocity, 3) - energyOf(axes, moments, given, 0);
    this.#simulation.engine.reader.pose(body.pointer, this.#pose, 0);
    writeAxes(this.#axes, this.#pose, 3);
    const after = energyOf(this.#axes, moments, this.#spin, 0);
    const most = Math.max(0, before + change);
    if (!(after > most)) return;
    for (let i = 0; i < 3; i++) this.#spin[i]! *= Math.sqrt(most / after);
  }

  /** What only joints or an even push changed in the step is momentum: it stays as it is while the body turns. */
  #takeMomentum(body: Body, state: Spin): void {
    const { axes, momentum, end, missed } = state;
    for (let i = 0; i < 3; i++) missed[i] = -end[i]! - this.#spin[i]!;
    applyInertia(this.#change, 0, axes, body.mass.moments, this.#spin, 0);
    for (let i = 0; i < 3; i++) momentum[i]! += this.#change[i]!;
    this.#simulation.engine.reader.pose(body.pointer, this.#pose, 0);
    this.#writeEnd(body, state, this.#pose, 3);
    for (let i = 0; i < 3; i++) missed[i]! += end[i]!;
    this.#spin.set(end);
  }

  #give({ body }: Body, spin: Float64Array): void {
    body.setAngularVelocity(this.#simulation.engine.scratch.vector(spin[0]!, spin[1]!, spin[2]!));
  }
}

/** Twice the energy of a spin. */
function energyOf(
  axes: Float64Array,
  moments: readonly number[],
  spin: Float64Array,
  at: number,
): number {
  let sum = 0;
  for (let i = 0; i < 3; i++) sum += moments[i]! * dot3(axes, i * 3, spin, at) ** 2;
  return sum;
}

/** Turns it by a unit quaternion. */
function turnVector(v: Float64Array, q: Float64Array): void {
  cross3(twice, 0, q, 0, v, 0);
  for (let i = 0; i < 3; i++) twice[i]! *= 2;
  cross3(across, 0, q, 0, twice, 0);
  for (let i = 0; i < 3; i++) v[i]! += q[3]! * twice[i]! + across[i]!;
}

const twice = new Float64Array(3);
const across = new Float64Array(3);

const newSpin = (): Spin => ({
  momentum: new Float64Array(3),
  given: new Float64Array(3),
  end: new Float64Array(3),
  left: new Float64Array(3).fill(NaN),
  from: new Float64Array(4),
  axes: new Float64Array(9),
  slow: false,
  even: false,
  missed: new Float64Array(3),
  beyond: false,
  aside: new Float64Array(3),
  displaced: new Float64Array(3),
});

const same3 = (a: Float64Array, b: Float64Array, at: number): boolean =>
  a[0] === b[at] && a[1] === b[at + 1] && a[2] === b[at + 2];

export const gyroscopic: EffectDescriptor<Gyroscopic> = {
  name: 'gyroscopic torque',
  causes: 'a body that moves and whose principal moments of inertia differ',
  after: { 'axis damping': 'it begins with the spin that damping leaves' },
  body: {
    on: ['mass'],
    reason: ({ movable, mass }) =>
      movable && !turnsAlike(mass.moments) ? 'unequal moments of inertia' : undefined,
  },
  load: (simulation, effects) => new Gyroscopic(simulation, effects),
};
