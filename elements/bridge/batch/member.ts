import type { Binding } from '../nodes/binding.js';
import type { X3DNode } from '../x3dom/x3dom.js';
import type { X3DBounded, X3DShape, X3DTransform, Way } from '../x3dom/renderer.js';
import { scalingOf } from './boxes.js';
import type { Instances } from './instances.js';
import { geometryOf, obstacle } from './look.js';
import { passes, Strand } from './strand.js';

/** A Transform that a body moves, and the one Shape in it. */
export class Member {
  readonly transform: X3DTransform;
  /** What moves it. */
  body!: Binding;
  /** Whether its author allows it to be drawn with others. */
  allowed = true;
  /** From what it stands in to its Shape. */
  strand!: Strand;
  /** As it was when a batch took it. */
  #taken: Strand | undefined;
  /** Not by `render` of anything of it. */
  #seen = false;
  /** Why it is drawn by itself. */
  why: string | undefined;

  constructor(transform: X3DTransform) {
    this.transform = transform;
  }

  get shape(): X3DShape | undefined {
    return this.strand.shape as X3DShape | undefined;
  }

  /** What stands in the group together with the others. */
  get top(): X3DBounded {
    return (this.#taken ?? this.strand).nodes[0]!;
  }

  get parent(): X3DBounded | undefined {
    return this.strand.nodes[0]!._parentNodes[0] as X3DBounded | undefined;
  }

  /** It left the document. */
  get gone(): boolean {
    return this.transform._xmlNode === null || this.transform._parentNodes.length === 0;
  }

  /** What it consists of now. `isMoved`: whether a body moves a node. */
  read(isMoved: (node: X3DNode) => boolean): void {
    this.strand = new Strand(this.transform, isMoved);
    this.why = this.#obstacle();
    if (this.why !== undefined) return;
    this.strand.measure(scalingOf(geometryOf(this.shape!)!));
    this.#seen = this.strand.seen;
  }

  #obstacle(): string | undefined {
    const { transform, parent, shape } = this;
    if (!this.allowed) return 'batch="false"';
    if (transform._parentNodes.length > 1) return 'it is drawn in several places';
    if (!passes(transform) || !parent || !passes(parent))
      return 'what it stands in chooses what is drawn';
    if (!shape) return 'it does not consist of one Shape';
    if ([...this.strand.nodes, shape].some(({ _vf }) => _vf.bboxDisplay))
      return 'its bounding box is shown';
    return obstacle(shape);
  }

  // ---- drawn by a batch -------------------------------------------------------------------------------------------

  /** Whether it stands as it did when a batch took it. */
  get isAsTaken(): boolean {
    return !this.#taken || this.#taken.isLike(this.strand);
  }

  /** From now on `place` is told of each of its places. */
  take(place: () => void): void {
    this.#taken = this.strand;
    this.strand.take(place);
  }

  giveBack(): void {
    this.#taken?.giveBack();
    this.#taken = undefined;
  }

  place(instances: Instances, at: number): void {
    if (this.#seen) this.strand.place(instances, at);
    else instances.hide(at);
  }

  /** As if it were drawn by itself. */
  drawPlainly(...way: Way): void {
    this.top._graph.globalMatrix = null;
    this.top.collectDrawableObjects(...way);
  }
}
