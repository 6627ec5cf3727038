import { ownBinding, type Binding } from '../nodes/binding.js';
import { drawnPose, moveTo } from './body-state.js';
import { attribute, isInline, isPhysics, isTransform } from '../words/dom.js';
import { checkMarkup } from '../document/markup.js';
import { inOrder } from '../document/order.js';
import type { Plan, StartPose } from './plan.js';
import { planFor } from './plans.js';
import type { Scene } from '../scene/scene.js';
import type { Scope } from '../scopes/scope.js';
import { listsAll, worldFor } from '../document/structure.js';
import { noteNamed } from '../nodes/named.js';
import { mayMove } from '../document/rivals.js';
import { Writer } from './writer.js';
import type { PhysicsX3DNode } from '../scene/node-types.js';
import { nodeOf } from '../x3dom/x3dom.js';

/** More rounds than any chain of nodes that name each other needs. */
const ROUNDS = 50;

/** Brings the core's nodes up to date with the document: only those that something near them touched. */
export class Updates {
  readonly #scene: Scene;
  readonly #writer: Writer;
  #queue = new Set<Binding>();
  readonly #left = new Set<Binding>();
  #arrived: { element: Element; scope: Scope }[] = [];
  /** Transforms that were written to, and whether anything else than before. */
  readonly #edited = new Map<Element, boolean>();
  readonly #redraw = new Set<Binding>();
  /** Bodies that follow an edit: their Transforms are there already, their drawn poses come with the next frame. */
  readonly #jumped = new Set<Binding>();
  #scheduled = false;
  #running = false;

  constructor(scene: Scene) {
    this.#scene = scene;
    this.#writer = new Writer(scene);
  }

  add(binding: Binding): void {
    this.#queue.add(binding);
    this.schedule();
  }

  arrived(element: Element, scope: Scope): void {
    this.#arrived.push({ element, scope });
    this.schedule();
  }

  left(binding: Binding | undefined, from: Element | undefined): void {
    if (!binding) return;
    binding.leftFrom = from;
    this.#left.add(binding);
    this.schedule();
  }

  /** `again`: with what it said already. */
  transformEdited(element: Element, again: boolean): void {
    this.#edited.set(element, !again || (this.#edited.get(element) ?? false));
    this.schedule();
  }

  redraw(binding: Binding): void {
    this.#redraw.add(binding);
    this.schedule();
  }

  /** A microtask later x3dom has seen the same changes: its observer runs after ours. */
  schedule(): void {
    if (this.#scheduled || !this.#scene.live) return;
    this.#scheduled = true;
    queueMicrotask(() => {
      this.#scheduled = false;
      this.#scene.settle();
    });
  }

  /** Whether the core has yet to hear of anything. */
  get pending(): boolean {
    const { size } = this.#queue;
    return size + this.#left.size + this.#edited.size + this.#arrived.length > 0;
  }

  run(): void {
    if (this.#running || !this.#scene.live) return;
    this.#running = true;
    try {
      this.#takeArrived();
      this.#takeLeft();
      this.#takeEdited();
      for (let round = 0; this.#isLeft() && round < ROUNDS; round++) this.#round();
      for (const binding of this.#redraw)
        if (!this.#jumped.has(binding)) this.#scene.drawing.redraw(binding);
      this.#redraw.clear();
      this.#jumped.clear();
    } finally {
      this.#running = false;
    }
    this.#scene.reports.tellUnheard();
  }

  // ---- what happened in the document ----------------------------------------------------------------------------

  #takeArrived(): void {
    const arrived = this.#arrived;
    this.#arrived = [];
    for (const { element, scope } of arrived) {
      const body = nodeOf(element)?.protoBodyClone;
      if (body) this.#scene.addPrototype(element, body);
      if (isInline(element)) this.#scene.addInline(element);
      const moving = this.#scene.drawing.bodyMoving(element);
      if (moving) this.#redraw.add(moving);
      this.#reviveUses(element, scope);
      if (isPhysics(element)) this.#reviveRoutes(element, scope);
      if (scope.isPrototype) this.#listenIn(element);
      // Only now the units of its file are known. What stands for another by USE has that one's x3dom node.
      const binding =
        isPhysics(element) && !attribute(element, 'USE') ? ownBinding(element) : undefined;
      if (binding) this.#scene.valueChanged(binding);
    }
  }

  /** x3dom drops a USE that stands before its DEF. */
  #reviveUses(element: Element, scope: Scope): void {
    const { document } = this.#scene;
    if (!document || !nodeOf(element)) return;
    for (const use of scope.names.usesOf(element)) {
      const parent = use.parentElement;
      if (!nodeOf(use) && parent && nodeOf(parent)) document.onNodeAdded(use, parent);
    }
  }

  /** An element that moved has a new node in x3dom, which knows nothing of its ROUTEs. */
  #reviveRoutes(element: Element, scope: Scope): void {
    const name = attribute(element, 'DEF') ?? attribute(element, 'id');
    const node = nodeOf(element);
    if (!name || !node) return;
    for (const route of scope.routesFrom(name)) {
      const target = scope.names.find(attribute(route, 'toNode') ?? '');
      const to = target && nodeOf(target);
      const [field, toField] = [attribute(route, 'fromField'), attribute(route, 'toField')];
      if (to && field && toField) node.setupRoute(field, to, toField);
    }
  }

  /** What a prototype's fields are is ROUTEd at its instance, which knows nothing of us. */
  #listenIn(element: Element): void {
    const node = isPhysics(element) ? nodeOf(element) : undefined;
    if (node) this.#scene.routed(node as PhysicsX3DNode);
  }

  /** What is in the document again was moved: its node stays. */
  #takeLeft(): void {
    for (const binding of this.#left) {
      if (this.#scene.scopeOf(binding.element) === binding.scope && binding.scope)
        this.#queue.add(binding);
      else this.drop(binding);
      binding.leftFrom = undefined;
    }
    this.#left.clear();
  }

  #takeEdited(): void {
    const { drawing, readers } = this.#scene;
    for (const [element, isNew] of this.#edited) {
      const own = drawing.bodyMoving(element);
      for (const binding of new Set([...(own ? [own] : []), ...drawing.bodiesUnder(element)])) {
        if (!isNew || !this.#follow(binding, element)) this.#redraw.add(binding);
      }
      for (const reader of readers.of(element)) this.#queue.add(reader);
    }
    this.#edited.clear();
  }

  /** A body goes where the author put the Transform that it moves, or one above. */
  #follow(binding: Binding, edited: Element): boolean {
    const targets = this.#scene.drawing
      .targetsOf(binding)
      .filter(({ element }) => isTransform(element));
    const target = targets.find(({ element }) => element === edited) ?? targets[0];
    if (!target || !binding.node) return false;
    this.jump(binding, drawnPose(target));
    this.#queue.add(binding);
    return true;
  }

