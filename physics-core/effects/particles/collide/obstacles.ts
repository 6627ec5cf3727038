import { identityPose, type Pose } from '../../../base/math.js';
import { MATRIX } from '../../../base/matrix.js';
import { POSE } from '../../../dynamics/poses.js';
import type { Simulation } from '../../../dynamics/simulation.js';
import { VELOCITY } from '../../../engine/moving-bodies.js';
import { FRAME, intoFrame, wayIntoFrame, writeFrame } from './frames.js';
import { FRAMES, PlacedParts } from './placed-parts.js';
import { BOX, Slabs, type Search } from './slabs.js';
import { FOUND, WAY, type Flat, type Solid } from './solid.js';

/**
 * Where the numbers of what was met lie: the share of the way; the depth in which it began, metres; the outward normal; the
 * point of the surface; where the middle of the particle is then; the slot of the body; and the share of the step at which
 * that is.
 */
export const MET = {
  share: 0,
  depth: 1,
  normal: 2,
  point: 5,
  place: 8,
  body: 11,
  time: 12,
} as const;

/** Numbers of what was met. */
export const METS = 13;

/** More than a sheet is thick (`SKIN`), and what rounding leaves, metres. */
const MARGIN = 1e-5;

/** A way in the frame of what turns is straight within this, metres, or it is looked at in pieces. */
const STRAIGHT = 0.002;

const MOST_PIECES = 16;

/** What turns by no more, radians, is clear of all pieces of a way that passes by at so many times what that is off. */
const SLOW = 0.5;
const CLEAR = 2;

/** The body's own frame. */
const OWN: Pose = identityPose();

const pose = new Float64Array(POSE);
const frame = new Float64Array(FRAME);
const next = new Float64Array(FRAME);
const way = new Float64Array(WAY);
const found = new Float64Array(FOUND);
const box = new Float64Array(BOX);
/** Of the best so far, in its part's frame: the normal, and where the middle is. */
const best = new Float64Array(6);
/** Of the particle: where it begins, how far it goes, the length of that, its radius, and its shares of the step. */
const ends = new Float64Array(10);

/**
 * What particles meet on straight ways within one step, among all bodies of a world. A way is taken into the frame of what
 * moves by its pose where the way begins and where it ends, and is straight there: that is off by the product of both
 * motions, the turn in a step and the way, and so by the square of the step. Both ends are exact, each way begins in that
 * frame where the one before it ended, and so nothing comes through a closed surface, however it turns.
 */
export class Obstacles {
  readonly #simulation: Pick<Simulation, 'bodies' | 'poses'>;
  readonly #search: Search;
  readonly #stirred = new Slabs();
  readonly #parts = new PlacedParts();
  #near = new Int32Array(0);

  // Of the way that is being looked at.
  #part = -1;
  #share = 0;
  #depth = 0;

  constructor(simulation: Pick<Simulation, 'bodies' | 'poses'>, search: Search = new Slabs()) {
    this.#simulation = simulation;
    this.#search = search;
  }

