import type { PhysicsNode } from '../../../physics-core/inside.js';
import type { Binding } from './binding.js';
import { restoreState, stateOf } from './body-state.js';
import type { Plan } from './plan.js';
import type { Target } from '../drawing/drawing.js';
import type { Scene } from '../scene.js';
import { transformsAbove } from '../geometry/transforms.js';
import type { PageWorld } from './worlds.js';

/** Writes plans into the core: only what differs from the plan before. */
export class Writer {
  readonly #scene: Scene;

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  /** Makes, moves or patches a node; `from` is the world it was in. */
  apply(binding: Binding, plan: Plan, from: PageWorld | null): void {
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
    binding.placed = plan.place;
    binding.node!.name = binding.name;
    if (plan.targets) this.#setTargets(binding, plan.targets);
    this.#tell(binding);
  }

  /** Its node was made, changed its place, or went. */
  #tell(binding: Binding): void {
    this.#scene.events.update(binding);
    this.#scene.routes.update(binding);
  }

  #create(binding: Binding, plan: Plan): void {
    const relations = { ...plan.relations };
    if (plan.shapes) {
      binding.shortcutNode = plan.world.add(
        'CollidableShape',
        { shape: plan.shapes },
        { host: binding.element },
      );
      relations.geometry = [binding.shortcutNode];
    }
    const options = {
      host: binding.element,
      name: binding.name,
      collection: plan.collection,
      version: binding.scope?.version,
      start: plan.start,
    };
    const fields = { ...binding.authoredFields(), ...relations };
    binding.node = plan.world.add(binding.type.name, fields, options as never);
    binding.relations = plan.relations;
    binding.shapes = plan.shapes;
    // A body that came into another world brings its collidables along.
    if (binding.is('RigidBody')) for (const other of binding.uses) this.#scene.dirty(other);
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
    const before = binding.placed;
    // A body moved in the tree comes under another Transform, too, but keeps its pose.
    const byName = name !== null || before?.name != null;
    if (!start || !transform || !byName || transform === before?.transform) return;
    if (!binding.wrote('position', 'orientation')) this.#scene.updates.jump(binding, start);
  }

  #patchShapes(binding: Binding, node: PhysicsNode, plan: Plan): void {
    if (sameRelation(binding.shapes, plan.shapes)) return;
    const before = binding.shortcutNode;
    if (!plan.shapes) {
      binding.shortcutNode = null;
      node.set('geometry', plan.relations.geometry);
      before?.remove();
    } else if (before) before.set('shape', plan.shapes);
    else {
      binding.shortcutNode = plan.world.add(
        'CollidableShape',
        { shape: plan.shapes },
        { host: binding.element },
      );
      node.set('geometry', [binding.shortcutNode]);
    }
    binding.shapes = plan.shapes;
  }

  #setTargets(binding: Binding, targets: Target[]): void {
    const above = targets.flatMap(({ element, scope }) => transformsAbove(element, scope));
    this.#scene.drawing.setTargets(binding, targets, above);
    this.#scene.updates.redraw(binding);
  }

  remove(binding: Binding): void {
    binding.node?.remove();
    binding.shortcutNode?.remove();
    binding.node = null;
    binding.shortcutNode = null;
    binding.relations = {};
    binding.shapes = undefined;
    this.#scene.drawing.forget(binding);
    this.#tell(binding);
  }
}

function sameRelation(a: unknown, b: unknown): boolean {
  if (Array.isArray(a) && Array.isArray(b))
    return a.length === b.length && a.every((item, i) => sameRelation(item, b[i]));
  return a === b || (isData(a) && isData(b) && JSON.stringify(a) === JSON.stringify(b));
}

const isData = (value: unknown): boolean =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;
