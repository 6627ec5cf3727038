import { hypot, log } from '../../base/exact/index.js';
import { cross3, dot3, multiply4 } from '../../base/flat-math.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';
import type { Body, MassProperties } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { SEEN, type Silhouette } from '../../shapes/silhouette/silhouette.js';
import { PRESSURE, type Wind } from './wind.js';

/** Which share of P u² a square metre feels over a step, z being k u dt: how far the push alone would slow the wind down. */
type Law = (z: number) => number;

/** Where nothing else acts it gives way: du/dt = -k u², so that u falls by k u² dt / (1 + z). */
export const FREE: Law = (z) => 1 / (1 + z);

/** Where something may hold it, it feels all as long as z is small; and never so much that it would be thrown beyond the wind. */
export const HELD: Law = (z) => 1 / Math.sqrt(1 + z * z);

// Of one body at a time, in the frame of its centre of mass and its principal axes, but for `wind`, which is the world's.
const turn = new Float64Array(4);
const rows = new Float64Array(MATRIX);
const wind = new Float64Array(3);
/** Linear, m/s, and angular, rad/s. */
const velocity = new Float64Array(VELOCITY);
const gained = new Float64Array(VELOCITY);
const moments = new Float64Array(3);
const gone = new Float64Array(3);
/** Where the wind goes as the body sees it: a unit vector. */
const way = new Float64Array(3);
const seen = new Float64Array(SEEN);
/** From the centre of mass to the middle of what the wind sees, metres, and what a push along `way` there turns. */
const arm = new Float64Array(3);
const moment = new Float64Array(3);

/**
 * What winds give to a body in a step: air of the density that X3D's pressure is of, at a speed u relative to the body,
 * pushes with P u² on each square metre that it sees, along u and through the middle of that. k is P times the area by the mass
 * that stands against a push there. Seen from what moves with the wind no body gains energy by either law, so that a plate
 * that it turns turns no faster than that allows.
 */
export class WindPush {
  readonly #simulation: Simulation;
  readonly #law: Law;
  /** World frame: m/s and rad/s that it gains, N m s about its centre, and how much farther that goes, metres. */
  readonly gain = new Float64Array(VELOCITY);
  readonly moment = new Float64Array(3);
  readonly gone = new Float64Array(3);

  constructor(simulation: Simulation, law: Law) {
    this.#simulation = simulation;
    this.#law = law;
  }

  /** In a step of `dt` seconds from where the body is; `besides`: m/s that it has gained otherwise in the middle of it. */
  reckon(
    body: Body,
    sight: Silhouette,
    winds: readonly Wind[],
    dt: number,
    besides: Float64Array,
  ): void {
    this.#take(body, besides);
    // One after the other, each at the speed that the others leave: so they never overshoot together.
    for (const each of winds) {
      each.writeAbout(body.id, wind);
      this.#push(sight, body.mass, dt);
    }
    outward(gained, 0, this.gain, 0);
    outward(gained, 3, this.gain, 3);
    outward(moments, 0, this.moment, 0);
    outward(gone, 0, this.gone, 0);
  }

  #take({ slot, centerOfMass }: Body, besides: Float64Array): void {
    const { poses, bodies } = this.#simulation;
    multiply4(turn, poses.current, slot * POSE + 3, centerOfMass.q, 0);
    writeMatrix(rows, 0, turn, 0);
    const at = slot * VELOCITY;
    for (let i = 0; i < 3; i++) wind[i] = bodies.velocities[at + i]! + besides[i]!;
    inward(wind, 0, velocity, 0);
    inward(bodies.velocities, at + 3, velocity, 3);
    gained.fill(0);
    moments.fill(0);
    gone.fill(0);
  }

  #push(sight: Silhouette, { mass, moments: inertia }: MassProperties, dt: number): void {
    inward(wind, 0, way, 0);
    for (let i = 0; i < 3; i++) way[i] = way[i]! - velocity[i]! - gained[i]!;
    const speed = hypot(way[0]!, way[1]!, way[2]!);
    if (!(speed > 0)) return;
    for (let i = 0; i < 3; i++) way[i] = way[i]! / speed;
    sight.along(way, seen);
    const area = seen[0]!;
    if (!(area > 0)) return;
    for (let i = 0; i < 3; i++) arm[i] = seen[1 + i]! / area;
    cross3(moment, 0, arm, 0, way, 0);
    // What a push of 1 N s there does to the speed there, 1/kg.
    let softness = 1 / mass;
    for (let i = 0; i < 3; i++) softness += (moment[i]! * moment[i]!) / inertia[i]!;
    const u = speed - dot3(velocity, 3, moment, 0) - dot3(gained, 3, moment, 0);
    const pressed = PRESSURE * area * Math.abs(u) * dt;
    const z = softness * pressed;
    const impulse = pressed * u * this.#law(z);
    const lag = z > 0 ? (u * dt * lagOf(z)) / (softness * mass) : 0;
    for (let i = 0; i < 3; i++) {
      gained[i] = gained[i]! + (impulse * way[i]!) / mass;
      gained[3 + i] = gained[3 + i]! + (impulse * moment[i]!) / inertia[i]!;
      moments[i] = moments[i]! + impulse * moment[i]!;
      gone[i] = gone[i]! + lag * way[i]!;
    }
  }
}

/** Here the series and the quotient are equally near, to 4e-10 of it. */
const SMALL = 1e-3;

/** Of what gives way freely: the share of u dt by which the wind, seen from it, gets less far. */
const lagOf = (z: number): number =>
  z < SMALL ? z * (1 / 2 - z * (1 / 3 - z / 4)) : 1 - log(1 + z) / z;

/** Of the world, in the body's frame. */
function inward(from: Float64Array, at: number, out: Float64Array, to: number): void {
  for (let k = 0; k < 3; k++)
    out[to + k] =
      rows[k]! * from[at]! + rows[3 + k]! * from[at + 1]! + rows[6 + k]! * from[at + 2]!;
}

/** Of the body's frame, in the world. */
function outward(from: Float64Array, at: number, out: Float64Array, to: number): void {
  for (let k = 0; k < 3; k++) out[to + k] = dot3(rows, 3 * k, from, at);
}
