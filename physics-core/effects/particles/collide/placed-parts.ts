import { lengthOf } from '../../../base/exact/index.js';
import { compose, type Pose } from '../../../base/math.js';
import { MATRIX } from '../../../base/matrix.js';
import type { Body } from '../../../dynamics/body.js';
import type { CollidablePart } from '../../../dynamics/collidable.js';
import { POSE } from '../../../dynamics/poses.js';
import type { Simulation } from '../../../dynamics/simulation.js';
import { FRAME, writeFrame } from './frames.js';
import { Places } from './places.js';
import { BOX } from './slabs.js';
import { solidOf } from './solid-of.js';
import type { Flat, Solid } from './solid.js';

/** Numbers of both frames of a part: at the beginning of the step and at its end. */
export const FRAMES = 2 * FRAME;

/** What turns by more than this in a step, radians, may be met from anywhere. */
const MOST_TURN = 2;

const NONE: readonly CollidablePart[] = [];

/** What ways may meet of a body, and where it stands in its frame. */
interface Part {
  readonly solid: Solid;
  readonly slot: number;
  readonly pose: Pose;
  /** From the origin of the body's frame to what is farthest of it, metres. */
  readonly reach: number;
}

const partsOf = (body: Body | undefined): readonly CollidablePart[] =>
  body?.active ? body.solidParts : NONE;

const pose = new Float64Array(POSE);

/** The parts of all bodies, where they are in the course of a step, and what is around them. */
export class PlacedParts {
  readonly places = new Places();
  all: readonly Part[] = [];
  /** Of each part both frames. */
  frames: Flat = new Float64Array(0);
  /** Around each part over the step, in the world. */
  boxes: Flat = new Float64Array(0);
  /** How much farther a way may come near to what turns most, as a share of its length. */
  slack = 0;
  /** There are other parts than a step ago. */
  isOther = true;
  /** Boxes around where parts were and are that are elsewhere than a step ago, or moving, and how many they are. */
  stirred: Flat = new Float64Array(0);
  stirredCount = 0;
  /** By slot: what its parts were made of; and 1: it is elsewhere. */
  readonly #known: (readonly CollidablePart[])[] = [];
  #changed = new Uint8Array(0);
  /** Parts are known that are in no list yet. */
  #isUnlisted = false;

  /** The world goes on from elsewhere: what is put from where it stands now is carried, as if it had come there by a step. */
  goOn({ bodies, poses }: Pick<Simulation, 'bodies' | 'poses'>): void {
    const { slots } = bodies.moving;
    this.places.makeRoom(slots);
    for (let slot = 0; slot < slots; slot++) {
      const parts = partsOf(bodies.in(slot));
      this.#known[slot] = parts;
      if (parts.length > 0) this.places.stand(slot, poses);
    }
    this.#isUnlisted = true;
  }

  /** Whether anything is other, or elsewhere, than it was. */
  take({ bodies, poses }: Pick<Simulation, 'bodies' | 'poses'>, dt: number): boolean {
    const { slots } = bodies.moving;
    this.places.makeRoom(slots);
    if (this.#changed.length < slots) this.#changed = new Uint8Array(2 * slots);
    let isOther = this.#isUnlisted;
    this.#isUnlisted = false;
    let changed = false;
    for (let slot = 0; slot < slots; slot++) {
      const body = bodies.in(slot);
      const parts = partsOf(body);
      if (parts !== this.#known[slot]) {
        isOther = true;
        this.#known[slot] = parts;
        this.places.forget(slot);
      }
      this.#changed[slot] = 0;
      if (!body || parts.length === 0) continue;
      if (!this.places.take(slot, poses, body.isDynamic, dt)) continue;
      this.#changed[slot] = 1;
      changed = true;
    }
    this.isOther = isOther;
    this.stirredCount = 0;
    if (isOther) this.#list(slots);
    if (!isOther && !changed) return false;
    this.slack = 0;
    for (let i = 0; i < this.all.length; i++) {
      const stirs = this.#changed[this.all[i]!.slot] === 1;
      if (stirs) this.#stir(i);
      this.#put(i);
      if (stirs) this.#stir(i);
    }
    return true;
  }

  #stir(i: number): void {
    const at = BOX * this.stirredCount++;
    for (let k = 0; k < BOX; k++) this.stirred[at + k] = this.boxes[BOX * i + k]!;
  }

