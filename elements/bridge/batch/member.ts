import { x3dom, type X3DVector } from '../x3dom/x3dom.js';
import type { X3DBounded, X3DShape, X3DTransform, X3DVolume, Way } from '../x3dom/renderer.js';
import { scaleOf } from './boxes.js';
import { geometryOf, obstacle } from './look.js';

const nativeOf = (type: string): X3DBounded => x3dom()!.nodeTypes[type].prototype as X3DBounded;

const draws = ({ collectDrawableObjects }: X3DBounded): boolean =>
  collectDrawableObjects !== nativeOf('X3DNode').collectDrawableObjects;

/** Whether it has x3dom draw all that stands in it, as groups and Transforms do. */
const passes = ({ constructor }: X3DBounded): boolean =>
  (constructor.prototype as X3DBounded).collectDrawableObjects ===
  nativeOf('X3DGroupingNode').collectDrawableObjects;

/** A Transform that a body moves, and the one Shape in it. */
export class Member {
  readonly transform: X3DTransform;
  /** Whether its author allows it to be drawn with others. */
  allowed = true;
  shape: X3DShape | undefined;
  parent: X3DBounded | undefined;
  /** Not by `render` of its Transform or its Shape. */
  seen = false;
  /** Of what is drawn for its geometry, and how far that reaches: in its own frame. */
  scale!: X3DVector;
  inside!: X3DVolume;
  /** Why it is drawn by itself. */
  why: string | undefined;

  constructor(transform: X3DTransform) {
    this.transform = transform;
  }

  /** It left the document. */
  get gone(): boolean {
    return this.transform._xmlNode === null || this.transform._parentNodes.length === 0;
  }

  /** What it consists of now. */
  read(): void {
    const { transform } = this;
    this.parent = transform._parentNodes[0] as X3DBounded;
    const [first, ...others] = (transform._childNodes as X3DBounded[]).filter(draws);
    const alone = others.length === 0 && first instanceof x3dom()!.nodeTypes.Shape;
    this.shape = alone ? (first as X3DShape) : undefined;
    this.seen = alone && transform.renderFlag() && first.renderFlag();
    this.why = this.#obstacle();
    if (this.why !== undefined) return;
    const geometry = geometryOf(this.shape!)!;
    this.scale = scaleOf(geometry);
    this.inside = (geometry as X3DBounded).getVolume();
  }

  #obstacle(): string | undefined {
    const { transform, parent, shape } = this;
    if (!this.allowed) return 'batch="false"';
    if (transform._parentNodes.length > 1) return 'it is drawn in several places';
    if (!passes(transform) || !parent || !passes(parent))
      return 'what it stands in chooses what is drawn';
    if (!shape) return 'it does not consist of one Shape';
    if (transform._vf.bboxDisplay || shape._vf.bboxDisplay) return 'its bounding box is shown';
    return obstacle(shape);
  }

  // ---- drawn by a batch -------------------------------------------------------------------------------------------

  /** From now on `place` is told of each of its places. */
  take(place: () => void): void {
    const { transform } = this;
    // Whoever writes a Transform's matrix calls this, x3dom itself included.
    transform.invalidateVolume = place;
    const { getVolume } = nativeOf('X3DTransformNode');
    transform.getVolume = () => {
      transform._graph.volume.valid = false;
      return getVolume.call(transform);
    };
  }

  giveBack(): void {
    const { transform } = this;
    Reflect.deleteProperty(transform, 'invalidateVolume');
    Reflect.deleteProperty(transform, 'getVolume');
    transform.invalidateVolume();
  }

  /** As if it were drawn by itself. */
  drawPlainly(...way: Way): void {
    this.transform._graph.globalMatrix = null;
    this.transform.collectDrawableObjects(...way);
  }
}
