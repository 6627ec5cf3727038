import { type Binding, ownBinding } from '../nodes/binding.js';
import { bindingsIn } from '../nodes/bindings.js';
import { attribute, isPhysics, isScene, subtree } from '../words/dom.js';
import { Debug } from '../outward/debug/debug.js';
import { Draggables } from '../outward/dragging/draggables.js';
import { Drawing } from '../drawing/drawing.js';
import { Drivers } from '../document/drivers.js';
import { Events } from '../outward/events.js';
import { loop, type Driven } from '../drawing/loop.js';
import { Readers } from '../document/readers.js';
import { Reports } from '../outward/reports.js';
import { Routes } from '../drawing/routes.js';
import { Scope } from '../scopes/scope.js';
import { placeAsWritten } from '../drawing/place.js';
import { Observed } from '../document/observed.js';
import { isCollidable, worldFor } from '../document/structure.js';
import { noteNamed } from '../nodes/named.js';
import { Unlisted } from '../document/unlisted.js';
import { Updates } from '../plans/updates.js';
import { Worlds, type PageWorld } from './worlds.js';
import type { PhysicsX3DNode } from './node-types.js';
import { documentOf, nodeOf, type X3DDocument } from '../x3dom/x3dom.js';

/** The physics of one `<x3d>`: its scopes, its worlds, and the nodes that wait to be brought up to date. */
export class Scene implements Driven {
  readonly x3d: Element;
  readonly loop = loop;
  readonly worlds = new Worlds(this);
  readonly drawing = new Drawing();
  readonly debug = new Debug(this);
  readonly routes = new Routes();
  readonly readers = new Readers();
  readonly events = new Events(this);
  readonly draggables = new Draggables(this);
  readonly unlisted = new Unlisted();
  readonly updates = new Updates(this);
  readonly observed = new Observed(this);
  readonly drivers = new Drivers(this);
  readonly reports = new Reports(this);
  /** Scopes by the element they stand under. */
  readonly #scopes = new Map<Element, Scope>();
  /** Whether its nodes stand in the core; before that the document is still being read. */
  live = false;
  #readBy: X3DDocument | undefined;
  /** Scrolled away or not shown: worlds pause. */
  inView = true;
  #view: IntersectionObserver | undefined;

