import { identity, multiply, type Affine } from '../geometry/matrix.js';
import { fromX3D } from '../x3dom/matrices.js';
import { x3dom, type X3DNode } from '../x3dom/x3dom.js';
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
const part: Affine = identity();
const product = identity();
const next = identity();
const reach = new Array<number>(BOX).fill(0);

/**
 * What stands between a Shape and the group that it is drawn in with others, from above to below: the Transform that a
 * body moves, and groups round that or in it in which nothing else is drawn.
 */
export class Strand {
  readonly nodes: X3DBounded[];
  readonly #transform: X3DTransform;
  /** All that have a matrix, from above to below. */
  readonly #transforms: X3DTransform[];
  /** Those above the one that is moved, from below to above. */
  readonly #outer: X3DTransform[];
  /** Nothing but the one that is moved. */
  readonly #alone: boolean;
  /** How far it reaches in the frame of the Transform that is moved. */
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
    this.#transforms = this.nodes.filter(({ _trafo }) => _trafo) as X3DTransform[];
    this.#alone = this.#transforms.length === 1;
  }

  measure(): void {
    const below = this.nodes[this.nodes.indexOf(this.#transform) + 1];
    this.#inside = boxOf((below ?? this.shape!).getVolume());
  }

  /** `local`: the matrix of the Transform that is moved, `above`: that of what all of it stands in. */
  place(local: Affine, above: Affine, instances: Instances, at: number): void {
    if (this.#alone) {
      instances.reach(at, local, this.#inside);
      return instances.place(at, above, local);
    }
    let matrix = local;
    let box = this.#inside;
    // x3dom takes the bounds of the bounds at each of them.
    for (const { _trafo } of this.#outer) {
      reachInto(matrix, box, reach, 0);
      matrix = fromX3D(_trafo, part);
      box = reach;
    }
    instances.reach(at, matrix, box);
    this.#placeWhole(local, above, instances, at);
  }

  /** From above to below, as x3dom multiplies. */
  #placeWhole(local: Affine, above: Affine, instances: Instances, at: number): void {
    let whole = above;
    const last = this.#transforms.length - 1;
    for (let i = 0; i <= last; i++) {
      const { _trafo } = this.#transforms[i]!;
      const own = this.#transforms[i] === this.#transform ? local : fromX3D(_trafo, part);
      if (i === last) instances.place(at, whole, own);
      else whole = multiply(whole, own, whole === product ? next : product);
    }
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
