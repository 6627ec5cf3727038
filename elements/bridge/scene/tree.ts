import { Observed, type Elements } from '../document/observed.js';
import { ownBinding } from '../nodes/binding.js';
import { bindingsIn } from '../nodes/bindings.js';
import type { Surroundings } from '../nodes/surroundings.js';
import type { Updates } from '../plans/updates.js';
import type { Scope } from '../scopes/scope.js';
import type { Scopes } from '../scopes/scopes.js';
import { takesPart } from '../scopes/standing.js';
import { attribute, isPhysics, subtree } from '../words/dom.js';
import { nodeOf } from '../x3dom/x3dom.js';

/** The scene whose elements they are. */
interface Scene extends Surroundings {
  readonly scopes: Scopes;
  readonly updates: Updates;
  readonly strangers: { add(element: Element): void; delete(element: Element): void };
  readonly unread: { add(element: Element): void };
  readonly arrivals: { add(element: Element, scope: Scope): void };
}

/** The elements of a scene as they come and go, and the scopes that they stand in. */
export class Tree implements Elements {
  readonly #scene: Scene;
  readonly #scopes: Scopes;
  readonly #observed: Observed;

  constructor(scene: Scene) {
    this.#scene = scene;
    this.#scopes = scene.scopes;
    this.#observed = new Observed(this, scene.readers);
  }

  /** What happened to the document so far in this task is seen now. */
  takeRecords(): void {
    this.#observed.takeRecords();
  }

  // ---- scopes -----------------------------------------------------------------------------------------------------

  addScope(root: Element, host: Element | null, parent: Scope | null): Scope {
    const scope = this.#scopes.add(root, host, parent);
    scope.names.onchange = (name, watchers) => {
      for (const watcher of watchers) watcher.dirty();
      const bearer = scope.find(name);
      if (bearer) this.#usedOtherwise(bearer);
    };
    this.connect(root, scope);
    this.#observed.observe(scope);
    scope.touchImports();
    return scope;
  }

  /** A USE of it came or went: what is merely kept where it stands takes part now, or no more. */
  #usedOtherwise(bearer: Element): void {
    if (isPhysics(bearer)) ownBinding(bearer)?.dirty();
    if (!this.#scene.live || takesPart(bearer, this.#scopes)) return;
    for (const element of subtree(bearer)) if (isPhysics(element)) ownBinding(element)?.dirty();
  }

  /** `from`: what its host was taken out of. */
  removeScope(scope: Scope, from?: Element): void {
    this.#scopes.delete(scope);
    this.#observed.stop(scope);
    this.disconnect(scope.root, scope, from);
    this.#scene.updates.schedule();
  }

  /** An Inline's file stands in the scene: what was there before from the same Inline has gone. */
  addInline(inline: Element): void {
    const root = nodeOf(inline)?._childNodes[0]?._xmlNode;
    const parent = this.#scopes.around(inline);
    if (!root || !parent || this.#scopes.under(root)) return;
    const old = this.#scopes.in(inline);
    if (old) this.removeScope(old);
    this.addScope(root, inline, parent);
  }

  addPrototype(instance: Element, body: Element): void {
    const parent = this.#scopes.around(instance);
    if (!parent || this.#scopes.under(body)) return;
    this.addScope(body, instance, parent);
    const holder = instance.parentElement;
    if (holder && isPhysics(holder)) ownBinding(holder)?.dirty();
  }

  // ---- elements ---------------------------------------------------------------------------------------------------

  connect(root: Element, scope: Scope): void {
    for (const element of subtree(root)) this.#connect(element, scope);
  }

  #connect(element: Element, scope: Scope): void {
    if (!scope.names.has(element)) scope.names.add(element);
    scope.noteStatement(element, true);
    this.#scene.arrivals.add(element, scope);
    this.#scene.strangers.add(element);
    this.#scene.unread.add(element);
    if (!isPhysics(element) || attribute(element, 'USE')) return;
    const binding = ownBinding(element);
    if (!binding || binding.scope === scope) return;
    binding.scene?.drop(binding);
    binding.enter(scope, this.#scene);
    binding.dirty();
  }

  disconnect(root: Element, scope: Scope, from?: Element): void {
    for (const element of subtree(root)) this.#disconnect(element, scope, from);
  }

  #disconnect(element: Element, scope: Scope, from?: Element): void {
    scope.names.remove(element);
    scope.noteStatement(element, false);
    this.#scene.strangers.delete(element);
    const inner = this.#scopes.in(element);
    if (inner) this.removeScope(inner, from);
    const binding = isPhysics(element) ? ownBinding(element) : undefined;
    if (binding) this.#scene.updates.left(binding, from);
  }

  renamed(element: Element, scope: Scope): void {
    scope.names.remove(element);
    scope.noteStatement(element, false);
    const binding = isPhysics(element) ? ownBinding(element) : undefined;
    if (binding?.scope && attribute(element, 'USE')) this.#scene.drop(binding);
    this.#connect(element, scope);
  }

  // ---- all of a file ------------------------------------------------------------------------------------------------

  /** All nodes of a scope: what they live in changed. */
  requeue(scope: Scope): void {
    for (const binding of bindingsIn(scope)) binding.dirty();
  }

  /** The nodes of an Inline and of those in it. */
  requeueInline(inline: Element): void {
    const scope = this.#scopes.in(inline);
    if (!scope) return;
    this.requeue(scope);
    for (const { host, parent } of this.#scopes)
      if (host && parent === scope) this.requeueInline(host);
  }
}
