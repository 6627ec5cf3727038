import type { Flat } from '../../shapes/forms/form.js';
import { clip, MOST_CLIPPED } from './clip.js';
import type { FoundPoints } from './found-points.js';
import { LineContact } from './line-contact.js';
import { NearestPoints } from './nearest-points.js';
import type { PlacedForm } from './placed-form.js';

/** So much farther than the nearest corner a face may begin and still bear the contact: the depth that resting contacts keep, metres. */
export const FLUSH = 1e-4;

/** Of what is small, this share of its reach. */
const FLUSH_SHARE = 1e-3;

/** By so much Bullet may be off where it says how far apart two forms are, metres: twice the margin that it has around hulls. */
export const OFF = 0.01;

/** The second face bears the contact where it lies so much farther out than the first, metres. */
const FARTHER = 1e-5;

/** What lies on a face with more corners turns about none of them. */
const MOST_LYING = 8;

/** So near a corner it is that corner, metres. */
const AT = 1e-6;

/**
 * The contact points of two convex forms as they stand. Where a flat face of one bears the other, the normal is exactly
 * that of the face, and the points are those of what lies over it; else the nearest points say the normal.
 */
export class ConvexContact {
  readonly #nearest = new NearestPoints();
  readonly #lines = new LineContact();
  readonly #normalA = new Float64Array(3);
  readonly #normalB = new Float64Array(3);
  readonly #face = new Float64Array(3 * MOST_CLIPPED);
  readonly #lying = new Float64Array(3 * MOST_CLIPPED);
  /** Corners of what lies on a face, before it is clipped, and how many; and how many the face has. */
  readonly #corners = new Float64Array(3 * MOST_LYING);
  #ends = 0;
  #sides = 0;
  #points!: FoundPoints;
  /** Farther apart than this nothing is a contact, metres. */
  #limit = 0;
  #triangle = -1;
  /** How far apart they are at least: a face that says less is not what separates them most. */
  #least = 0;
  #theirs = -Infinity;

