import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Ammo } from '../../engine/ammo.js';
import { MATRIX } from '../../base/matrix.js';
import { writeFrame } from '../../engine/body-heap.js';
import { breakingAt, childAt, writeDeepestNormal } from '../../engine/manifold.js';
import { ManifoldWriter } from '../../engine/manifold-writer.js';
import { OldPoints } from '../../engine/old-points.js';
import { DEFAULT_FRICTION } from '../../dynamics/contact-parameters.js';
import type { Form } from '../../shapes/forms/form.js';
import { Effect, type EffectDescriptor } from '../effect/effect.js';
import { formsOf, wanted, type BodyForms, type PartForm } from './body-forms.js';
import { ConvexContact } from './convex-contact.js';
import { FoundPoints } from './found-points.js';
import { PlacedForm } from './placed-form.js';

/**
 * Bullet adds one point to a manifold in each step and keeps those of earlier poses: of what rolls or turns they are wrong,
 * push from behind and gain energy. Here the points of all pairs with a cylinder, a cone or a hull are worked out from the
 * poses of this very step, between Bullet's contact search, which says who is near whom, and its solver.
 */
export class ContactShapes extends Effect {
  readonly #simulation: Simulation;
  readonly #ammo: Ammo;
  readonly #old: OldPoints;
  readonly #writer: ManifoldWriter;
  /** By slot of the body. */
  readonly #forms: BodyForms[] = [];
  readonly #points = new FoundPoints();
  readonly #convex = new ConvexContact();
  readonly #a = new PlacedForm();
  readonly #b = new PlacedForm();
  readonly #normal = new Float64Array(3);
  readonly #rows = new Float64Array(MATRIX);
  readonly #origin = new Float64Array(3);

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
    this.#ammo = simulation.engine.ammo;
    this.#old = new OldPoints(this.#ammo);
    this.#writer = new ManifoldWriter(this.#ammo, this.#old, DEFAULT_FRICTION);
  }

  override beforeStep(): void {
    if (!this.#simulation.engine.heapTrusted) return;
    this.#old.clear();
    this.#simulation.bullet.eachAwakeManifold(this.#keep);
  }

  override found(): void {
    this.#simulation.bullet.eachAwakeManifold(this.#renew);
  }

  #formsAt(pointer: number): BodyForms | undefined {
    const body = this.#simulation.bodyAt(pointer);
    if (!body) return undefined;
    const known = this.#forms[body.slot];
    if (known?.parts === body.solidParts) return known;
    return (this.#forms[body.slot] = formsOf(body));
  }

  readonly #keep = (manifold: number, a: number, b: number): void => {
    const [first, second] = [this.#formsAt(a), this.#formsAt(b)];
    if (first && second && (first.wanted || second.wanted)) this.#old.keep(manifold, a, b);
  };

  readonly #renew = (manifold: number, a: number, b: number): void => {
    const [first, second] = [this.#formsAt(a), this.#formsAt(b)];
    if (!first || !second || !(first.wanted || second.wanted)) return;
    const partA = this.#partNumber(manifold, first, 0);
    const partB = this.#partNumber(manifold, second, 1);
    const [ofA, ofB] = [first.forms[partA], second.forms[partB]];
    if (!ofA?.form || !ofB?.form) return;
    this.#place(this.#a, a, ofA.form, ofA);
    this.#place(this.#b, b, ofB.form, ofB);
    this.#guess(manifold);
    const points = this.#points;
    points.clear();
    const limit = breakingAt(this.#ammo, manifold);
    this.#convex.find(this.#a, this.#b, this.#normal, limit, points);
    points.reduce();
    this.#old.look(manifold, a, b);
    this.#writer.write(manifold, a, b, points, partA, partB);
  };

  /** The number of the part that a manifold is of, -1 where it does not say so: each pair of parts has one of its own. */
  #partNumber(manifold: number, { forms }: BodyForms, side: 0 | 1): number {
    return forms.length <= 1 ? 0 : childAt(this.#ammo, manifold, side);
  }

  #place(placed: PlacedForm, body: number, form: Form, { turn, origin }: PartForm): void {
    writeFrame(this.#ammo, body, this.#origin, this.#rows);
    placed.put(form, this.#rows, this.#origin, turn, origin);
  }

  /** About where the normal points: that of the deepest point that Bullet has, else from middle to middle. */
  #guess(manifold: number): void {
    const normal = this.#normal;
    if (writeDeepestNormal(this.#ammo, manifold, normal)) return;
    for (let k = 0; k < 3; k++) normal[k] = this.#a.origin[k]! - this.#b.origin[k]!;
    const size = Math.hypot(normal[0]!, normal[1]!, normal[2]!);
    if (size > 0) for (let k = 0; k < 3; k++) normal[k]! /= size;
    else normal[1] = 1;
  }
}

const reasonOf = (body: Body): string | undefined => wanted(body) && 'geometry';

export const contactShapes: EffectDescriptor<ContactShapes> = {
  name: 'contact shapes',
  causes: 'a body with a cylinder, a cone or a hull',
  body: { on: ['mass'], reason: reasonOf },
  load: (simulation) => new ContactShapes(simulation),
};
