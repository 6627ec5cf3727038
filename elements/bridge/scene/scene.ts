import { Batching } from '../batch/batching.js';
import { Drivers } from '../document/drivers.js';
import { worldFor } from '../document/world-for.js';
import { Unlisted } from '../document/unlisted.js';
import { Drawing } from '../drawing/drawing.js';
import { loop, type Driven } from '../drawing/loop.js';
import { placeAsWritten } from '../drawing/place.js';
import { Routes } from '../drawing/routes.js';
import type { Binding } from '../nodes/binding.js';
import { bindingsIn } from '../nodes/bindings.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { Debug } from '../outward/debug/debug.js';
import { Draggables } from '../outward/dragging/draggables.js';
import { Events } from '../outward/events.js';
import { Reports } from '../outward/reports.js';
import type { Stage } from '../outward/stage.js';
import type { Site } from '../plans/site.js';
import { Updates } from '../plans/updates.js';
import { Readers } from '../scopes/readers.js';
import type { Scope } from '../scopes/scope.js';
import { Scopes } from '../scopes/scopes.js';
import { isPhysics, isScene, subtree } from '../words/dom.js';
import { millisecondsOfPicture } from '../x3dom/picture-cost.js';
import { documentOf, nodeOf, type PhysicsX3DNode, type X3DDocument } from '../x3dom/x3dom.js';
import { Arrivals } from './arrivals.js';
import type { SceneWorld } from './scene-world.js';
import { Strangers } from './strangers.js';
import { Tree } from './tree.js';
import { Unread } from './unread.js';
import { Worlds } from './worlds.js';

/** The physics of one `<x3d>`: its scopes, its worlds, and the nodes that wait to be brought up to date. */
export class Scene implements Driven, Site, Stage {
  readonly x3d: Element;
  readonly scopes: Scopes;
  readonly worlds: Worlds;
  readonly readers = new Readers();
  readonly drivers = new Drivers(this.readers);
  readonly unlisted = new Unlisted();
  readonly batching = new Batching(this);
  readonly drawing = new Drawing(
    () => this.requestRender(),
    (...shown) => this.batching.note(...shown),
  );
  readonly routes = new Routes();
  readonly updates: Updates = new Updates(this);
  readonly arrivals: Arrivals = new Arrivals(this);
  readonly events: Events = new Events(this);
  readonly draggables: Draggables = new Draggables(this);
  readonly debug = new Debug(this);
  readonly tree: Tree;
  readonly strangers: Strangers;
  readonly unread: Unread = new Unread(this);
  readonly reports: Reports;
  live = false;
  /** Once, not in each frame. */
  readonly #picture = (): number => millisecondsOfPicture(this.x3d);
  #readBy: X3DDocument | undefined;
  /** Scrolled away or not shown: worlds pause. */
  inView = true;
  readonly #view: IntersectionObserver;