  /**
   * Reads what bodies are and where, at the beginning and at the end of a step of `dt` seconds that has been taken: once
   * after each.
   */
  take(dt: number): void {
    const parts = this.#parts;
    const isOther = parts.take(this.#simulation, dt);
    this.#stirred.fill(parts.stirred, parts.stirredCount);
    if (!isOther) return;
    const count = parts.all.length;
    if (this.#near.length < count) this.#near = new Int32Array(2 * count);
    this.#search.fill(parts.boxes, count);
  }

  /** Time does not go on from the step before: bodies are where they are without having come there. */
  forget(): void {
    this.#parts.places.forgetAll();
  }

  /** The world goes on from elsewhere, where the step before was looked at, too. */
  goOn(): void {
    this.#parts.goOn(this.#simulation);
  }

  /**
   * Whether a ball, or a point where `radius` is 0, meets a body on the straight way between two points of the author's
   * world; what it meets first goes to `out`. It goes from the share `since` of the step to the share `until`: it may be
   * born within it, or go on from where it was met. One that begins inside a body is met at share 0, and `place` is where
   * it is out of it again.
   */
  meet(from: Flat, to: Flat, radius: number, out: Flat, since = 0, until = 1): boolean {
    this.#begin(from, to, radius);
    ends[8] = since;
    ends[9] = until;
    const near = this.#near;
    const count = this.#search.near(box, near);
    if (count === 0) return false;
    this.#part = -1;
    this.#share = 1;
    this.#depth = 0;
    for (let i = 0; i < count; i++) this.#look(near[i]!);
    if (this.#part < 0) return false;
    this.#tell(out);
    return true;
  }

  /** False: nothing is met on that way, whenever within the step. */
  isNear(from: Flat, to: Flat, radius: number): boolean {
    this.#begin(from, to, radius);
    return this.#search.any(box);
  }

  /** Nothing near that way is other, or elsewhere, than it was a step ago. */
  isCalm(from: Flat, to: Flat, radius: number): boolean {
    if (this.#parts.isOther) return false;
    this.#begin(from, to, radius);
    return !this.#stirred.any(box);
  }

  /** What is to be known of a way, and the box in which it lies. */
  #begin(from: Flat, to: Flat, radius: number): void {
    const x = from[0]!;
    const y = from[1]!;
    const z = from[2]!;
    const u = to[0]! - x;
    const v = to[1]! - y;
    const w = to[2]! - z;
    const length = Math.sqrt(u * u + v * v + w * w);
    const margin = radius + MARGIN + this.#parts.slack * (length + radius);
    ends[0] = x;
    ends[1] = y;
    ends[2] = z;
    ends[3] = u;
    ends[4] = v;
    ends[5] = w;
    ends[6] = radius;
    ends[7] = length;
    box[0] = (u < 0 ? x + u : x) - margin;
    box[1] = (v < 0 ? y + v : y) - margin;
    box[2] = (w < 0 ? z + w : z) - margin;
    box[3] = (u < 0 ? x : x + u) + margin;
    box[4] = (v < 0 ? y : y + v) + margin;
    box[5] = (w < 0 ? z : z + w) + margin;
  }

  #look(i: number): void {
    const parts = this.#parts;
    const { frames } = parts;
    const { solid } = parts.all[i]!;
    const at = FRAMES * i;
    if (!parts.moves(i)) {
      intoFrame(frames, at, ends, 0, way, 0);
      wayIntoFrame(frames, at, ends, way);
      if (this.#meets(solid)) this.#keep(i, found[0]!);
      return;
    }
    const off = this.#off(i);
    const isWhole = ends[8] === 0 && ends[9] === 1;
    if (isWhole) {
      intoFrame(frames, at, ends, 0, way, 0);
      intoFrame(frames, at + FRAME, ends, 1, way, 3);
      for (let k = 0; k < 3; k++) way[3 + k]! -= way[k]!;
      if (off <= STRAIGHT) {
        if (this.#meets(solid)) this.#keep(i, found[0]!);
        return;
      }
      // Most that come near pass by, farther away than they are off.
      if (this.#parts.turns(i) <= SLOW) {
        way[6] = ends[6]! + CLEAR * off;
        way[7] = 1;
        if (!solid.meets(way, found)) return;
      }
    }
    this.#lookInPieces(i, Math.max(1, Math.min(MOST_PIECES, Math.ceil(Math.sqrt(off / STRAIGHT)))));
  }

  #meets(solid: Solid): boolean {
    way[6] = ends[6]!;
    way[7] = this.#share;
    return solid.meets(way, found);
  }

  /** How far a way is from straight in the frame of what turns, metres, at most: a quarter of that for half of it. */
  #off(i: number): number {
    const { slot, reach } = this.#parts.all[i]!;
    const { angles, ways } = this.#parts.places;
    const angle = angles[slot]! * (ends[9]! - ends[8]!);
    return (angle * (ends[7]! + ways[slot]!)) / 4 + (angle * angle * reach) / 8;
  }

  #lookInPieces(i: number, pieces: number): void {
    const { solid } = this.#parts.all[i]!;
    const step = 1 / pieces;
    const since = ends[8]!;
    const time = ends[9]! - since;
    this.#parts.frameAt(i, since, next);
    for (let piece = 0; piece < pieces; piece++) {
      const start = piece * step;
      const most = this.#share * pieces - piece;
      if (!(most >= 0)) return;
      frame.set(next);
      this.#parts.frameAt(i, since + time * (start + step), next);
      intoFrame(frame, 0, ends, start, way, 0);
      intoFrame(next, 0, ends, start + step, way, 3);
      for (let k = 0; k < 3; k++) way[3 + k]! -= way[k]!;
      way[6] = ends[6]!;
      way[7] = most < 1 ? most : 1;
      if (!solid.meets(way, found)) continue;
      this.#keep(i, start + found[0]! * step);
      return;
    }
  }

  /** The earliest; of those in which a particle begins the deepest, so that it is out of the others, too; else the first. */
  #keep(i: number, share: number): void {
    const depth = found[1]!;
    if (this.#part >= 0) {
      if (share > this.#share) return;
      if (share === this.#share && depth < this.#depth) return;
      if (share === this.#share && depth === this.#depth && i > this.#part) return;
    }
    this.#part = i;
    this.#share = share;
    this.#depth = depth;
    for (let k = 0; k < 3; k++) {
      best[k] = found[2 + k]!;
      best[3 + k] = way[k]! + way[3 + k]! * found[0]! + found[2 + k]! * depth;
    }
  }

  #tell(out: Flat): void {
    const radius = ends[6]!;
    const { slot } = this.#parts.all[this.#part]!;
    const time = ends[8]! + (ends[9]! - ends[8]!) * this.#share;
    let { frames } = this.#parts;
    let at = FRAMES * this.#part;
    if (this.#parts.moves(this.#part)) {
      this.#parts.frameAt(this.#part, time, frame);
      frames = frame;
      at = 0;
    }
    out[MET.share] = this.#share;
    out[MET.depth] = this.#depth;
    for (let k = 0; k < 3; k++) {
      const row = at + 3 * k;
      const a = frames[row]!;
      const b = frames[row + 1]!;
      const c = frames[row + 2]!;
      const normal = a * best[0]! + b * best[1]! + c * best[2]!;
      const place = frames[at + MATRIX + k]! + (a * best[3]! + b * best[4]! + c * best[5]!);
      out[MET.normal + k] = normal;
      out[MET.place + k] = place;
      out[MET.point + k] = place - normal * radius;
    }
    out[MET.body] = slot;
    out[MET.time] = time;
  }

  /** Where the middle of a particle is at the end of the step if from when it was met it stays there on the body. */
  ride(met: Flat, out: Flat): void {
    const { places } = this.#parts;
    const slot = met[MET.body]!;
    places.at(slot, met[MET.time]!, pose);
    writeFrame(frame, 0, pose, 0, OWN);
    writeFrame(next, 0, places.last, slot * POSE, OWN);
    for (let k = 0; k < 3; k++) {
      ends[k] = met[MET.place + k]!;
      ends[3 + k] = 0;
    }
    intoFrame(frame, 0, ends, 0, way, 0);
    for (let k = 0; k < 3; k++)
      out[k] =
        next[MATRIX + k]! +
        (next[3 * k]! * way[0]! + next[3 * k + 1]! * way[1]! + next[3 * k + 2]! * way[2]!);
  }

  /** How fast the body is, m/s, where and when it was met. */
  velocityAt(met: Flat, out: Flat): void {
    const { first, last, velocities } = this.#parts.places;
    const slot = met[MET.body]!;
    const at = slot * POSE;
    const from = slot * VELOCITY;
    const time = met[MET.time]!;
    const x = met[MET.point]! - (first[at]! + (last[at]! - first[at]!) * time);
    const y = met[MET.point + 1]! - (first[at + 1]! + (last[at + 1]! - first[at + 1]!) * time);
    const z = met[MET.point + 2]! - (first[at + 2]! + (last[at + 2]! - first[at + 2]!) * time);
    const u = velocities[from + 3]!;
    const v = velocities[from + 4]!;
    const w = velocities[from + 5]!;
    out[0] = velocities[from]! + v * z - w * y;
    out[1] = velocities[from + 1]! + w * x - u * z;
    out[2] = velocities[from + 2]! + u * y - v * x;
  }
}
