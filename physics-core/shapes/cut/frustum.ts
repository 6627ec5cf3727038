import { cos, hypot, sin } from '../../base/exact/index.js';
import { asin } from '../../base/exact/asin.js';
import { BELOW, PLANE, type Cuttable, type Flat } from './cut.js';
import { NODES, WEIGHTS } from './gauss.js';

/** Slices that are cut as far from their middle, as a share of their radius, within this are as good as all alike. */
const ALIKE = 1e-5;

/** A plane that leans by less, radians, is level: it cuts slices of no thickness. */
const LEVEL = 1e-9;

/** What is thinner than such a share has less than a billionth of the volume. */
const POINT = 1e-4;

/** A share of what is as far from its tip as it is wide: more than rounding is. */
const TIP = 1e-12;

/** From where to where slices are cut alike. */
const pieces = new Float64Array(4);

/**
 * A cylinder or a cone around y: its radius goes evenly from `bottom` at y = -half to `top` at y = half. Each slice is a disc,
 * of which a segment lies below the plane: to -cos φ of its radius from its middle, φ from 0 to π. Along that angle what is
 * to be summed up is smooth, also where a slice is just touched.
 */
export class FrustumCut implements Cuttable {
  readonly #half: number;
  readonly #middle: number;
  readonly #slope: number;
  // Of the plane: how much it is turned aside, how much up, and its offset.
  #across = 0;
  #up = 0;
  #offset = 0;
  // Sums over slices: the volume, that times y, that times how far aside, and the area of the cut.
  #volume = 0;
  #high = 0;
  #aside = 0;
  #area = 0;

  constructor(bottom: number, top: number, half: number) {
    this.#half = half;
    this.#middle = (bottom + top) / 2;
    this.#slope = (top - bottom) / (2 * half);
  }

  below(plane: Flat, out: Flat): void {
    const x = plane[PLANE.normal]!;
    const z = plane[PLANE.normal + 2]!;
    this.#across = hypot(x, z);
    this.#up = plane[PLANE.normal + 1]!;
    this.#offset = plane[PLANE.offset]!;
    this.#volume = this.#high = this.#aside = this.#area = 0;
    if (this.#across < LEVEL) this.#sumLevel();
    else this.#sum();
    const share = this.#across < LEVEL ? 0 : this.#aside / this.#across;
    out[BELOW.volume] = this.#volume;
    out[BELOW.moment] = share * x;
    out[BELOW.moment + 1] = this.#high;
    out[BELOW.moment + 2] = share * z;
    out[BELOW.area] = this.#area;
  }

  #radiusAt(y: number): number {
    return this.#middle + this.#slope * y;
  }

  /** Which share of its radius a slice goes from its middle to the plane. */
  #shareAt(y: number): number {
    // At a tip what is next to it says.
    const radius = Math.max(this.#radiusAt(y), TIP * this.#half);
    return (this.#offset - this.#up * y) / (this.#across * radius);
  }

  #sumLevel(): void {
    const half = this.#half;
    const height = this.#offset / this.#up;
    const y = Math.min(half, Math.max(-half, height));
    if (this.#up > 0) this.#addWhole(-half, y);
    else this.#addWhole(y, half);
    if (y === height) this.#area = Math.PI * this.#radiusAt(y) ** 2;
  }

  #sum(): void {
    this.#part();
    for (let i = 0; i < 3; i++) {
      const from = pieces[i]!;
      const to = pieces[i + 1]!;
      if (!(to > from)) continue;
      const share = this.#shareAt((from + to) / 2);
      if (share >= 1) this.#addWhole(from, to);
      else if (share > -1) this.#addByRadius(from, to);
    }
  }

  /** Slices that the plane just touches part those that it cuts from those that it does not. */
  #part(): void {
    const half = this.#half;
    pieces[0] = pieces[1] = -half;
    pieces[2] = pieces[3] = half;
    for (const side of SIDES) {
      const aside = side * this.#across;
      const y = (this.#offset - aside * this.#middle) / (this.#up + aside * this.#slope);
      // A parallel to the side touches none, or all.
      if (y > -half && y < half) pieces[side > 0 ? 1 : 2] = y;
    }
    pieces.sort();
  }

  /** Whole slices. */
  #addWhole(from: number, to: number): void {
    const m = this.#middle;
    const s = this.#slope;
    const volume = (y: number): number => y * (m * m + y * (m * s + (y * s * s) / 3));
    const high = (y: number): number =>
      y * y * ((m * m) / 2 + y * ((2 * m * s) / 3 + (y * s * s) / 4));
    this.#volume += Math.PI * (volume(to) - volume(from));
    this.#high += Math.PI * (high(to) - high(from));
  }

  /** Towards a tip angles change ever faster: a piece ends where its radius is half of what it was. */
  #addByRadius(from: number, to: number): void {
    const widest = Math.max(this.#radiusAt(from), this.#radiusAt(to));
    let low = from;
    let high = to;
    for (let radius = widest / 2; radius > POINT * widest; radius /= 2) {
      const y = (radius - this.#middle) / this.#slope;
      // A cylinder has none, and the last piece goes to its end.
      if (!(y > low && y < high)) break;
      if (this.#slope < 0) {
        this.#addCut(low, y);
        low = y;
      } else {
        this.#addCut(y, high);
        high = y;
      }
    }
    this.#addCut(low, high);
  }

  #addCut(from: number, to: number): void {
    const start = within(this.#shareAt(from));
    const end = within(this.#shareAt(to));
    if (Math.abs(end - start) < ALIKE) this.#addAlike(from, to);
    else this.#addAlongAngle(Math.PI / 2 + asin(start), Math.PI / 2 + asin(end));
  }

  #addAlike(from: number, to: number): void {
    const half = (to - from) / 2;
    for (let i = 0; i < NODES.length; i++) {
      const y = from + half * (1 + NODES[i]!);
      this.#addSegment(y, Math.PI / 2 + asin(within(this.#shareAt(y))), half * WEIGHTS[i]!);
    }
  }

  #addAlongAngle(from: number, to: number): void {
    const half = (to - from) / 2;
    const up = this.#up;
    const middle = this.#across * this.#middle;
    const slope = this.#across * this.#slope;
    for (let i = 0; i < NODES.length; i++) {
      const angle = from + half * (1 + NODES[i]!);
      const share = -cos(angle);
      const turned = up + slope * share;
      const y = (this.#offset - middle * share) / turned;
      const perAngle = (-(middle * up + this.#offset * slope) * sin(angle)) / (turned * turned);
      this.#addSegment(y, angle, half * WEIGHTS[i]! * perAngle);
    }
  }

  /** So thick a slice at y, of which a segment of half that angle lies below. */
  #addSegment(y: number, angle: number, thickness: number): void {
    const radius = this.#radiusAt(y);
    const sine = sin(angle);
    const area = radius * radius * (angle - sine * cos(angle));
    this.#volume += area * thickness;
    this.#high += area * y * thickness;
    this.#aside -= (2 / 3) * (radius * sine) ** 3 * thickness;
    this.#area += (2 * radius * sine * thickness) / this.#across;
  }
}

const SIDES = [1, -1] as const;

const within = (share: number): number => Math.min(1, Math.max(-1, share));
