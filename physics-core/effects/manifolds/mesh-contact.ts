import type { Flat } from '../../shapes/forms/form.js';
import { meshes } from '../../shapes/meshes.js';
import { BOX, SEAM } from '../../shapes/surface/layout.js';
import type { Seams } from '../../shapes/surface/seams.js';
import type { Surface } from '../../shapes/surface/surface.js';
import { ConvexContact, FLUSH } from './convex-contact.js';
import { clip, MOST_CLIPPED } from './clip.js';
import { FoundPoints } from './found-points.js';
import { PlacedForm } from './placed-form.js';
import { SeparatingAxes } from './separating-axes.js';

/** Triangles that are looked at for one pair in a step. */
const MOST_TRIANGLES = 4096;

/** Corners the other way round: the sides from each to the next, by their own numbers. */
const BACK = [1, 0, 2] as const;

/** Of 2^32: it spreads the numbers of triangles. */
const SPREAD = 0x9e3779b1;

/** A face that is deeper than the guess says by more than this is not what separates, metres. */
const DEEPER = 1e-5;

/**
 * The contact points of something convex, A, and a surface of triangles, B. Where A lies over a triangle its plane says
 * the normal, and neighbours in one plane are one face; an edge or a corner is touched only where it stands out.
 */
export class MeshContact {
  readonly #triangle = new PlacedForm();
  readonly #form = meshes.code.triangle();
  readonly #convex = new ConvexContact();
  readonly #near = new Int32Array(MOST_TRIANGLES);
  readonly #box = new Float64Array(BOX);
  readonly #corners = new Float64Array(9);
  readonly #lying = new Float64Array(3 * MOST_CLIPPED);
  /** What of A lies on the plane of the triangle that was looked at last, before it is clipped. */
  readonly #lain = new Float64Array(3 * MOST_CLIPPED);
  #lainCount = 0;
  readonly #plane = new Float64Array(3);
  readonly #out = new Float64Array(3);
  readonly #normal = new Float64Array(3);
  /** Of one edge or corner, until it is known to stand out. */
  readonly #single = new FoundPoints();
  /** The lowest point of A over a triangle. */
  readonly #low = new Float64Array(3);
  /** What is asked for, all along `find`. */
  #a!: PlacedForm;
  #pair = 0;
  #seams!: Seams;
  #guess!: Flat;
  #limit = 0;
  #points!: FoundPoints;
  /** Nothing was met that single triangles do not tell. */
  #sure = true;
  /** How far A is from the plane of the triangle, metres. */
  #gap = 0;
  /** By pairs and triangles. */
  readonly #axes = new SeparatingAxes();
  /** A is behind the triangle: its corners are looked at the other way round. */
  #back = false;
  /** How low A reaches along the guess, less DEEPER. */
  #lowest = 0;

  constructor() {
    this.#triangle.form = this.#form;
  }

