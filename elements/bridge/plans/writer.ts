import type { PhysicsNode, World } from '../../../physics-core/inside.js';
import type { GeometryData } from '../geometry/geometry-fields.js';
import type { Binding } from '../nodes/binding.js';
import { restoreState, stateOf } from './body-state.js';
import type { Drawing, Target } from '../drawing/drawing.js';
import { transformsAbove } from '../scopes/transforms.js';
import type { Following } from './following.js';
import type { Place, Plan } from './plan.js';

/** What was last made of a node's plan. */
interface Made {
  /** The collidable that a shortcut gives a body. */
  shortcut?: PhysicsNode | undefined;
  /** Its geometry. */
  shapes?: GeometryData[] | undefined;
  place?: Place | undefined;
}

/** Writes plans into the core: only what differs from the plan before. */
export class Writer {
  readonly #drawing: Drawing;
  readonly #following: Following;
  /** A node was made, changed its place, or went. */
  readonly #onnode: (binding: Binding) => void;

  readonly #made = new WeakMap<Binding, Made>();

  constructor(drawing: Drawing, following: Following, onnode: (binding: Binding) => void) {
    this.#drawing = drawing;
    this.#following = following;
    this.#onnode = onnode;
  }

  /** Makes, moves or patches a node; `from` is the world it was in. */
  apply(binding: Binding, plan: Plan, from: World | null): void {
    const { node } = binding;
    const moves = node && from !== plan.world;
    const carried = moves ? stateOf(node) : undefined;
    if (moves) this.remove(binding);
    if (!binding.node) this.#create(binding, plan);
    else this.#patch(binding, binding.node, plan);
    if (node && !moves && node.collection !== plan.collection)
      node.belongTo(plan.collection as typeof node.collection);
    if (carried) restoreState(binding.node!, carried);
    else if (moves === false) this.#followFor(binding, plan);
    this.#madeOf(binding).place = plan.place;
    binding.node!.name = binding.name;
    if (plan.targets) this.#setTargets(binding, plan.targets);
    this.#onnode(binding);
  }

  #madeOf(binding: Binding): Made {
    const made = this.#made.get(binding) ?? {};
    this.#made.set(binding, made);
    return made;
  }

  #create(binding: Binding, plan: Plan): void {
    const relations = { ...plan.relations };
    if (plan.shapes) relations.geometry = [this.#addShortcut(binding, plan)];
    const options = {
      host: binding.element,
      name: binding.name,
      collection: plan.collection,
      version: binding.scope?.version,
      start: plan.start,
    };
    const fields = { ...binding.authoredFields(), ...relations };
    binding.node = plan.world.add(binding.type.name, fields, options);
    binding.relations = plan.relations;
    // A body that came into another world brings its collidables along.
    if (binding.is('RigidBody')) for (const other of binding.uses) other.dirty();
  }

  #addShortcut(binding: Binding, { world, shapes }: Plan): PhysicsNode {
    const shortcut = world.add('CollidableShape', { shape: shapes }, { host: binding.element });
    Object.assign(this.#madeOf(binding), { shortcut, shapes });
    return shortcut;
  }

  #patch(binding: Binding, node: PhysicsNode, plan: Plan): void {
    this.#patchShapes(binding, node, plan);
    for (const name of new Set([
      ...Object.keys(binding.relations),
      ...Object.keys(plan.relations),
    ])) {
      if (plan.shapes && name === 'geometry') continue;
      if (sameRelation(binding.relations[name], plan.relations[name])) continue;
      if (name in plan.relations) node.set(name, plan.relations[name]);
      else binding.restore(name);
    }
    binding.relations = plan.relations;
  }

  /** `for` names another Transform than before: a body without a pose of its own goes there. */
  #followFor(binding: Binding, { start, place }: Plan): void {
    const { transform, name } = place ?? { transform: undefined, name: null };
    const before = this.#madeOf(binding).place;
    // A body moved in the tree comes under another Transform, too, but keeps its pose.
    const byName = name !== null || before?.name != null;
    if (!start || !transform || !byName || transform === before?.transform) return;
    if (!binding.wrote('position', 'orientation')) this.#following.jump(binding, start);
  }

  #patchShapes(binding: Binding, node: PhysicsNode, plan: Plan): void {
    const made = this.#madeOf(binding);
    const { shortcut } = made;
    if (sameRelation(made.shapes, plan.shapes)) return;
    if (!plan.shapes) {
      made.shortcut = undefined;
      node.set('geometry', plan.relations.geometry);
      shortcut?.remove();
    } else if (shortcut) shortcut.set('shape', plan.shapes);
    else node.set('geometry', [this.#addShortcut(binding, plan)]);
    made.shapes = plan.shapes;
  }

  #setTargets(binding: Binding, targets: Target[]): void {
    const above = targets.flatMap(({ element, scope }) => transformsAbove(element, scope));
    this.#drawing.setTargets(binding, targets, above);
    this.#following.redraw(binding);
  }

  remove(binding: Binding): void {
    binding.node?.remove();
    this.#madeOf(binding).shortcut?.remove();
    this.#made.delete(binding);
    binding.node = null;
    binding.relations = {};
    this.#drawing.forget(binding);
    this.#onnode(binding);
  }
}

function sameRelation(a: unknown, b: unknown): boolean {
  if (Array.isArray(a) && Array.isArray(b))
    return a.length === b.length && a.every((item, i) => sameRelation(item, b[i]));
  return a === b || (isData(a) && isData(b) && JSON.stringify(a) === JSON.stringify(b));
}

const isData = (value: unknown): boolean =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;
