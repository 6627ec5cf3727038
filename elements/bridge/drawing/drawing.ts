import type { Binding } from '../nodes/binding.js';
import {
  copyInto,
  identity,
  invert,
  multiply,
  poseMatrix,
  quaternionInto,
  type Affine,
} from '../geometry/matrix.js';
import type { Scope } from '../scopes/scope.js';
import { Sets } from '../base/sets.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { fromX3D, intoX3D, noteDrawn } from '../x3dom/matrices.js';
import { nodeOf, type X3DNode, type X3DQuaternion, type X3DVector } from '../x3dom/x3dom.js';

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
  host: unknown;
}

const POSE = 7;

// Scratch: nothing is allocated while bodies move.
const world: Affine = identity();
const parent: Affine = identity();
const factor: Affine = identity();
const product: Affine = identity();

/** World matrix of x3dom's node above; false when nothing above is a Transform. */
function parentMatrix(node: X3DNode): boolean {
  let found = false;
  for (let at = node._parentNodes[0]; at; at = at._parentNodes[0]) {
    if (!at._trafo) continue;
    if (!found) fromX3D(at._trafo, parent);
    else copyInto(multiply(fromX3D(at._trafo, factor), parent, product), parent);
    found = true;
  }
  return found;
}

function linearMatrix([a, b, c, d, e, f, g, h, i]: number[]): Affine {
  factor[0] = a;
  factor[1] = b;
  factor[2] = c;
  factor[3] = 0;
  factor[4] = d;
  factor[5] = e;
  factor[6] = f;
  factor[7] = 0;
  factor[8] = g;
  factor[9] = h;
  factor[10] = i;
  factor[11] = 0;
  return factor;
}

/** Writes poses straight into x3dom's matrices, past its fields and attributes, so that none comes back as an edit. */
export class Drawing {
  /** Targets by the Transforms above them: when one of those moves, the local matrix below changes. */
  readonly #under = new Sets<Element, Binding>();
  readonly #targets = new Map<Binding, Moved>();
  readonly #byElement = new Map<Element, Binding>();
  /** The same by the body's node: one look for each body that moves. */
  readonly #byNode = new WeakMap<object, Moved>();

  readonly #requestRender: () => void;
  /** What a body moves came, or is to be looked at anew. */
  readonly #onshow: (node: X3DNode, binding: Binding) => void;

  constructor(requestRender: () => void, onshow: (node: X3DNode, binding: Binding) => void) {
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
    if (binding.node) this.#byNode.set(binding.node, moved);
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
    for (let i = 0; i < movedCount; i++) {
      const body = physics.bodies.at(moved[i]) as Body | undefined;
      const known = body && this.#byNode.get(body);
      if (known) this.#draw(known, moved[i] * POSE, data);
    }
    if (movedCount > 0) this.#requestRender();
  }

  /** Draws a body where it is: it or what it moves came anew. */
  redraw(binding: Binding): void {
    this.#redraw(binding);
    for (const { element } of this.targetsOf(binding)) {
      const node = nodeOf(element);
      if (node?._trafo) this.#onshow(node, binding);
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
      const node = nodeOf(target.element);
      if (!node?._trafo) continue;
      this.#write(node, target, at, data);
      const under = this.#under.isEmpty ? undefined : this.#under.get(target.element);
      if (under) for (const below of under) if (below !== body) this.#redraw(below);
    }
  }

  #write(node: X3DNode, target: Target, at: number, data: Float64Array): void {
    poseMatrix(data, at, 1 / target.scope.units.length, world);
    if (target.arm) copyInto(multiply(world, target.arm, product), world);
    if (parentMatrix(node)) copyInto(multiply(invert(parent, factor), world, product), world);
    const local = target.linear ? multiply(world, linearMatrix(target.linear), product) : world;
    intoX3D(local, node._trafo!);
    if (node._vf.translation && node._vf.center) keepFields(node, local, world);
    if (node !== target.node) noteDrawn((target.node = node));
    node.invalidateVolume();
  }
}

/**
 * A Transform's own fields, true to its matrix. Its translation is where the matrix takes its centre, less the
 * centre: rotation and scale leave that point alone.
 */
function keepFields(node: X3DNode, local: Affine, rigid: Affine): void {
  const translation = node._vf.translation as X3DVector;
  const { x, y, z } = node._vf.center as X3DVector;
  translation.x = local[0] * x + local[1] * y + local[2] * z + local[3] - x;
  translation.y = local[4] * x + local[5] * y + local[6] * z + local[7] - y;
  translation.z = local[8] * x + local[9] * y + local[10] * z + local[11] - z;
  const rotation = node._vf.rotation as X3DQuaternion;
  quaternionInto(rigid, rotation);
}
