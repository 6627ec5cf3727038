import type { Joint } from '../../dynamics/joint.js';
import { compose, type Pose } from '../../base/math.js';
import { SIDE } from '../../solver/joints/blocks.js';
import type { Edge } from '../../solver/joints/forest.js';
import { JointGeometry, type End } from './joint-geometry.js';
import { writeSpin } from '../../base/matrix-spin.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';

/** Origin and rotation matrix of a frame. */
const FRAME = 3 + MATRIX;
/** Of an end: its frame where the step begins, and where it ends. */
const END = 2 * FRAME;

/** A body that its author moves along: poses of its centre of mass where the step begins, and where it ends. */
export interface Way {
  readonly now: Pose;
  readonly next: Pose;
}

/** The ways of the carried bodies among the bodies of a joint. */
export interface Ways {
  readonly one: Way | undefined;
  readonly two: Way | undefined;
}

/** Both ends of each joint, and where they are, one joint at a time. */
export class JointEnds {
  edges: readonly Edge[] = [];
  readonly geometry = new JointGeometry();
  /** Per joint both ends: from the centre of mass of a moving body, or in the world. */
  #frames = new Float64Array(0);
  /** Whether a carried body takes an end along in this step. */
  #carried = new Uint8Array(0);
  /** Of both ends in the world: velocity of the origin, and spin. */
  readonly #rates = [new Float64Array(SIDE), new Float64Array(SIDE)] as const;
  readonly #quaternion = new Float64Array(4);

  take(joints: readonly Joint[], edges: readonly Edge[]): void {
    this.edges = edges;
    if (this.#carried.length < joints.length) {
      this.#frames = new Float64Array(joints.length * 4 * END);
      this.#carried = new Uint8Array(joints.length * 2);
    }
    joints.forEach((joint, k) => this.takeFrames(k, joint));
  }

  /** Both frames of joint `k`. */
  takeFrames(k: number, joint: Joint, ways?: Ways): void {
    const { a, b } = this.edges[k]!;
    this.#carried[k] = ways ? 1 : 0;
    this.#takeEnd(k * 2, joint.centred1, a < 0 ? joint.frameInBullet(1) : undefined, ways?.one);
    this.#takeEnd(k * 2 + 1, joint.centred2, b < 0 ? joint.frameInBullet(2) : undefined, ways?.two);
  }

  #takeEnd(end: number, centred: Pose, fixed: Pose | undefined, way: Way | undefined): void {
    this.#takeFrame(end * END, way ? compose(way.now, centred) : (fixed ?? centred));
    this.#takeFrame(end * END + FRAME, way ? compose(way.next, centred) : (fixed ?? centred));
  }

  #takeFrame(at: number, { p, q }: Pose): void {
    this.#frames.set(p, at);
    this.#quaternion.set(q);
    writeMatrix(this.#frames, at + 3, this.#quaternion, 0);
  }

  /** Of joint `k`, with the bodies at these places and turned by these matrices; `ends` 1: where the step ends. */
  read(k: number, place: Float64Array, turn: Float64Array, ends: 0 | 1 = 0): void {
    const { a, b } = this.edges[k]!;
    const at = k * 2 * END + ends * FRAME;
    this.#read(this.geometry.one, at, a, place, turn);
    this.#read(this.geometry.two, at + END, b, place, turn);
    this.geometry.look();
  }

  /** Whether a carried body takes an end of joint `k` along. */
  moves(k: number): boolean {
    return this.#carried[k] === 1;
  }

  /** `out` += `sign` times the way on which the step takes an end in the world: of body 1 (0) or 2 (1). */
  addWay(k: number, which: 0 | 1, sign: 1 | -1, out: Float64Array, at: number): void {
    const o = (k * 2 + which) * END;
    for (let x = 0; x < 3; x++)
      out[at + x]! += sign * (this.#frames[o + FRAME + x]! - this.#frames[o + x]!);
  }

  /** Velocity of the origin of an end in the world, and its spin. Valid until the next question. */
  rates(k: number, which: 0 | 1, dt: number): Float64Array {
    const out = this.#rates[which];
    const o = (k * 2 + which) * END;
    const f = this.#frames;
    for (let x = 0; x < 3; x++) out[x] = (f[o + FRAME + x]! - f[o + x]!) / dt;
    writeSpin(out, 3, f, o + 3, o + FRAME + 3, dt);
    return out;
  }

  #read(end: End, frame: number, body: number, place: Float64Array, turn: Float64Array): void {
    if (body < 0) this.#readFixed(end, frame);
    else this.#readCarried(end, frame, body, place, turn);
  }

  #readFixed({ origin, axes }: End, frame: number): void {
    for (let x = 0; x < 3; x++) {
      origin[x] = this.#frames[frame + x]!;
      for (let c = 0; c < 3; c++) axes[c * 3 + x] = this.#frames[frame + 3 + x * 3 + c]!;
    }
  }

  #readCarried(
    { origin, axes }: End,
    frame: number,
    body: number,
    place: Float64Array,
    turn: Float64Array,
  ): void {
    const f = this.#frames;
    const p0 = f[frame]!;
    const p1 = f[frame + 1]!;
    const p2 = f[frame + 2]!;
    for (let x = 0; x < 3; x++) {
      const o = body * MATRIX + x * 3;
      const t0 = turn[o]!;
      const t1 = turn[o + 1]!;
      const t2 = turn[o + 2]!;
      origin[x] = place[body * 3 + x]! + t0 * p0 + t1 * p1 + t2 * p2;
      axes[x] = t0 * f[frame + 3]! + t1 * f[frame + 6]! + t2 * f[frame + 9]!;
      axes[3 + x] = t0 * f[frame + 4]! + t1 * f[frame + 7]! + t2 * f[frame + 10]!;
      axes[6 + x] = t0 * f[frame + 5]! + t1 * f[frame + 8]! + t2 * f[frame + 11]!;
    }
  }
}
