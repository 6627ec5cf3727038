import { atan2 } from '../../../base/exact/index.js';
import { multiply4 } from '../../../base/flat-math.js';
import { grown } from '../../../base/grown.js';
import { POSE, type Poses } from '../../../dynamics/poses.js';
import { VELOCITY } from '../../../engine/moving-bodies.js';
import { between } from './between.js';
import type { Flat } from './solid.js';

/** What is put elsewhere without a step is carried there, as bodies that it pushes see it; what goes farther, metres, jumps. */
const LEAP = 0.5;

const turn = new Float64Array(4);
const inverse = new Float64Array(4);

/** Where bodies are in the course of a step, by slot, in their author's world, and how they come from there to there. */
export class Places {
  /** At its beginning and at its end. */
  first: Flat = new Float64Array(0);
  last: Flat = new Float64Array(0);
  /** 1: `last` is where it was at the end of the step before. */
  #known = new Uint8Array(0);
  /** By how much each turns, and how far its origin goes. */
  angles: Flat = new Float64Array(0);
  ways: Flat = new Float64Array(0);
  /** Linear and angular, m/s and rad/s: those that lead from the beginning to the end. */
  velocities: Flat = new Float64Array(0);

  makeRoom(slots: number): void {
    if (this.angles.length >= slots) return;
    const room = 2 * slots;
    this.first = grown(this.first, room * POSE);
    this.last = grown(this.last, room * POSE);
    const known = new Uint8Array(room);
    known.set(this.#known);
    this.#known = known;
    this.angles = grown(this.angles, room);
    this.ways = grown(this.ways, room);
    this.velocities = grown(this.velocities, room * VELOCITY);
  }

  /** Nothing is known of where a body was before. */
  forget(slot: number): void {
    this.#known[slot] = 0;
  }

  /** It stands where the last step left it. */
  stand(slot: number, { current, origin }: Poses): void {
    const at = slot * POSE;
    this.#known[slot] = 1;
    for (let k = 0; k < POSE; k++) this.last[at + k] = current[at + k]! + (k < 3 ? origin[k]! : 0);
  }

  forgetAll(): void {
    this.#known.fill(0);
  }

  /**
   * Whether a body is elsewhere, or comes there in another way, than it was and did. The poses tell how what moves by itself
   * came there. What was put there has no way in them, but goes on from where it was seen last.
   */
  take(
    slot: number,
    { previous, current, origin }: Poses,
    isDynamic: boolean,
    dt: number,
  ): boolean {
    const { first, last } = this;
    const at = slot * POSE;
    let isPut = !isDynamic;
    if (!isPut) {
      isPut = true;
      for (let k = at; k < at + POSE; k++) if (previous[k] !== current[k]) isPut = false;
    }
    const goesOn = isPut && this.#known[slot] === 1 && !this.#leaps(at, current, origin);
    this.#known[slot] = 1;
    let changed = false;
    for (let k = 0; k < POSE; k++) {
      const off = k < 3 ? origin[k]! : 0;
      const to = current[at + k]! + off;
      const from = goesOn ? last[at + k]! : isPut ? to : previous[at + k]! + off;
      if (first[at + k] !== from || last[at + k] !== to) changed = true;
      first[at + k] = from;
      last[at + k] = to;
    }
    if (changed || this.moves(slot)) this.#takeMotion(slot, dt);
    return changed;
  }

  #leaps(at: number, current: Flat, origin: readonly number[]): boolean {
    let square = 0;
    for (let k = 0; k < 3; k++) square += (current[at + k]! + origin[k]! - this.last[at + k]!) ** 2;
    return !(square <= LEAP * LEAP);
  }

  moves(slot: number): boolean {
    return this.angles[slot]! > 0 || this.ways[slot]! > 0;
  }

  #takeMotion(slot: number, dt: number): void {
    const { first, last, velocities } = this;
    const at = slot * POSE;
    const to = slot * VELOCITY;
    const perSecond = dt > 0 ? 1 / dt : 0;
    let way = 0;
    for (let k = 0; k < 3; k++) {
      const gone = last[at + k]! - first[at + k]!;
      velocities[to + k] = gone * perSecond;
      way += gone * gone;
    }
    this.ways[slot] = Math.sqrt(way);
    for (let k = 0; k < 4; k++) inverse[k] = k < 3 ? -first[at + 3 + k]! : first[at + 3 + k]!;
    let same = true;
    for (let k = 3; k < POSE; k++) if (first[at + k] !== last[at + k]) same = false;
    multiply4(turn, last, at + 3, inverse, 0);
    const sine = Math.sqrt(turn[0]! * turn[0]! + turn[1]! * turn[1]! + turn[2]! * turn[2]!);
    const angle = same ? 0 : 2 * atan2(sine, Math.abs(turn[3]!));
    const speed = angle > 0 ? ((turn[3]! < 0 ? -angle : angle) / sine) * perSecond : 0;
    for (let k = 0; k < 3; k++) velocities[to + 3 + k] = turn[k]! * speed;
    this.angles[slot] = angle;
  }

  /** The pose of a body at a share of the step, as it is drawn between two steps, too. */
  at(slot: number, share: number, out: Flat): void {
    between(this.first, this.last, slot * POSE, share, out);
  }
}
