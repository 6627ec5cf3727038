import { hypot } from '../../base/exact/index.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Ammo } from '../../engine/ammo.js';
import { MATRIX } from '../../base/matrix.js';
import { PointerNumbers } from '../../base/pointer-numbers.js';
import { ContactPoint } from '../../engine/contact-point.js';
import { speedBetween, writeFrame } from '../../engine/body-heap.js';
import {
  breakingAt,
  firstPointAt,
  forgetPoints,
  writeDeepestNormal,
} from '../../engine/manifold-points.js';
import { ManifoldWriter } from '../../engine/manifold-writer.js';
import { OldPoints } from '../../engine/old-points.js';
import { DEFAULT_FRICTION } from '../../dynamics/contact-parameters.js';
import { partNumberAt } from '../contacts/contact-part.js';
import { contactSurface } from '../contacts/effects.js';
import { Effect, type Cause } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { concerns, formsOf, type BodyForms, type PartForm } from './body-forms.js';
import { ConvexContact, OFF } from './convex-contact.js';
import { FoundPoints } from './found-points.js';
import { MeshContact } from './mesh-contact.js';
import type { PlacedForm } from './placed-form.js';
import { apartAlong, preferAxes, SeparatingAxes } from './separating-axes.js';

/**
 * Where boxes bounce, those that move faster against each other have the points that Bullet has found, m/s; and those
 * farther from each other do not touch yet, metres: what bounces is left alone until it overlaps.
 */
const SLOW = 0.25;
const NEAR = 1e-4;

/** Pairs near each other in a world that is so busy that Bullet's points of boxes are left to its own solver. */
const BUSY = 1000;

/** Who needs points of boxes that are those of this very step. */
export interface BoxSolver {
  /** Whether it took what touches these bodies, by pointer, in the last step. */
  solves(a: number, b: number): boolean;
  /** Whether it left them to Bullet. */
  leaves(a: number, b: number): boolean;
}

/**
 * Bullet adds one point to a manifold in each step and keeps those of earlier poses: of what rolls or turns they are wrong,
 * push from behind and gain energy. Here the points of all pairs with a cylinder, a cone, a hull or a mesh are worked out from the
 * poses of this very step, between Bullet's contact search, which says who is near whom, and its solver.
 */