  #list(slots: number): void {
    const parts: Part[] = [];
    for (let slot = 0; slot < slots; slot++)
      for (const { outline, pose: at } of this.#known[slot]!) {
        if (!outline) continue;
        const { solid, turn } = solidOf(outline);
        if (!solid.box.every(Number.isFinite)) continue;
        parts.push({
          solid,
          slot,
          pose: compose(at, { p: [0, 0, 0], q: turn }),
          reach: lengthOf(at.p) + reachOf(solid.box),
        });
      }
    this.all = parts;
    this.frames = new Float64Array(FRAMES * parts.length);
    this.boxes = new Float64Array(BOX * parts.length);
    this.stirred = new Float64Array(2 * BOX * parts.length);
  }

  /** Frames of a part, and the box around it. */
  #put(i: number): void {
    const { slot, reach, pose: own } = this.all[i]!;
    const { first, last, angles, ways } = this.places;
    const at = FRAMES * i;
    writeFrame(this.frames, at, first, slot * POSE, own);
    writeFrame(this.frames, at + FRAME, last, slot * POSE, own);
    const angle = angles[slot]!;
    if (angle > MOST_TURN) {
      this.#surround(i, Infinity);
      return;
    }
    // Between both ends points of it go along arcs, and ways along others: see `slackOf`.
    const square = (angle * angle) / 8;
    const slack = slackOf(angle);
    const margin = 2 * square * reach + slack * ways[slot]! + (square * reach) / (1 - square);
    this.slack = Math.max(this.slack, slack);
    this.#surround(i, margin);
  }

  #surround(i: number, margin: number): void {
    const { frames } = this;
    const around = this.all[i]!.solid.box;
    const at = FRAMES * i;
    for (let k = 0; k < 3; k++) {
      let low = Infinity;
      let high = -Infinity;
      for (let from = at; from < at + FRAMES; from += FRAME) {
        let middle = frames[from + MATRIX + k]!;
        let half = 0;
        for (let j = 0; j < 3; j++) {
          const least = around[j]!;
          const most = around[3 + j]!;
          const along = frames[from + 3 * k + j]!;
          middle += (along * (least + most)) / 2;
          half += (Math.abs(along) * (most - least)) / 2;
        }
        low = Math.min(low, middle - half);
        high = Math.max(high, middle + half);
      }
      this.boxes[BOX * i + k] = low - margin;
      this.boxes[BOX * i + 3 + k] = high + margin;
    }
  }

  moves(i: number): boolean {
    return this.places.moves(this.all[i]!.slot);
  }

  /** By how much a part turns in the step, radians. */
  turns(i: number): number {
    return this.places.angles[this.all[i]!.slot]!;
  }

  /** The frame of a part at a share of the step. */
  frameAt(i: number, share: number, out: Flat): void {
    const part = this.all[i]!;
    this.places.at(part.slot, share, pose);
    writeFrame(out, 0, pose, 0, part.pose);
  }
}

/**
 * A way in the frame of what turns is off what it is in the world by s (1 - s) turn × way, a quarter of the product at most,
 * and by an eighth of the square of the turn for the distance; how much of a way that may be.
 */
function slackOf(angle: number): number {
  const square = (angle * angle) / 8;
  return (angle / 4 + square) / (1 - square);
}

function reachOf(around: Flat): number {
  let square = 0;
  for (let k = 0; k < 3; k++) square += Math.max(-around[k]!, around[3 + k]!) ** 2;
  return Math.sqrt(square);
}