  /** Puts a body where its Transform is. */
  jump(binding: Binding, pose: StartPose): void {
    moveTo(binding.node!, pose);
    this.#jumped.add(binding);
  }

  // ---- nodes --------------------------------------------------------------------------------------------------

  /** Whether nodes wait; worlds that came or went make some. */
  #isLeft(): boolean {
    this.#scene.worlds.checkOnly();
    return this.#queue.size > 0;
  }

  #round(): void {
    const batch = inOrder(
      [...this.#queue].filter((binding) => binding.scope?.scene === this.#scene),
    );
    this.#queue = new Set();
    for (const binding of batch) {
      binding.beginPlan();
      if (binding.is('RigidBody', 'CollidableShape'))
        binding.plan(() => this.#scene.drivers.update(binding));
    }
    for (const binding of batch) if (binding.scope) this.#update(binding);
  }

  #update(binding: Binding): void {
    const { node, world } = binding;
    const plan = binding.plan(() => this.#plan(binding));
    if (plan) this.#writer.apply(binding, plan, world);
    else this.#writer.remove(binding);
    binding.tellFound();
    if (binding.node !== node || binding.is('CollidableShape', 'CollidableOffset'))
      this.#tellUsers(binding);
    this.#scene.unlisted.note(binding, listsAll(binding) ? binding.world : null);
    if (world === binding.world) return;
    if (world) this.#tellUsed(binding);
    if (binding.is('RigidBodyCollection')) this.#movedWorld(binding, world);
  }

  #plan(binding: Binding): Plan | undefined {
    const world = worldFor(binding);
    binding.world = world ?? null;
    checkMarkup(binding);
    // Without what it stands for, nobody knows where it is to start.
    if (binding.is('RigidBody') && binding.waiting.has('for')) return undefined;
    if (!mayMove(binding)) return undefined;
    return world && planFor(binding, world);
  }

  #tellUsers(binding: Binding): void {
    for (const user of binding.users) this.#queue.add(user);
  }

  /** It is in another world: what it lists may live where it does. */
  #tellUsed(binding: Binding): void {
    for (const used of binding.uses) this.#queue.add(used);
  }

  /** What lives in a collection goes with it. */
  #movedWorld(collection: Binding, from: Binding['world']): void {
    from?.collections.delete(collection);
    collection.world?.collections.add(collection);
    for (const world of [from, collection.world]) if (world) this.#scene.events.updateWorld(world);
    if (from) for (const scope of this.#scene.scopes) this.#scene.requeue(scope);
  }

  /** An element left the `<x3d>`. */
  drop(binding: Binding): void {
    this.#queue.delete(binding);
    this.#tellUsers(binding);
    this.#writer.remove(binding);
    this.#scene.drivers.stop(binding);
    this.#scene.unlisted.forget(binding);
    this.#scene.worlds.forget(binding);
    binding.beginPlan();
    binding.tellFound();
    this.#scene.reports.settle(binding);
    const { world } = binding;
    if (world?.collections.delete(binding)) this.#scene.events.updateWorld(world);
    noteNamed(binding, binding.allNamed, []);
    binding.scope = null;
    binding.world = null;
  }

  dropAll(): void {
    for (const binding of this.#left) this.drop(binding);
    this.#left.clear();
    this.#queue.clear();
    this.#arrived = [];
  }
}