export class ContactShapes extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  #bouncing = false;
  #busy = false;
  readonly #ammo: Ammo;
  readonly #old: OldPoints;
  readonly #writer: ManifoldWriter;
  /** By slot of the body. */
  readonly #forms: BodyForms[] = [];
  /** Bodies that were looked up since any of them became another, and their forms. */
  readonly #bodies = new PointerNumbers();
  readonly #near: (BodyForms | undefined)[] = [];
  #reviews = -1;
  /** Whether it concerns any body: of balls alone no pair is looked at. */
  #concerned = false;
  /** Searches of Bullet so far. */
  #searches = 0;
  readonly #points = new FoundPoints();
  readonly #convex = new ConvexContact();
  readonly #axes = new SeparatingAxes();
  /** Undefined: pairs of boxes have no points of their own. */
  solver: BoxSolver | undefined;
  /** Made for the first surface: its code comes with that. */
  #mesh: MeshContact | undefined;
  readonly #point: ContactPoint;
  readonly #normal = new Float64Array(3);
  readonly #rows = new Float64Array(MATRIX);
  readonly #origin = new Float64Array(3);

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    this.#ammo = simulation.engine.ammo;
    this.#old = new OldPoints(this.#ammo);
    this.#point = new ContactPoint(this.#ammo);
    this.#writer = new ManifoldWriter(this.#ammo, this.#old, DEFAULT_FRICTION);
  }

  /** What touches first is seen before `beforeStep` is: nothing of the world that was is to count then. */
  override reset(): void {
    this.#busy = false;
  }

  override beforeStep(): void {
    this.#old.clear();
    this.#review();
    const { bullet } = this.#simulation;
    this.#busy = bullet.manifoldCount > BUSY;
    if (this.#concerned) bullet.eachAwakeManifold(this.#keep);
  }

  override found(): void {
    this.#review();
    this.#searches++;
    const { bullet } = this.#simulation;
    this.#bouncing = this.#effects.caused(contactSurface)?.demands.bouncing ?? false;
    if (this.#concerned) bullet.eachAwakeManifold(this.#renew);
    // Who comes on in the middle of a step finds nothing of an earlier one.
    this.#old.clear();
  }

  #review(): void {
    const { reviews } = this.#simulation.bodies.moving;
    if (reviews === this.#reviews) return;
    this.#reviews = reviews;
    this.#bodies.clear();
    this.#near.length = 0;
    this.#concerned = this.#concernsAny();
  }

  #concernsAny(): boolean {
    for (const body of this.#simulation.bodies) if (concerns(body)) return true;
    return false;
  }

  /** Of boxes alone Bullet's points are good enough for its own solver, and where so many are near each other. */
  #isWanted(first: BodyForms, second: BodyForms, a: number, b: number): boolean {
    if (first.wanted || second.wanted) return true;
    if (!this.solver || !first.boxes || !second.boxes) return false;
    return this.#busy ? this.solver.solves(a, b) : !this.solver.leaves(a, b);
  }

  #formsAt(pointer: number): BodyForms | undefined {
    const { count } = this.#bodies;
    const number = this.#bodies.numberOf(pointer);
    if (number === count) this.#near[number] = this.#lookUp(pointer);
    return this.#near[number];
  }

  /** Forms of hulls and of meshes take milliseconds: they are made when a body comes, and not in the step of its first touch. */
  override need(node: Cause, reason: string): void {
    super.need(node, reason);
    const body = node as Partial<Body>;
    if (body.slot! >= 0) this.#formsOf(body as Body);
  }

  #lookUp(pointer: number): BodyForms | undefined {
    const body = this.#simulation.bodyAt(pointer);
    return body && this.#formsOf(body);
  }

  #formsOf(body: Body): BodyForms {
    const known = this.#forms[body.slot];
    if (known?.parts === body.solidParts) return known;
    return (this.#forms[body.slot] = formsOf(body));
  }

  readonly #keep = (manifold: number, a: number, b: number): void => {
    const first = this.#formsAt(a);
    const second = this.#formsAt(b);
    if (first && second && this.#isWanted(first, second, a, b)) this.#old.keep(manifold, a, b);
  };

  readonly #renew = (manifold: number, a: number, b: number): void => {
    const first = this.#formsAt(a);
    const second = this.#formsAt(b);
    if (!first || !second || !this.#isWanted(first, second, a, b)) return;
    const boxes = first.boxes && second.boxes;
    const careful = boxes && this.#bouncing;
    if (careful && speedBetween(this.#ammo, a, b) > SLOW) return;
    const partA = this.#partNumber(manifold, first, 0);
    const partB = this.#partNumber(manifold, second, 1);
    const ofA = first.forms[partA];
    const ofB = second.forms[partB];
    // Of two surfaces, and of a part without an outline, Bullet finds the points.
    if (!ofA || !ofB || !(ofA.form ?? ofB.form)) return;
    if (!(ofA.form ?? ofA.surface) || !(ofB.form ?? ofB.surface)) return;
    this.#place(a, ofA);
    this.#place(b, ofB);
    const limit = careful ? NEAR : breakingAt(this.#ammo, manifold);
    const isEmpty = firstPointAt(this.#ammo, manifold) === 0;
    if (isEmpty && ofA.form && ofB.form && areFar(ofA.placed, ofB.placed, limit)) return;
    const theirs = this.#guess(manifold, ofA.placed, ofB.placed);
    // One that lies deep in another is Bullet's: from there a nearest face is no longer where it came in.
    if (boxes && theirs < -OFF) return;
    if (!this.#find(manifold, ofA, ofB, theirs, limit)) return;
    const { least, count } = this.#points;
    // What Bullet finds deep in a mesh must not be missed; of what it has hardly in touch nothing is deep.
    if (ofA.surface ?? ofB.surface) {
      if (least > 0 && theirs < -OFF) return;
    } else if (least < Math.min(theirs, 0) - OFF) return;
    if (count === 0) return forgetPoints(this.#ammo, manifold);
    const old = this.#old;
    if (old.look(manifold, a, b)) this.#points.setBefore(old.first(0), old.first(1), old.first(2));
    this.#points.reduce();
    this.#writer.write(manifold, a, b, this.#points, partA, partB, ofA.surface ? 0 : 1);
  };

  get #meshContact(): MeshContact {
    return (this.#mesh ??= new MeshContact());
  }

  /** False: Bullet's points are to stay. */
  #find(manifold: number, ofA: PartForm, ofB: PartForm, theirs: number, limit: number): boolean {
    const points = this.#points;
    const normal = this.#normal;
    const a = ofA.placed;
    const b = ofB.placed;
    const known = theirs < Infinity;
    points.clear();
    if (ofB.surface)
      return this.#meshContact.find(manifold, a, b, ofB.surface, normal, known, limit, points);
    if (ofA.surface) {
      for (let k = 0; k < 3; k++) normal[k] = -normal[k]!;
      const sure = this.#meshContact.find(
        manifold,
        b,
        a,
        ofA.surface,
        normal,
        known,
        limit,
        points,
      );
      points.swap();
      return sure;
    }
    if (!known && this.#axes.separates(manifold, a, b, limit)) return true;
    // In single precision, of a long floor and a rim that rolls on it, Bullet's normal may point anywhere.
    if (apartAlong(a, b, normal) < theirs - OFF) preferAxes(a, b, normal);
    this.#convex.find(a, b, normal, limit, points, -1, theirs);
    if (points.count === 0) this.#axes.note(manifold, normal);
    return true;
  }

  /** The number of the part that a manifold is of, -1 where it does not say so: each pair of parts has one of its own. */
  #partNumber(manifold: number, { body, forms }: BodyForms, side: 0 | 1): number {
    if (forms.length <= 1) return 0;
    const point = firstPointAt(this.#ammo, manifold);
    return point === 0 ? -1 : partNumberAt(this.#point.at(point, 0, 0), body, side);
  }

  /** Once for all that it is near. */
  #place(body: number, part: PartForm): void {
    if (part.search === this.#searches) return;
    part.search = this.#searches;
    writeFrame(this.#ammo, body, this.#origin, this.#rows);
    part.placed.put(this.#rows, this.#origin, part.turn, part.origin);
  }

  /**
   * About where the normal points: that of the deepest point that Bullet has, else from middle to middle. Returns Bullet's
   * distance.
   */
  #guess(manifold: number, a: PlacedForm, b: PlacedForm): number {
    const normal = this.#normal;
    const least = writeDeepestNormal(this.#ammo, manifold, normal);
    if (least < Infinity) return least;
    for (let k = 0; k < 3; k++) normal[k] = a.origin[k]! - b.origin[k]!;
    const size = hypot(normal[0]!, normal[1]!, normal[2]!);
    if (size > 0) for (let k = 0; k < 3; k++) normal[k]! /= size;
    else normal[1] = 1;
    return least;
  }
}

/** Whether the balls around two forms are farther apart than `limit`, metres. */
function areFar(a: PlacedForm, b: PlacedForm, limit: number): boolean {
  const x = a.origin[0]! - b.origin[0]!;
  const y = a.origin[1]! - b.origin[1]!;
  const z = a.origin[2]! - b.origin[2]!;
  return x * x + y * y + z * z > (a.form.reach + b.form.reach + limit) ** 2;
}
