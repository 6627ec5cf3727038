import type { Target } from '../drawing/drawing.js';
import { identity, type Affine } from '../geometry/matrix.js';
import type { Binding } from '../nodes/binding.js';
import { fromX3D } from '../x3dom/matrices.js';
import { matrixFor } from '../x3dom/placing.js';
import type { X3DNode } from '../x3dom/x3dom.js';
import type { X3DBounded, X3DShape, X3DTransform, Way } from '../x3dom/renderer.js';
import type { Instances } from './instances.js';
import { Late } from './late.js';
import { obstacle } from './look.js';
import { passes, Strand } from './strand.js';

// Scratch: nothing is allocated while bodies move.
const read: Affine = identity();

/** A Transform that a body moves, and the one Shape in it. */
export class Member {
  readonly transform: X3DTransform;
  /** What moves it. */
  body!: Binding;
  #target!: Target;
  /** Whether its author allows it to be drawn with others. */
  allowed = true;
  /** From what it stands in to its Shape. */
  strand!: Strand;
  /** As it was when a batch took it. */
  #taken: Strand | undefined;
  #late: Late | undefined;
  /** In the list of that batch. */
  at = -1;
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
    this.strand.measure();
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

  /** `moved` is told when it stands elsewhere. */
  take(moved: (local: Affine) => void): void {
    this.#taken = this.strand;
    this.#late = new Late(this.transform, (pose, linear) => moved(matrixFor(pose, linear)));
    this.strand.take(this.#late.settle, () => moved(this.readMatrix()));
  }

  giveBack(): void {
    this.detach();
    this.#late?.settle();
    this.#late = undefined;
    this.#taken?.giveBack();
    this.#taken = undefined;
  }

  /** What a body moves, as drawing has it now. */
  isTargetOf(target: Target): void {
    if (this.#target) this.detach();
    this.#target = target;
  }

  /** It stands as it is known here: its body writes its place into the list, past x3dom. */
  attach(): void {
    this.#target.row = this.#late;
  }

  /** Something of it changed: until it is looked at anew it is written as any other. */
  detach(): void {
    this.#target.row = undefined;
  }

  /** Somebody else may have written it. */
  readMatrix(): Affine {
    this.#late!.settle();
    return fromX3D(this.transform._trafo, read);
  }

  /** `above`: where the group is that it stands in. */
  place(local: Affine, above: Affine, instances: Instances): void {
    if (this.#seen) this.strand.place(local, above, instances, this.at);
    else instances.hide(this.at);
  }

  /** As if it were drawn by itself. */
  drawPlainly(...way: Way): void {
    this.#late?.settle();
    this.top._graph.globalMatrix = null;
    this.top.collectDrawableObjects(...way);
  }
}