  /**
   * `turn` and `origin` of `at`: where the surface stands. `normal`: a guess, from B into A, if it is `known`; `pair`: a number
   * that stands for both. False: it can't tell.
   */
  find(
    pair: number,
    a: PlacedForm,
    at: PlacedForm,
    surface: Surface,
    normal: Flat,
    known: boolean,
    limit: number,
    points: FoundPoints,
  ): boolean {
    this.#pair = pair;
    this.#a = a;
    this.#seams = surface.seams;
    this.#guess = normal;
    this.#limit = limit;
    this.#points = points;
    this.#triangle.standAt(at);
    this.#sure = true;
    this.#plane.fill(0);
    this.#writeBox(a, at, limit);
    const count = surface.notBeside(this.#box, limit, this.#near);
    this.#lowest = known ? -a.height(-normal[0]!, -normal[1]!, -normal[2]!) - DEEPER : -Infinity;
    for (let i = 0; i < count && this.#sure; i++) this.#look(surface, this.#near[i]!);
    return this.#sure;
  }

  #look(surface: Surface, triangle: number): void {
    this.#take(surface, triangle);
    if (this.#form.isFlat) return;
    this.#gap = this.#gapTo(this.#a);
    if (this.#gap > this.#limit) return;
    if (!this.#lies(triangle)) this.#touchEdge(triangle);
  }

  #take({ points, index, normals }: Surface, triangle: number): void {
    this.#form.set(points, index, normals, triangle);
  }

  /** What is around A, in the frame of the surface. */
  #writeBox(a: PlacedForm, { turn, origin }: PlacedForm, limit: number): void {
    for (let k = 0; k < 3; k++) {
      const x = turn[k]!;
      const y = turn[3 + k]!;
      const z = turn[6 + k]!;
      const middle = x * origin[0]! + y * origin[1]! + z * origin[2]!;
      this.#box[k] = -a.height(-x, -y, -z) - middle - limit;
      this.#box[3 + k] = a.height(x, y, z) - middle + limit;
    }
  }

  /**
   * Whether A lies over the triangle: its lowest is there, or where the surface goes on in the same plane or rises, so
   * that no edge is in the way.
   */
  #lies(triangle: number): boolean {
    const face = this.#corners;
    const gap = this.#gap;
    const a = this.#a;
    const guess = this.#guess;
    const x = this.#out[0]!;
    const y = this.#out[1]!;
    const z = this.#out[2]!;
    const height = x * face[0]! + y * face[1]! + z * face[2]!;
    const lying = this.#lying;
    const count = clip(lying, this.#lieDown(a, x, y, z), face, 3, x, y, z);
    let least = Infinity;
    for (let at = 0; at < 3 * count; at += 3)
      least = Math.min(least, x * lying[at]! + y * lying[at + 1]! + z * lying[at + 2]! - height);
    // What separates them along the guess is less than that: its side is not where A comes from.
    if (least < this.#lowest - this.#triangle.height(guess[0]!, guess[1]!, guess[2]!)) return false;
    if (least > gap + FLUSH && !this.#goesOn(triangle)) return false;
    for (let at = 0; at < 3 * count; at += 3) {
      const px = lying[at]!;
      const py = lying[at + 1]!;
      const pz = lying[at + 2]!;
      const distance = x * px + y * py + z * pz - height;
      if (distance > this.#limit) continue;
      this.#points.add(
        px - x * distance,
        py - y * distance,
        pz - z * distance,
        x,
        y,
        z,
        distance,
        triangle,
      );
    }
    return true;
  }

  /** What of A lies on a plane with this normal, which is that of the triangle before more often than not. */
  #lieDown(a: PlacedForm, x: number, y: number, z: number): number {
    const plane = this.#plane;
    if (plane[0] !== x || plane[1] !== y || plane[2] !== z) {
      plane[0] = x;
      plane[1] = y;
      plane[2] = z;
      this.#lainCount = a.lying(-x, -y, -z, this.#lain);
    }
    for (let i = 0; i < 3 * this.#lainCount; i++) this.#lying[i] = this.#lain[i]!;
    return this.#lainCount;
  }

  /** Whether the surface neither ends nor falls beyond those sides of the triangle that the lowest of A is beyond. */
  #goesOn(triangle: number): boolean {
    const face = this.#corners;
    const out = this.#out;
    const low = this.#low;
    this.#a.support(out, -1, low, 0);
    for (let i = 0; i < 3; i++) {
      const from = 3 * i;
      const to = 3 * ((i + 1) % 3);
      const ex = face[to]! - face[from]!;
      const ey = face[to + 1]! - face[from + 1]!;
      const ez = face[to + 2]! - face[from + 2]!;
      const px = low[0]! - face[from]!;
      const py = low[1]! - face[from + 1]!;
      const pz = low[2]! - face[from + 2]!;
      const outside =
        px * (ey * out[2]! - ez * out[1]!) +
        py * (ez * out[0]! - ex * out[2]!) +
        pz * (ex * out[1]! - ey * out[0]!);
      if (outside <= 0) continue;
      const seam = this.#seams.beyond[3 * triangle + (this.#back ? BACK[i]! : i)]!;
      if (seam === SEAM.nothing || (this.#back ? seam > 0 : seam < 0)) return false;
    }
    return true;
  }

  /** How far A is from the plane of the triangle; its corners and its normal as seen from A's side are written down. */
  #gapTo(a: PlacedForm): number {
    const out = this.#out;
    const face = this.#corners;
    for (let k = 0; k < 3; k++) out[k] = this.#triangle.along(k, this.#form.normal);
    const x = out[0]!;
    const y = out[1]!;
    const z = out[2]!;
    this.#triangle.face(0, face);
    const height = x * face[0]! + y * face[1]! + z * face[2]!;
    const up = a.height(x, y, z);
    const down = a.height(-x, -y, -z);
    this.#back = up - down < 2 * height;
    if (!this.#back) return -down - height;
    this.#triangle.face(1, face);
    for (let k = 0; k < 3; k++) out[k] = -out[k]!;
    return height - up;
  }

  /** Whether A is farther than `limit` beyond a side of the triangle, seen along its normal: most of what is near a mesh is. */
  #isBeside(): boolean {
    const a = this.#a;
    const face = this.#corners;
    const out = this.#out;
    for (let i = 0; i < 9; i += 3) {
      const to = (i + 3) % 9;
      const ex = face[to]! - face[i]!;
      const ey = face[to + 1]! - face[i + 1]!;
      const ez = face[to + 2]! - face[i + 2]!;
      const x = ey * out[2]! - ez * out[1]!;
      const y = ez * out[0]! - ex * out[2]!;
      const z = ex * out[1]! - ey * out[0]!;
      const size = Math.sqrt(x * x + y * y + z * z);
      const edge = x * face[i]! + y * face[i + 1]! + z * face[i + 2]!;
      if (-a.height(-x / size, -y / size, -z / size) - edge / size > this.#limit) return true;
    }
    return false;
  }

  /**
   * A touches an edge or a corner of the triangle. Where neighbours stand out farther its normal can't be that of an edge.
   * What is round then has its point on the neighbour; of anything else, which lies on both, more is to be known.
   */
  #touchEdge(triangle: number): void {
    const normal = this.#normal;
    const single = this.#single;
    const guess = this.#guess;
    const limit = this.#limit;
    const along = this.#lowest - this.#triangle.height(guess[0]!, guess[1]!, guess[2]!);
    if (along > limit || this.#isBeside()) return;
    const a = this.#a;
    const pair = pairOf(this.#pair, triangle);
    if (this.#axes.separates(pair, a, this.#triangle, limit)) return;
    normal.set(along > this.#gap ? guess : this.#out);
    single.clear();
    this.#convex.find(a, this.#triangle, normal, limit, single, triangle);
    if (single.count === 0) return this.#axes.note(pair, normal);
    const { turn } = this.#triangle;
    const x = normal[0]!;
    const y = normal[1]!;
    const z = normal[2]!;
    const u = turn[0]! * x + turn[3]! * y + turn[6]! * z;
    const v = turn[1]! * x + turn[4]! * y + turn[7]! * z;
    const w = turn[2]! * x + turn[5]! * y + turn[8]! * z;
    if (this.#seams.standsOut(triangle, u, v, w)) this.#points.take(single);
    else this.#sure &&= a.form.round > 0;
  }
}

/** One number for a pair and a triangle, not 0. */
const pairOf = (pair: number, triangle: number): number =>
  pair ^ Math.imul(triangle + 1, SPREAD) || 1;
