import { prefetch } from '../scene/code.js';
import { Start } from '../scene/start.js';
import { Scene } from '../scene/scene.js';
import { isScene, isX3D, subtree } from '../words/dom.js';
import { makeUnread, removeCopies, wasLetGo, wasRead } from '../x3dom/late.js';
import { x3dom } from '../x3dom/x3dom.js';

export const X3D = 'x3d, X3D';

/** What is to be done about an `<x3d>`. */
interface Hooks {
  /** x3dom is to know our node types before it reads one. */
  register(): void;
}

/** Each `<x3d>` of the page as it comes and goes, and its scene. */
export class Scenes {
  readonly #hooks: Hooks;
  readonly #all = new Map<Element, { scene: Scene; start: Start }>();
  /** Inlines whose file has come, or will not. */
  readonly settledInlines = new WeakSet<Element>();

  constructor(hooks: Hooks) {
    this.#hooks = hooks;
  }

  *[Symbol.iterator](): Generator<Scene> {
    for (const { scene } of this.#all.values()) yield scene;
  }

  /** Finds those that are there, and those that come. */
  begin(): void {
    new MutationObserver((records) => this.#changed(records)).observe(document, {
      childList: true,
      subtree: true,
    });
  }

  findAll(): void {
    for (const x3d of document.querySelectorAll(X3D)) this.#found(x3d);
  }

  #changed(records: MutationRecord[]): void {
    for (const { target, addedNodes, removedNodes } of records) {
      for (const node of addedNodes) if (node instanceof Element) this.#added(node, target);
      for (const node of removedNodes) if (node instanceof Element) this.#removed(node);
    }
  }

  #added(node: Element, parent: Node): void {
    if (parent instanceof Element && isX3D(parent) && isScene(node)) this.#found(parent);
    if (isX3D(node)) this.#found(node);
    else if (node.firstElementChild) for (const x3d of node.querySelectorAll(X3D)) this.#found(x3d);
  }

  #removed(node: Element): void {
    const gone = isX3D(node) ? [node] : node.firstElementChild ? node.querySelectorAll(X3D) : [];
    for (const x3d of gone) {
      // Put back within one task, its worlds go on; x3dom has to read it again all the same.
      queueMicrotask(() => (x3d.isConnected ? this.#found(x3d) : this.#forget(x3d)));
    }
  }

  #forget(x3d: Element): void {
    const known = this.#all.get(x3d);
    this.#all.delete(x3d);
    known?.start.stop();
    known?.scene.destroy();
  }

  #found(x3d: Element): void {
    if (!x3d.isConnected) return;
    this.at(x3d);
    this.#all.get(x3d)!.start.check();
    prefetch(subtree(x3d));
    // x3dom's own observer has run when this does.
    queueMicrotask(() => this.#haveRead(x3d));
  }

  /** Elements inserted after window load are read only on request. */
  #haveRead(x3d: Element): void {
    const x = x3dom();
    if (!x || document.readyState !== 'complete' || ![...x3d.children].some(isScene)) return;
    this.#hooks.register();
    if (wasLetGo(x3d)) makeUnread(x3d);
    if (wasRead(x3d)) return;
    removeCopies(x3d);
    x.reload();
  }

  at(x3d: Element): Scene {
    const known = this.#all.get(x3d);
    if (known) return known.scene;
    const scene = new Scene(x3d);
    const start = new Start(scene, this.settledInlines);
    this.#all.set(x3d, { scene, start });
    return scene;
  }

  /** The scene of an element of the page, or of one in an Inline or prototype. */
  of(element: Element): Scene | undefined {
    const x3d = element.closest(X3D);
    if (x3d?.isConnected && x3d.ownerDocument === document) return this.at(x3d);
    for (const scene of this) if (scene.scopes.around(element)) return scene;
    return undefined;
  }
}
