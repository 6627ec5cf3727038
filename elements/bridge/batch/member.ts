import { x3dom } from '../x3dom/x3dom.js';
import type { X3DBounded, X3DShape, X3DTransform } from '../x3dom/renderer.js';
import { appearanceOf, geometryOf, obstacle } from './look.js';
import { takeBounds } from './bounds.js';

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
  /** Why it is drawn by itself. */
  why: string | undefined;
  /** It stands elsewhere since it was last written down. */
  moved = true;
  /** Whether it was to be seen then. */
  shown = true;
  /** Somebody asks for it to be looked at anew. */
  stale = true;
  #children = 0;
  #state: unknown[] = [];

  constructor(transform: X3DTransform) {
    this.transform = transform;
  }

  /** It left the document. */
  get gone(): boolean {
    return this.transform._xmlNode === null || this.transform._parentNodes.length === 0;
  }

  /** Whether anything that decides how it is drawn may be otherwise than when it was last read. */
  get changed(): boolean {
    const { transform, shape } = this;
    if (this.stale || transform._childNodes.length !== this.#children) return true;
    if (transform._parentNodes[0] !== this.parent || transform._parentNodes.length > 1) return true;
    return shape !== undefined && (isDirty(shape) || !isAs(this.#state, transform, shape));
  }

  /** What it consists of now. */
  read(): void {
    const { transform } = this;
    this.stale = false;
    this.#children = transform._childNodes.length;
    this.parent = transform._parentNodes[0] as X3DBounded;
    const drawn = (transform._childNodes as X3DBounded[]).filter(draws);
    this.shape = drawn.length === 1 ? (drawn[0] as X3DShape) : undefined;
    this.#state = this.shape ? stateOf(transform, this.shape) : [];
    this.why = this.#obstacle(drawn);
  }

  #obstacle(drawn: X3DBounded[]): string | undefined {
    const { transform, parent } = this;
    if (!this.allowed) return 'batch="false"';
    if (transform._parentNodes.length > 1) return 'it is drawn in several places';
    if (!passes(transform) || !parent || !passes(parent)) return 'what it stands in chooses what is drawn';
    if (drawn.length !== 1 || !(drawn[0] instanceof x3dom()!.nodeTypes.Shape))
      return 'it consists of several Shapes';
    if (showsBounds(transform)) return BOUNDS;
    return obstacle(drawn[0] as X3DShape);
  }

  get seen(): boolean {
    return this.transform.renderFlag() && this.shape!.renderFlag();
  }

  // ---- drawn by a batch -------------------------------------------------------------------------------------------

  /** x3dom passes it by; its place is asked of it by who draws it. */
  take(): void {
    const { transform, shape } = this;
    this.moved = true;
    // What of it lies in WebGL is of no use meanwhile.
    shape!._cleanupGLObjects?.(true);
    transform.collectDrawableObjects = () => undefined;
    takeBounds(this);
  }

  giveBack(): void {
    const { transform } = this;
    for (const name of ['collectDrawableObjects', 'getVolume', 'invalidateVolume'])
      Reflect.deleteProperty(transform, name);
    transform.invalidateVolume();
  }

  /** As if it were drawn by itself. */
  drawPlainly(...way: Parameters<X3DBounded['collectDrawableObjects']>): void {
    nativeOf('X3DGroupingNode').collectDrawableObjects.call(this.transform, ...way);
  }
}

const BOUNDS = 'its bounding box is shown';

const showsBounds = (transform: X3DBounded): boolean =>
  Boolean(transform._vf.bboxDisplay) || transform._childNodes.some(({ _vf }) => _vf.bboxDisplay);

/** What x3dom reads in each frame, and tells nobody of. */
function stateOf(transform: X3DBounded, shape: X3DShape): unknown[] {
  const [geometry, appearance] = [geometryOf(shape), appearanceOf(shape)];
  return [
    geometry,
    appearance,
    geometry?._vf.solid,
    geometry?._vf.ccw,
    appearance?._vf.sortType,
    appearance?._vf.sortKey,
    shape._vf.isPickable,
    shape._vf.bboxDisplay,
    transform._vf.bboxDisplay,
  ];
}

/** The same, asked of all in every frame: without a list. */
function isAs(state: unknown[], { _vf }: X3DBounded, shape: X3DShape): boolean {
  const [geometry, appearance] = [geometryOf(shape), appearanceOf(shape)];
  return (
    geometry === state[0] &&
    appearance === state[1] &&
    geometry?._vf.solid === state[2] &&
    geometry?._vf.ccw === state[3] &&
    appearance?._vf.sortType === state[4] &&
    appearance?._vf.sortKey === state[5] &&
    shape._vf.isPickable === state[6] &&
    shape._vf.bboxDisplay === state[7] &&
    _vf.bboxDisplay === state[8]
  );
}

/** What has changed of a Shape since x3dom last drew it by itself. */
function isDirty({ _dirty: dirty }: X3DShape): boolean {
  return (
    dirty.positions ||
    dirty.indexes ||
    dirty.normals ||
    dirty.texcoords ||
    dirty.colors ||
    dirty.material ||
    dirty.texture ||
    dirty.shader
  );
}
