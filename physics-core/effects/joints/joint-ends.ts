import type { Joint } from '../../dynamics/joint.js';
import type { Pose } from '../../base/math.js';
import type { Edge } from './forest.js';
import { JointGeometry, type End } from './joint-geometry.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';

/** Origin and rotation matrix of a frame. */
const FRAME = 3 + MATRIX;

/** Both ends of each joint, and where they are, one joint at a time. */
export class JointEnds {
  edges: readonly Edge[] = [];
  readonly geometry = new JointGeometry();
  /** Per joint both frames: from the centre of mass of a moving body, or in the world. */
  #frames = new Float64Array(0);
  readonly #quaternion = new Float64Array(4);

  take(joints: readonly Joint[], edges: readonly Edge[]): void {
    this.edges = edges;
    if (this.#frames.length < joints.length * 2 * FRAME)
      this.#frames = new Float64Array(joints.length * 4 * FRAME);
    joints.forEach((joint, k) => this.takeFrames(k, joint));
  }

  /** Both frames of joint `k`. */
  takeFrames(k: number, joint: Joint): void {
    const { a, b } = this.edges[k]!;
    this.#takeFrame(k * 2, a < 0 ? joint.worldFrame(1) : joint.centred1);
    this.#takeFrame(k * 2 + 1, b < 0 ? joint.worldFrame(2) : joint.centred2);
  }

  #takeFrame(at: number, { p, q }: Pose): void {
    this.#frames.set(p, at * FRAME);
    this.#quaternion.set(q);
    writeMatrix(this.#frames, at * FRAME + 3, this.#quaternion, 0);
  }

  /** Of joint `k`, with the bodies at these places and turned by these matrices. */
  read(k: number, place: Float64Array, turn: Float64Array): void {
    const { a, b } = this.edges[k]!;
    this.#read(this.geometry.one, k * 2 * FRAME, a, place, turn);
    this.#read(this.geometry.two, (k * 2 + 1) * FRAME, b, place, turn);
    this.geometry.look();
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
    for (let x = 0; x < 3; x++) {
      const o = body * MATRIX + x * 3;
      const t0 = turn[o]!;
      const t1 = turn[o + 1]!;
      const t2 = turn[o + 2]!;
      origin[x] = place[body * 3 + x]! + t0 * f[frame]! + t1 * f[frame + 1]! + t2 * f[frame + 2]!;
      for (let c = 0; c < 3; c++)
        axes[c * 3 + x] = t0 * f[frame + 3 + c]! + t1 * f[frame + 6 + c]! + t2 * f[frame + 9 + c]!;
    }
  }
}
