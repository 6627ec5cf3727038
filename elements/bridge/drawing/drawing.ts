import type { Binding } from '../nodes/binding.js';
import { copyInto, identity, multiply, poseMatrix, type Affine } from '../geometry/matrix.js';
import type { Scope } from '../scopes/scope.js';
import { Sets } from '../base/sets.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { noteDrawn } from '../x3dom/matrices.js';
import { placeNode } from '../x3dom/placing.js';
import { nodeOf, type X3DNode } from '../x3dom/x3dom.js';
import { Above } from './above.js';

/** A node that something else than x3dom draws: its place goes there alone, and nothing is asked of it. */
export interface Row {
  readonly node: X3DNode;
  readonly parent: X3DNode | undefined;
  /** In the frame of the parent. It is written here, then `moved` is called. */
  readonly pose: Affine;
  moved(linear: number[] | undefined): void;
}

/** Something that a body moves on the screen. */
export interface Target {
  /** A Transform, or a collidable that stands in the scene. */
  element: Element;
  scope: Scope;
  /** Its pose in the body's frame. */
  arm?: Affine | undefined;
  /** The scale that its picture has beside the body's pose. */
  linear?: number[] | undefined;
  /** What x3dom had of it when it was last drawn. */
  node?: X3DNode | undefined;
  /** Where its place is written instead, as long as it is drawn with others. */
  row?: Row | undefined;
}

/** What a body moves. */
interface Moved {
  body: Binding;
  targets: readonly Target[];
  above: readonly Element[];
}

/** The slice of a body's node that drawing needs. */
interface Body {
  slot: number;
  /** One look for each body that moves. */
  drawn: unknown;
}

const POSE = 7;

// Scratch: nothing is allocated while bodies move.
const own: Affine = identity();
const product: Affine = identity();

/** Writes poses straight into x3dom's matrices, past its fields and attributes, so that none comes back as an edit. */
export class Drawing {
  /** Targets by the Transforms above them: when one of those moves, the local matrix below changes. */
  readonly #under = new Sets<Element, Binding>();
  readonly #targets = new Map<Binding, Moved>();
  readonly #byElement = new Map<Element, Binding>();
  readonly #above = new Above();

  readonly #requestRender: () => void;
  /** What a body moves came, or is to be looked at anew. */
  readonly #onshow: (node: X3DNode, target: Target, binding: Binding) => void;

  constructor(
    requestRender: () => void,
    onshow: (node: X3DNode, target: Target, binding: Binding) => void,
  ) {
    this.#requestRender = requestRender;
    this.#onshow = onshow;
  }

  /** What a body moves from now on, and the Transforms above that. */
  setTargets(binding: Binding, targets: Target[], above: Element[]): void {
    this.forget(binding);
    const moved: Moved = { body: binding, targets, above };
    this.#targets.set(binding, moved);
    for (const { element } of targets) this.#byElement.set(element, binding);
    for (const element of above) this.#under.add(element, binding);
    if (binding.node) (binding.node as unknown as Body).drawn = moved;
    this.#show(binding);
  }

  forget(binding: Binding): void {
    const known = this.#targets.get(binding);
    if (!known) return;
    this.#targets.delete(binding);
    for (const { element } of known.targets) {
      if (this.#byElement.get(element) === binding) this.#byElement.delete(element);
    }
    for (const element of known.above) this.#under.delete(element, binding);
    known.targets = [];
  }

  /** The body that moves an element. */
  bodyMoving(element: Element): Binding | undefined {
    return this.#byElement.get(element);
  }

  targetsOf(binding: Binding): readonly Target[] {
    return this.#targets.get(binding)?.targets ?? [];
  }

  /** The bodies below a Transform. */
  bodiesUnder(element: Element): Iterable<Binding> {
    return this.#under.get(element) ?? [];
  }

  /** Draws the bodies that moved. */
  drawMoved(physics: PageWorld): void {
    const { moved, movedCount, data } = physics.poses;
    this.#above.forget();
    for (let i = 0; i < movedCount; i++) {
      const known = physics.bodies.in(moved[i])?.drawn as Moved | undefined;
      if (known) this.#draw(known, moved[i] * POSE, data);
    }
    if (movedCount > 0) this.#requestRender();
  }

  /** Draws a body where it is: it or what it moves came anew. */
  redraw(binding: Binding): void {
    this.#above.forget();
    // First: what x3dom read anew has no row any more.
    this.#show(binding);
    this.#redraw(binding);
  }

  #show(binding: Binding): void {
    for (const target of this.targetsOf(binding)) {
      const node = nodeOf(target.element);
      if (node?._trafo) this.#onshow(node, target, binding);
    }
  }

  #redraw(binding: Binding): void {
    const body = binding.node as Body | null;
    if (!body || !binding.world || body.slot < 0) return;
    const known = this.#targets.get(binding);
    if (known) this.#draw(known, body.slot * POSE, binding.world.poses.data);
    this.#requestRender();
  }

  #draw({ body, targets }: Moved, at: number, data: Float64Array): void {
    for (const target of targets) {
      if (target.row) this.#writeRow(target.row, target, at, data);
      else if (!this.#write(nodeOf(target.element), target, at, data)) continue;
      const under = this.#under.isEmpty ? undefined : this.#under.get(target.element);
      if (under) for (const below of under) if (below !== body) this.#redraw(below);
    }
  }

  #writeRow(row: Row, target: Target, at: number, data: Float64Array): void {
    this.#posed(target, row.parent, at, data, row.pose);
    row.moved(target.linear);
    this.#written(row.node, target);
  }

  /** False where there is nothing to move. */
  #write(node: X3DNode | undefined, target: Target, at: number, data: Float64Array): boolean {
    if (!node?._trafo) return false;
    this.#posed(target, node._parentNodes[0], at, data, own);
    placeNode(node, own, target.linear);
    node.invalidateVolume();
    this.#written(node, target);
    return true;
  }

  #written(node: X3DNode, target: Target): void {
    if (node !== target.node) noteDrawn((target.node = node));
    this.#above.moved(node);
  }

  /** Where it is in the frame of its parent. */
  #posed(
    { scope, arm }: Target,
    parent: X3DNode | undefined,
    at: number,
    data: Float64Array,
    out: Affine,
  ): void {
    poseMatrix(data, at, 1 / scope.units.length, out);
    if (arm) copyInto(multiply(out, arm, product), out);
    const inverse = this.#above.inverseIn(parent);
    if (inverse) copyInto(multiply(inverse, out, product), out);
  }
}
