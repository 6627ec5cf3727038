import { copyInto, identity, multiply, type Affine } from '../geometry/matrix.js';
import { fromX3D } from '../x3dom/matrices.js';
import { x3dom, type X3DMatrix, type X3DNode } from '../x3dom/x3dom.js';
import type { X3DBounded, X3DTransform } from '../x3dom/renderer.js';
import type { Instances } from './instances.js';
import { BOX, boxOf, reachInto } from './reach.js';
import { typeOf } from './types.js';

const nativeOf = (type: string): X3DBounded => x3dom()!.nodeTypes[type].prototype as X3DBounded;

const draws = ({ collectDrawableObjects }: X3DBounded): boolean =>
  collectDrawableObjects !== nativeOf('X3DNode').collectDrawableObjects;

/** Whether it has x3dom draw all that stands in it, as groups and Transforms do. */
export const passes = ({ constructor }: X3DBounded): boolean =>
  (constructor.prototype as X3DBounded).collectDrawableObjects ===
  nativeOf('X3DGroupingNode').collectDrawableObjects;

/** Groups that a body may have for itself. */
const GROUPS = new Set(['Group', 'Transform']);

/** What alone is drawn in a node. Asked of a group of thousands it looks at two. */
function onlyIn({ _childNodes }: X3DNode): X3DBounded | undefined {
  let only: X3DBounded | undefined;
  for (const child of _childNodes as X3DBounded[]) {
    if (!draws(child)) continue;
    if (only) return undefined;
    only = child;
  }
  return only;
}

/** A group all of which is drawn for one body: it stands in one place, and nothing else moves it. */
const isOwn = (node: X3DBounded, isMoved: (node: X3DNode) => boolean): boolean =>
  GROUPS.has(typeOf(node)) && node._parentNodes.length === 1 && !isMoved(node);

// Scratch: nothing is allocated while bodies move.
const whole: Affine = identity();
const outermost: Affine = identity();
const product: Affine = identity();
const reach = new Array<number>(BOX).fill(0);

/**
 * What stands between a Shape and the group that it is drawn in with others, from above to below: the Transform that a
 * body moves, and groups round that or in it in which nothing else is drawn.
 */
export class Strand {
  readonly nodes: X3DBounded[];
  readonly #transform: X3DTransform;
  /** Above that, from below to above. */
  readonly #outer: X3DTransform[];
  /** In the frame of the Transform that is moved: what is drawn, and how far it reaches. */
  #inner!: Affine;
  #inside!: number[];
  /** The last thing in it. */
  readonly shape: X3DBounded | undefined;

  constructor(transform: X3DTransform, isMoved: (node: X3DNode) => boolean) {
    this.#transform = transform;
    this.nodes = [transform];
    let below = onlyIn(transform);
    for (; below && isOwn(below, isMoved); below = onlyIn(below)) this.nodes.push(below);
    this.shape = below instanceof x3dom()!.nodeTypes.Shape ? below : undefined;
    const outer = [];
    let [above] = transform._parentNodes as X3DBounded[];
    for (
      ;
      above && isOwn(above, isMoved) && onlyIn(above);
      [above] = above._parentNodes as X3DBounded[]
    )
      outer.push(above);
    this.nodes.unshift(...outer.toReversed());
    this.#outer = outer.filter(({ _trafo }) => _trafo) as X3DTransform[];
  }

  /** `scaling`: of what is drawn, in the frame of the Shape. */
  measure(scaling: X3DMatrix): void {
    const below = this.nodes.slice(this.nodes.indexOf(this.#transform) + 1);
    const matrix = below.reduceRight((m, { _trafo }) => (_trafo ? _trafo.mult(m) : m), scaling);
    this.#inner = fromX3D(matrix);
    this.#inside = boxOf((below[0] ?? this.shape!).getVolume());
  }

  /** `local`: the matrix of the Transform that is moved. */
  place(local: Affine, instances: Instances, at: number): void {
    let [matrix, last, box] = [local, local, this.#inside];
    // x3dom takes the bounds of the bounds at each of them.
    for (const { _trafo } of this.#outer) {
      reachInto(last, box, reach, 0);
      last = fromX3D(_trafo, outermost);
      matrix = copyInto(multiply(last, matrix, product), whole);
      box = reach;
    }
    instances.place(at, matrix, this.#inner);
    instances.reach(at, last, box);
  }

  get seen(): boolean {
    return [...this.nodes, this.shape!].every((node) => node.renderFlag());
  }

  isLike(other: Strand): boolean {
    const { nodes, shape } = other;
    return (
      shape === this.shape &&
      nodes.length === this.nodes.length &&
      nodes.every((node, i) => node === this.nodes[i])
    );
  }

  // ---- drawn by a batch -------------------------------------------------------------------------------------------

  /** From now on `reread` is called when somebody moved any of it, and `settle` before x3dom asks how far it reaches. */
  take(settle: () => void, reread: () => void): void {
    for (const node of this.nodes) {
      // Whoever writes a Transform's matrix calls this, x3dom itself included.
      node.invalidateVolume = reread;
      const { getVolume } = Object.getPrototypeOf(node) as X3DBounded;
      node.getVolume = () => {
        settle();
        node._graph.volume.valid = false;
        return getVolume.call(node);
      };
    }
  }

  giveBack(): void {
    for (const node of this.nodes) {
      const { invalidateVolume, getVolume } = Object.getPrototypeOf(node) as X3DBounded;
      // What a property is deleted of is slow from then on.
      Object.assign(node, { invalidateVolume, getVolume });
    }
    this.nodes.at(-1)!.invalidateVolume();
  }
}
