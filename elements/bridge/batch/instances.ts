import type { Affine } from '../geometry/matrix.js';
import type { X3DColor, X3DVolume } from '../x3dom/renderer.js';
import type { X3DVector } from '../x3dom/x3dom.js';
import type { Passes } from './passes.js';
import { AFFINE, placeInto } from './products.js';
import { BOX, reachInto } from './reach.js';
import { InstanceRows, LOOK, type Placed } from './rows.js';

const FEW = 8;

/** What tells the bodies of one batch apart, and how far each of them reaches. */
export class Instances implements Placed {
  count = 0;
  models = new Float64Array(FEW * AFFINE);
  looks = new Float32Array(FEW * LOOK);
  /** How far each of them reaches. */
  #boxes = new Float64Array(FEW * BOX);
  /** By what they are drawn for. */
  readonly #rows: InstanceRows[] = [];
  /** That the next draw call takes. */
  #bound: InstanceRows | undefined;

  /** The place of one more. */
  add(): number {
    const at = this.count++;
    if (this.count * AFFINE > this.models.length) this.#grow();
    return at;
  }

  #grow(): void {
    const { models, looks } = this;
    const boxes = this.#boxes;
    this.models = new Float64Array(2 * models.length);
    this.looks = new Float32Array(2 * looks.length);
    this.#boxes = new Float64Array(2 * boxes.length);
    this.models.set(models);
    this.looks.set(looks);
    this.#boxes.set(boxes);
  }

  /** The last one comes to this place. */
  remove(at: number): void {
    const last = --this.count;
    this.models.copyWithin(at * AFFINE, last * AFFINE, (last + 1) * AFFINE);
    this.looks.copyWithin(at * LOOK, last * LOOK, (last + 1) * LOOK);
    this.#boxes.copyWithin(at * BOX, last * BOX, (last + 1) * BOX);
    this.#note(at);
  }

  #note(at: number): void {
    for (let i = 0; i < this.#rows.length; i++) this.#rows[i]?.note(at);
  }

  // ---- one instance -----------------------------------------------------------------------------------------------

  /** `local`: from the frame of its Shape to that of its group; `above`: from there to the world. */
  place(at: number, above: Affine, local: Affine): void {
    placeInto(above, local, this.models, at * AFFINE);
    this.#note(at);
  }

  /** `box`: how far it reaches in the frame of `m`. */
  reach(at: number, m: Affine, box: number[]): void {
    reachInto(m, box, this.#boxes, at * BOX);
  }

  /** Of no size, it covers no pixel, and reaches nowhere. */
  hide(at: number): void {
    this.models.fill(0, at * AFFINE, (at + 1) * AFFINE);
    this.#boxes.fill(NaN, at * BOX, (at + 1) * BOX);
    this.#note(at);
  }

  look(at: number, { x, y, z }: X3DVector, id: number, { r, g, b }: X3DColor): void {
    this.looks.set([x, y, z, id, r, g, b], at * LOOK);
    this.#note(at);
  }

  // ---- all --------------------------------------------------------------------------------------------------------

  /** How far they reach together. */
  bounds({ min, max }: X3DVolume): void {
    const boxes = this.#boxes;
    min.x = min.y = min.z = Infinity;
    max.x = max.y = max.z = -Infinity;
    for (let i = 0; i < this.count * BOX; i += BOX) {
      if (boxes[i] < min.x) min.x = boxes[i];
      if (boxes[i + 1] < min.y) min.y = boxes[i + 1];
      if (boxes[i + 2] < min.z) min.z = boxes[i + 2];
      if (boxes[i + 3] > max.x) max.x = boxes[i + 3];
      if (boxes[i + 4] > max.y) max.y = boxes[i + 4];
      if (boxes[i + 5] > max.z) max.z = boxes[i + 5];
    }
  }

  /** The next draw call takes them. */
  bind(gl: WebGL2RenderingContext, eye: Passes): void {
    this.#bound = this.#rows[eye.index] ??= new InstanceRows(eye.pass);
    this.#bound.bind(gl, eye, this);
  }

  unbind(gl: WebGL2RenderingContext): void {
    this.#bound?.unbind(gl);
  }

  free(gl: WebGL2RenderingContext): void {
    for (const rows of this.#rows) rows?.free(gl);
  }
}
