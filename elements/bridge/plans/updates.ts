import { worldFor } from '../document/world-for.js';
import { checkMarkup } from '../document/markup.js';
import { inOrder } from '../document/order.js';
import { mayMove } from '../document/rivals.js';
import { listsAll } from '../document/structure.js';
import { Unused } from '../document/unused.js';
import type { Binding } from '../nodes/binding.js';
import { bindingsIn } from '../nodes/bindings.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { Following } from './following.js';
import type { Plan } from './plan.js';
import { planFor } from './plans.js';
import type { Site } from './site.js';
import { Writer } from './writer.js';

/** More rounds than any chain of nodes that name each other needs. */
const ROUNDS = 50;

/** Brings the core's nodes up to date with the document: only those that something near them touched. */
export class Updates {
  readonly #site: Site;
  readonly #following: Following;
  readonly #writer: Writer;
  readonly #unused = new Unused();
  #queue = new Set<Binding>();
  readonly #left = new Set<Binding>();
  /** Something happened since the last run. */
  #due = true;
  #scheduled = false;
  #running = false;

  constructor(site: Site) {
    this.#site = site;
    this.#following = new Following(site.drawing, site.readers);
    this.#writer = new Writer(site.drawing, this.#following, (binding) =>
      site.nodeChanged(binding),
    );
  }

  add(binding: Binding): void {
    this.#queue.add(binding);
    this.schedule();
  }

  /** `from`: what it was taken out of. */
  left(binding: Binding, from: Element | undefined): void {
    binding.leftFrom = from;
    this.#left.add(binding);
    this.schedule();
  }

  /** `again`: with what it said already. */
  transformEdited(element: Element, again: boolean): void {
    this.#following.edited(element, again);
    this.schedule();
  }

  redraw(binding: Binding): void {
    this.#following.redraw(binding);
    this.schedule();
  }

  /** A microtask later x3dom has seen the same changes: its observer runs after ours. */
  schedule(): void {
    this.#due = true;
    if (this.#scheduled || !this.#site.live) return;
    this.#scheduled = true;
    queueMicrotask(() => {
      this.#scheduled = false;
      this.#site.settle();
    });
  }

  /** Whether the core has yet to hear of anything. */
  get pending(): boolean {
    const { arrivals } = this.#site;
    return this.#queue.size + this.#left.size + this.#following.size + arrivals.size > 0;
  }

  /** Asked before each step: most often there is nothing. */
  run(): void {
    if (this.#running || !this.#site.live || !(this.#due || this.pending)) return;
    this.#running = true;
    this.#due = false;
    try {
      this.#site.arrivals.take();
      this.#takeLeft();
      this.#following.followEdits();
      for (let round = 0; this.#isLeft() && round < ROUNDS; round++) this.#round();
      this.#following.draw();
    } finally {
      this.#running = false;
    }
    this.#site.updated();
  }

  /** What is in the document again was moved: its node stays. */
  #takeLeft(): void {
    for (const binding of holdersFirst(this.#left)) {
      const scope = this.#site.scopes.around(binding.element);
      if (scope && scope === binding.scope) this.#queue.add(binding);
      else this.drop(binding);
      binding.leftFrom = undefined;
    }
    this.#left.clear();
  }

  /** Whether nodes wait; worlds that came or went make some. */
  #isLeft(): boolean {
    this.#site.worlds.checkOnly();
    return this.#queue.size > 0;
  }

  #round(): void {
    const batch = inOrder([...this.#queue].filter(({ scene }) => scene === this.#site));
    this.#queue = new Set();
    for (const binding of batch) {
      binding.beginPlan();
      if (binding.is('RigidBody', 'CollidableShape'))
        binding.plan(() => this.#site.drivers.update(binding));
    }
    for (const binding of batch) if (binding.scope) this.#update(binding);
  }

  // ---- one node -------------------------------------------------------------------------------------------------

  #update(binding: Binding): void {
    const { node, world } = binding;
    const plan = binding.plan(() => this.#plan(binding));
    if (plan) this.#writer.apply(binding, plan, world);
    else this.#writer.remove(binding);
    binding.tellFound();
    if (binding.node !== node || binding.isCollidable) this.#tellUsers(binding);
    this.#site.unlisted.note(binding, listsAll(binding) ? binding.world : null);
    if (world === binding.world) return;
    if (world) this.#tellUsed(binding);
    if (binding.is('RigidBodyCollection')) this.#movedWorld(binding, world);
  }

  #plan(binding: Binding): Plan | undefined {
    const world = worldFor(binding);
    binding.world = world ?? null;
    this.#unused.note(binding);
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
  #movedWorld(collection: Binding, from: PageWorld | null): void {
    from?.collections.delete(collection);
    collection.world?.collections.add(collection);
    for (const world of [from, collection.world]) if (world) this.#site.collectionsChanged(world);
    if (!from) return;
    for (const scope of this.#site.scopes)
      for (const binding of bindingsIn(scope)) this.#queue.add(binding);
  }

  /** An element left the `<x3d>`. */
  drop(binding: Binding): void {
    this.#queue.delete(binding);
    this.#tellUsers(binding);
    this.#writer.remove(binding);
    this.#site.drivers.stop(binding);
    this.#site.unlisted.forget(binding);
    this.#site.worlds.forget(binding);
    binding.beginPlan();
    binding.tellFound();
    this.#site.reports.settle(binding);
    const { world } = binding;
    if (world?.collections.delete(binding)) this.#site.collectionsChanged(world);
    binding.leave();
  }

  dropAll(): void {
    for (const binding of holdersFirst(this.#left)) this.drop(binding);
    this.#left.clear();
    this.#queue.clear();
    this.#site.arrivals.clear();
  }
}

/** What goes together goes from the outside in: nobody is told that it lacks what only went before it. */
const holdersFirst = (bindings: Iterable<Binding>): Binding[] =>
  [...bindings].sort((a, b) => b.type.rank - a.type.rank);
