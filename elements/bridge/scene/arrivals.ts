import type { Drawing } from '../drawing/drawing.js';
import { ownBinding } from '../nodes/binding.js';
import type { Surroundings } from '../nodes/surroundings.js';
import type { Updates } from '../plans/updates.js';
import type { Scope } from '../scopes/scope.js';
import { attribute, isInline, isPhysics, nameOf } from '../words/dom.js';
import { nodeOf, type PhysicsX3DNode, type X3DDocument } from '../x3dom/x3dom.js';
import { isRefused } from '../x3dom/uses.js';
import type { Tree } from './tree.js';

/** The scene in which they arrive. */
interface Scene extends Surroundings {
  /** What x3dom has of it. */
  readonly document: X3DDocument | undefined;
  readonly drawing: Drawing;
  readonly updates: Updates;
  readonly tree: Tree;
  routed(node: PhysicsX3DNode): void;
}

/** Elements that were inserted: what x3dom made of them is taken in, and what it leaves out is made good. */
export class Arrivals {
  readonly #scene: Scene;
  #all: { element: Element; scope: Scope }[] = [];

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  add(element: Element, scope: Scope): void {
    this.#all.push({ element, scope });
    this.#scene.updates.schedule();
  }

  get size(): number {
    return this.#all.length;
  }

  clear(): void {
    this.#all = [];
  }

  take(): void {
    const arrived = this.#all;
    this.clear();
    for (const { element, scope } of arrived) this.#take(element, scope);
  }

  #take(element: Element, scope: Scope): void {
    const body = nodeOf(element)?.protoBodyClone;
    if (body) this.#scene.tree.addPrototype(element, body);
    if (isInline(element)) this.#scene.tree.addInline(element);
    const moving = this.#scene.drawing.bodyMoving(element);
    if (moving) this.#scene.updates.redraw(moving);
    this.#reviveUses(element, scope);
    if (!isPhysics(element)) return;
    this.#reviveRoutes(element, scope);
    if (scope.isPrototype) this.#listenIn(element);
    // Only now the units of its file are known. What stands for another by USE has that one's x3dom node.
    const binding = attribute(element, 'USE') ? undefined : ownBinding(element);
    if (binding?.isCollidable) this.#scene.placeChanged(binding);
  }

  /** x3dom drops a USE that stands before its DEF. */
  #reviveUses(element: Element, scope: Scope): void {
    const { document } = this.#scene;
    if (!document || !nodeOf(element)) return;
    for (const use of scope.usesOf(element)) {
      const parent = use.parentElement;
      const space = parent && nodeOf(parent)?._nameSpace;
      if (nodeOf(use) || isRefused(use) || !parent || !space) continue;
      // By IMPORT, of which x3dom hears before the file is there.
      space.defMap[attribute(use, 'USE')!] ??= nodeOf(element);
      document.onNodeAdded(use, parent);
    }
  }

  /** An element that moved has a new node in x3dom, which knows nothing of its ROUTEs. */
  #reviveRoutes(element: Element, scope: Scope): void {
    const name = nameOf(element);
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
    const node = nodeOf(element);
    if (node) this.#scene.routed(node as PhysicsX3DNode);
  }
}