  constructor(x3d: Element) {
    this.x3d = x3d;
    this.scopes = new Scopes(x3d);
    this.worlds = new Worlds(this.scopes);
    this.reports = new Reports(this.worlds, () => this.updates.schedule());
    this.strangers = new Strangers(this.worlds);
    this.tree = new Tree(this);
    const listeners = [this.debug, this.events, this.draggables];
    this.worlds.onmake((world) => {
      world.onflush = () => this.drain();
      for (const each of listeners) each.listen(world);
    });
    this.#view = new IntersectionObserver((entries) =>
      this.#viewed(entries.at(-1)!.isIntersecting),
    );
    this.#view.observe(x3d);
    loop.add(this);
  }

  #viewed(inView: boolean): void {
    this.inView = inView;
    if (!inView) return;
    this.requestRender();
    loop.wake();
  }

  // ---- what stands in it ------------------------------------------------------------------------------------------

  get root(): Element | undefined {
    return [...this.x3d.children].find(isScene);
  }

  /** The page's own scope, read on first demand. */
  readPage(): Scope | undefined {
    const { root } = this;
    return root && (this.scopes.under(root) ?? this.tree.addScope(root, null, null));
  }

  /** All nodes of all scopes. */
  *bindings(): Generator<Binding> {
    for (const scope of this.scopes) yield* bindingsIn(scope);
  }

  /** For an Inline: the world of its first collection, else of its first physics element. */
  worldIn(host: Element): PageWorld | undefined {
    const scope = this.scopes.in(host);
    const bindings = scope ? [...bindingsIn(scope)] : [];
    const collection = bindings.find((binding) => binding.is('RigidBodyCollection'));
    return firstOf(collection ? [collection] : bindings);
  }

  /** For elements that belong to no node: the world of the first physics element. */
  firstWorld(): PageWorld | undefined {
    return firstOf(this.bindings());
  }

  // ---- upkeep -------------------------------------------------------------------------------------------------

  dirty(binding: Binding): void {
    this.updates.add(binding);
  }

  drop(binding: Binding): void {
    this.updates.drop(binding);
  }

  takeRecords(): void {
    this.tree.takeRecords();
  }

  /** Everything seen so far, brought to the core. What that brings about is told when all of it is there. */
  drain(): void {
    this.takeRecords();
    if (this.updates.pending) this.#asWhole(() => this.updates.run());
    else this.updates.run();
  }

  #asWhole(work: () => void): void {
    const worlds = [...this.worlds.all];
    for (const { events } of worlds) events.delay();
    try {
      work();
    } finally {
      for (const { events } of worlds) events.proceed();
    }
  }

  /** The same, when no step runs: worlds may end. */
  settle(): void {
    this.drain();
    this.worlds.endDeserted();
  }

  nodeChanged(binding: Binding): void {
    this.events.update(binding);
    this.routes.update(binding);
    this.batching.drawer?.nodeChanged(binding);
    binding.onnode?.();
  }

  collectionsChanged(world: PageWorld): void {
    this.events.updateWorld(world);
  }

  updated(): void {
    this.reports.tellUnheard();
    this.strangers.tellSoon();
  }

  /** Of an element that is no node of ours. */
  noteFault(...fault: Parameters<Strangers['note']>): void {
    this.strangers.note(...fault);
    this.updates.schedule();
  }

  /** The document is read: nodes are made, and later changes are followed. */
  goLive(): void {
    if (this.live) return;
    this.readPage();
    this.live = true;
    this.#readBy = this.document;
    this.settle();
  }

  destroy(): void {
    this.live = false;
    for (const scope of [...this.scopes]) this.tree.removeScope(scope);
    this.#asWhole(() => {
      this.updates.dropAll();
      this.worlds.destroy();
    });
    this.draggables.destroy();
    this.#view.disconnect();
    loop.delete(this);
  }

  // ---- x3dom ------------------------------------------------------------------------------------------------------

  get document(): X3DDocument | undefined {
    return documentOf(this.x3d);
  }

  /** x3dom came late, or reads it anew: what it has of its own is taken in, and drawn where the bodies are. */
  readByX3DOM(): void {
    if (!this.live || this.document === this.#readBy) return;
    this.#readBy = this.document;
    for (const scope of this.scopes) {
      this.tree.requeue(scope);
      for (const element of subtree(scope.root)) this.unread.add(element);
    }
    for (const binding of this.bindings()) this.updates.redraw(binding);
  }

  /** A collidable that no body moves is drawn where its fields say. */
  placeChanged(collidable: Binding): void {
    if (this.drawing.bodyMoving(collidable.element)) return;
    placeAsWritten(collidable, nodeOf(collidable.element));
    this.requestRender();
  }

  /** Somebody began or ceased to listen; x3dom's own event tells of the outputs of one node. */
  listenersChanged(target: EventTarget, name: string): void {
    if (name !== 'outputchange') return this.events.listenersChanged(target, name);
    const node = target instanceof Element && isPhysics(target) ? nodeOf(target) : undefined;
    if (node && this.scopes.around(target as Element)) this.routed(node as PhysicsX3DNode);
  }

  routed(node: PhysicsX3DNode): void {
    this.routes.add(node);
    for (const world of this.worlds.all) world.work();
  }

  /** What nobody sees is drawn when it comes into view. */
  requestRender(): void {
    const { document } = this;
    if (document && this.inView) document.needRender = true;
  }

  // ---- frames -----------------------------------------------------------------------------------------------------

  frame(seconds: number, hidden: boolean): boolean {
    let again = false;
    if (this.live) this.worlds.endDeserted();
    const seen = this.inView && !hidden;
    for (const world of this.worlds.all) {
      if (!world.started || world.atRest || !(seen || world.runsHidden)) {
        world.stand();
        continue;
      }
      if (world.pass(seconds, hidden)) again = true;
      this.#show(world);
    }
    return again;
  }

  #show(world: SceneWorld): void {
    const start = performance.now();
    this.drawing.drawMoved(world);
    this.routes.send(world);
    this.debug.draw(world);
    world.onshow?.();
    world.stepping.frameOver(start, this.#picture);
  }
}

function firstOf(bindings: Iterable<Binding>): PageWorld | undefined {
  for (const binding of bindings) {
    const world = worldFor(binding);
    if (world) return world;
  }
  return undefined;
}