  /**
   * `normal`: a guess, from B into A, and what is found, where they are no contact the direction that separates them; `theirs`:
   * how far apart Bullet has them, metres.
   */
  find(
    a: PlacedForm,
    b: PlacedForm,
    normal: Flat,
    limit: number,
    points: FoundPoints,
    triangle = -1,
    theirs = -Infinity,
  ): void {
    this.#points = points;
    this.#limit = limit;
    this.#theirs = theirs;
    this.#triangle = triangle;
    if (this.#byFaces(a, b, normal)) return;
    const nearest = this.#nearest;
    nearest.normal.set(normal);
    const found = nearest.find(a, b, limit);
    normal.set(nearest.normal);
    if (!found) return;
    this.#theirs = -Infinity;
    if (nearest.distance > limit || this.#byFaces(a, b, normal)) return;
    if (!this.#lines.find(a, b, normal, limit, points, triangle)) this.#addNearest(b);
  }

  #addNearest(b: PlacedForm): void {
    const { normal, onB, distance } = this.#nearest;
    const x = normal[0]!;
    const y = normal[1]!;
    const z = normal[2]!;
    const { round } = b.form;
    this.#points.add(
      onB[0]! + x * round,
      onB[1]! + y * round,
      onB[2]! + z * round,
      x,
      y,
      z,
      distance,
      this.#triangle,
    );
  }

  /** Whether the face of A or of B that looks most along the normal bears the contact, or there is none. */
  #byFaces(a: PlacedForm, b: PlacedForm, normal: Flat): boolean {
    const x = normal[0]!;
    const y = normal[1]!;
    const z = normal[2]!;
    const along = -b.height(x, y, z) - a.height(-x, -y, -z);
    if (along > this.#limit) return true;
    const ofA = a.facing(-x, -y, -z, this.#normalA);
    const gapA = ofA < 0 ? -Infinity : gapAlong(a, b, this.#normalA);
    if (gapA > this.#limit) return separates(this.#normalA, -1, normal);
    const ofB = b.facing(x, y, z, this.#normalB);
    const gapB = ofB < 0 ? -Infinity : gapAlong(b, a, this.#normalB);
    if (gapB > this.#limit) return separates(this.#normalB, 1, normal);
    this.#least = Math.max(along - FARTHER, this.#theirs - OFF);
    const aFirst = gapA > gapB + FARTHER;
    return aFirst
      ? this.#onFace(a, b, ofA, this.#normalA, gapA, -1, normal) ||
          this.#onFace(b, a, ofB, this.#normalB, gapB, 1, normal)
      : this.#onFace(b, a, ofB, this.#normalB, gapB, 1, normal) ||
          this.#onFace(a, b, ofA, this.#normalA, gapA, -1, normal);
  }

  /** Before one is clipped by the other. */
  #noteCorners(borne: PlacedForm, lying: Flat, count: number, bearer: PlacedForm, corners: number) {
    const few = count <= MOST_LYING && corners <= MOST_LYING;
    this.#ends = few && borne.form.cornered ? count : 0;
    this.#sides = few && bearer.form.cornered ? corners : 0;
    for (let i = 0; i < 3 * this.#ends; i++) this.#corners[i] = lying[i]!;
  }

  /** 1: of what lies on a face, -1: of the face, 0: of neither. */
  #cornerAt(x: number, y: number, z: number): -1 | 0 | 1 {
    if (isOne(this.#corners, this.#ends, x, y, z)) return 1;
    return isOne(this.#face, this.#sides, x, y, z) ? -1 : 0;
  }

  /** What lies over a face of `bearer`; `sign` 1: that is B. */
  #onFace(
    bearer: PlacedForm,
    borne: PlacedForm,
    number: number,
    out: Flat,
    gap: number,
    sign: 1 | -1,
    normal: Flat,
  ): boolean {
    if (number < 0 || gap < this.#least) return false;
    const x = out[0]!;
    const y = out[1]!;
    const z = out[2]!;
    const face = this.#face;
    const corners = bearer.face(number, face);
    const lying = this.#lying;
    const whole = borne.lying(-x, -y, -z, lying);
    this.#noteCorners(borne, lying, whole, bearer, corners);
    const count = clip(lying, whole, face, corners, x, y, z);
    const height = x * face[0]! + y * face[1]! + z * face[2]!;
    const flush = Math.min(FLUSH, FLUSH_SHARE * borne.form.reach);
    if (leastHeight(lying, count, x, y, z) - height > gap + flush) return false;
    for (let at = 0; at < 3 * count; at += 3) {
      const px = lying[at]!;
      const py = lying[at + 1]!;
      const pz = lying[at + 2]!;
      const distance = x * px + y * py + z * pz - height;
      if (distance > this.#limit) continue;
      const down = sign > 0 ? distance : 0;
      this.#points.add(
        px - x * down,
        py - y * down,
        pz - z * down,
        sign * x,
        sign * y,
        sign * z,
        distance,
        this.#triangle,
        sign * this.#cornerAt(px, py, pz),
      );
    }
    for (let i = 0; i < 3; i++) normal[i] = sign * out[i]!;
    return true;
  }
}

/** A face's normal does. */
function separates(out: Flat, sign: 1 | -1, normal: Flat): true {
  for (let i = 0; i < 3; i++) normal[i] = sign * out[i]!;
  return true;
}

/** Whether a place is one of these. */
function isOne(places: Flat, count: number, x: number, y: number, z: number): boolean {
  for (let i = 0; i < 3 * count; i += 3) {
    const u = places[i]! - x;
    const v = places[i + 1]! - y;
    const w = places[i + 2]! - z;
    if (Math.abs(u) + Math.abs(v) + Math.abs(w) < AT) return true;
  }
  return false;
}

/** How far `borne` lies from `bearer` along the bearer's outward normal. */
function gapAlong(bearer: PlacedForm, borne: PlacedForm, out: Flat): number {
  const x = out[0]!;
  const y = out[1]!;
  const z = out[2]!;
  return -borne.height(-x, -y, -z) - bearer.height(x, y, z);
}

function leastHeight(points: Flat, count: number, x: number, y: number, z: number): number {
  let least = Infinity;
  for (let at = 0; at < 3 * count; at += 3)
    least = Math.min(least, x * points[at]! + y * points[at + 1]! + z * points[at + 2]!);
  return least;
}