  constructor(x3d: Element) {
    this.x3d = x3d;
    const listeners = [this.events, this.draggables];
    this.worlds.onmake = (world) => listeners.forEach((each) => each.listen(world));
    this.#view = new IntersectionObserver((entries) =>
      this.#viewed(entries.at(-1)!.isIntersecting),
    );
    this.#view.observe(x3d);
    loop.add(this);
  }

  #viewed(inView: boolean): void {
    this.inView = inView;
    if (inView) loop.turn();
  }

  // ---- scopes -------------------------------------------------------------------------------------------------

  get root(): Element | undefined {
    return [...this.x3d.children].find(isScene);
  }

  get scopes(): Iterable<Scope> {
    return this.#scopes.values();
  }

  /** The page's own scope, read on first demand. */
  readPage(): Scope | undefined {
    const { root } = this;
    return root && (this.#scopes.get(root) ?? this.addScope(root, null, null));
  }

  addScope(root: Element, host: Element | null, parent: Scope | null): Scope {
    const scope = new Scope(this, root, host, parent);
    this.#scopes.set(root, scope);
    scope.names.onchange = (name, watchers) => {
      for (const watcher of watchers) this.dirty(watcher);
      const bearer = scope.names.find(name);
      const binding = bearer && isPhysics(bearer) ? ownBinding(bearer) : undefined;
      if (binding?.scope) this.dirty(binding);
    };
    this.connectAll(root, scope);
    this.observed.observe(scope);
    scope.touchImports();
    return scope;
  }

  /** `from`: what its host was taken out of. */
  removeScope(scope: Scope, from?: Element): void {
    this.#scopes.delete(scope.root);
    scope.observer?.disconnect();
    for (const element of subtree(scope.root)) this.disconnect(element, scope, from);
    this.updates.schedule();
  }

  scopeOf(element: Element): Scope | undefined {
    for (let at: Element | null = element; at; at = at.parentElement) {
      const scope = this.#scopes.get(at);
      if (scope) return scope;
    }
    return undefined;
  }

  /** The element that an element means: itself, or what it stands for by USE. */
  meant(element: Element): Element | undefined {
    const use = attribute(element, 'USE');
    return use ? this.scopeOf(element)?.find(use) : element;
  }

  /** The scope that an Inline or a prototype's instance stands for. */
  scopeIn(host: Element): Scope | undefined {
    for (const scope of this.#scopes.values()) if (scope.host === host) return scope;
    return undefined;
  }

  // ---- elements that come and go --------------------------------------------------------------------------------

  connectAll(root: Element, scope: Scope): void {
    for (const element of subtree(root)) this.connect(element, scope);
  }

  connect(element: Element, scope: Scope): void {
    if (!scope.names.has(element)) scope.names.add(element);
    scope.noteStatement(element, true);
    this.updates.arrived(element, scope);
    if (!isPhysics(element) || attribute(element, 'USE')) return;
    const binding = ownBinding(element);
    if (!binding || binding.scope === scope) return;
    binding.scope?.scene.updates.drop(binding);
    binding.scope = scope;
    noteNamed(binding, [], binding.allNamed);
    this.dirty(binding);
  }

  /** `from`: what it was taken out of, with whatever stood around it. */
  disconnect(element: Element, scope: Scope, from?: Element): void {
    scope.names.remove(element);
    scope.noteStatement(element, false);
    const inner = this.scopeIn(element);
    if (inner) this.removeScope(inner, from);
    if (isPhysics(element)) this.updates.left(ownBinding(element), from);
  }

  /** An Inline's file stands in the scene: what was there before from the same Inline has gone. */
  addInline(inline: Element): void {
    const root = nodeOf(inline)?._childNodes[0]?._xmlNode;
    const parent = this.scopeOf(inline);
    if (!root || !parent || this.#scopes.has(root)) return;
    const old = this.scopeIn(inline);
    if (old) this.removeScope(old);
    this.addScope(root, inline, parent);
  }

  addPrototype(instance: Element, body: Element): void {
    const parent = this.scopeOf(instance);
    if (!parent || this.#scopes.has(body)) return;
    this.addScope(body, instance, parent);
    const holder = instance.parentElement;
    const binding = holder && isPhysics(holder) ? ownBinding(holder) : undefined;
    if (binding?.scope) this.dirty(binding);
  }

  // ---- upkeep -------------------------------------------------------------------------------------------------

  dirty(binding: Binding): void {
    this.updates.add(binding);
  }

  /** All nodes of a scope: what they live in changed. */
  requeue(scope: Scope): void {
    for (const binding of bindingsIn(scope)) this.dirty(binding);
  }

  /** The nodes of an Inline and of those in it. */
  requeueInline(inline: Element): void {
    const scope = this.scopeIn(inline);
    if (!scope) return;
    this.requeue(scope);
    for (const { host, parent } of this.scopes)
      if (host && parent === scope) this.requeueInline(host);
  }

  /** All nodes of all scopes. */
  *bindings(): Generator<Binding> {
    for (const scope of this.scopes) yield* bindingsIn(scope);
  }

  /** Everything seen so far, brought to the core. What that brings about is told when all of it is there. */
  drain(): void {
    this.observed.takeRecords();
    if (this.updates.pending) this.#asWhole(() => this.updates.run());
    else this.updates.run();
  }

  #asWhole(work: () => void): void {
    const worlds = [...this.worlds.all];
    for (const { events } of worlds) events.hold();
    try {
      work();
    } finally {
      for (const { events } of worlds) events.release();
    }
  }

  /** The same, when no step runs: worlds may end. */
  settle(): void {
    this.drain();
    this.worlds.endDeserted();
  }

  /** The document is read: nodes are made, and later changes are followed. */
  goLive(): void {
    if (this.live) return;
    this.readPage();
    this.live = true;
    this.#readBy = this.document;
    this.settle();
  }

  /** x3dom came late, or reads it anew: what it has of its own is taken in, and drawn where the bodies are. */
  readByX3DOM(): void {
    if (!this.live || this.document === this.#readBy) return;
    this.#readBy = this.document;
    for (const scope of this.scopes) this.requeue(scope);
    for (const binding of this.bindings()) this.updates.redraw(binding);
  }

  destroy(): void {
    this.live = false;
    for (const scope of [...this.scopes]) this.removeScope(scope);
    this.#asWhole(() => {
      this.updates.dropAll();
      this.worlds.destroy();
    });
    this.draggables.destroy();
    this.#view?.disconnect();
    loop.delete(this);
  }

  // ---- worlds ---------------------------------------------------------------------------------------------------

  /** For an Inline: the world of its first collection, else of its first physics element. */
  worldIn(host: Element): PageWorld | undefined {
    const scope = this.scopeIn(host);
    const bindings = scope ? [...bindingsIn(scope)] : [];
    const collection = bindings.find((binding) => binding.is('RigidBodyCollection'));
    return firstOf(collection ? [collection] : bindings);
  }

  /** For elements that belong to no node: the world of the first physics element. */
  firstWorld(): PageWorld | undefined {
    for (const scope of this.scopes) {
      const world = firstOf(bindingsIn(scope));
      if (world) return world;
    }
    return undefined;
  }

  /** A collidable that no body moves is drawn where its fields say. */
  valueChanged(binding: Binding): void {
    if (!isCollidable(binding) || this.drawing.bodyMoving(binding.element)) return;
    placeAsWritten(binding, nodeOf(binding.element));
    this.requestRender();
  }

  /** Somebody began or ceased to listen; x3dom's own event tells of the outputs of one node. */
  listenersChanged(target: EventTarget, name: string): void {
    if (name !== 'outputchange') return this.events.listenersChanged(target, name);
    const node = target instanceof Element && isPhysics(target) ? nodeOf(target) : undefined;
    if (node && this.scopeOf(target as Element)) this.routed(node as PhysicsX3DNode);
  }

  routed(node: PhysicsX3DNode): void {
    this.routes.add(node);
    loop.wake();
  }

  get document(): X3DDocument | undefined {
    return documentOf(this.x3d);
  }

  requestRender(): void {
    const { document } = this;
    if (document) document.needRender = true;
  }

  frame(seconds: number, hidden: boolean): boolean {
    let again = false;
    if (this.live) this.worlds.endDeserted();
    for (const world of this.worlds.all) {
      if (!world.started || ((hidden || !this.inView) && !world.runsHidden)) continue;
      if (world.pass(seconds, hidden)) again = true;
      const start = performance.now();
      this.drawing.drawMoved(world);
      this.routes.send(world);
      this.debug.draw(world);
      world.frameOver(start);
    }
    return again;
  }
}

function firstOf(bindings: Iterable<Binding>): PageWorld | undefined {
  for (const binding of bindings) {
    const world = worldFor(binding);
    if (world) return world;
  }
  return undefined;
}
