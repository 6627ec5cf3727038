import { Bounds } from '../../matter/bounds.js';
import { isHidden } from '../../matter/hidden.js';
import { OwnShape } from '../../matter/own-shape.js';
import type { X3DNode } from '../../x3dom/x3dom.js';
import type { Form } from './form.js';
import { lineForm } from './line.js';
import { Tube } from './tube.js';

/** Where a rope is, metres: as the last step left it, and how fast that went there. */
export interface ShownRope {
  places: Float64Array;
  velocities: Float64Array;
  /** Another number whenever it is elsewhere. */
  moves: number;
  /** Seconds before the end of that step: then it is shown. */
  since: number;
}

/** A rope, drawn instead of its author's Shape. */
export class RopeShape extends OwnShape {
  readonly #rope: Element;
  readonly #isTube: boolean;
  readonly #bounds: Bounds;
  #form: Form | undefined;
  #radius = 0;
  #unit = 0;
  #points = new Float64Array(0);
  #moves = -1;
  #since = -1;

  constructor(rope: Element, instead: X3DNode, appearance: X3DNode, isTube: boolean) {
    super(instead, appearance, isTube ? 'IndexedTriangleSet' : 'LineSet');
    this.#rope = rope;
    this.#isTube = isTube;
    this.#bounds = new Bounds(this.shape);
  }

  /** A Shape in the rope stands in nothing that x3dom draws: the rope does. */
  protected override get hidden(): boolean {
    return super.hidden || isHidden(this.#rope);
  }

  /** `radius`: metres; `unit`: metres of one unit of what x3dom draws. */
  show({ places, velocities, moves, since }: ShownRope, radius: number, unit: number): void {
    const isOther =
      this.#points.length !== places.length || this.#radius !== radius || this.#unit !== unit;
    if (!isOther && this.#moves === moves && this.#since === since) return;
    this.#moves = moves;
    this.#since = since;
    if (isOther) this.#grow(places.length / 3, radius, unit);
    const points = this.#points;
    for (let i = 0; i < points.length; i++)
      points[i] = (places[i]! - since * velocities[i]!) / unit;
    const form = this.#form!;
    form.write(points);
    this.#bounds.around(points, form.reach);
    this.upload('POSITION', form.positions);
    if (form.normals.length > 0) this.upload('NORMAL', form.normals);
    this.draw();
  }

  #grow(count: number, radius: number, unit: number): void {
    this.#radius = radius;
    this.#unit = unit;
    this.#points = new Float64Array(3 * count);
    const form = this.#isTube ? new Tube(count, radius / unit) : lineForm(count);
    this.#form = form;
    this.mesh._positions[0] = form.positions;
    this.mesh._normals[0] = form.normals;
    this.mesh._texCoords[0] = form.texCoords;
    this.mesh._indices[0] = form.index;
    this.remake();
  }
}
