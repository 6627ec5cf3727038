import type { Units } from '../../physics-core/inside.js';
import { firstCopy, tellTwoCopies } from './copies.js';
import { ownBinding, type Binding } from './nodes/binding.js';
import { explanation, type Explanation } from './nodes/explain.js';
import { attribute, isInline, isPhysics, isScene, isX3D } from './document/dom.js';
import {
  makeUnread,
  removeCopies,
  setUpDropped,
  wasLetGo,
  wasRead,
  whenThere,
} from './x3dom/late.js';
import { listening } from './listening.js';
import { registerNodeTypes, type Listener, type PhysicsX3DNode } from './x3dom/node-types.js';
import { Scene } from './scene.js';
import { adoptStyles } from './sheets.js';
import { prefetchEngine } from './engine.js';
import { hasPhysics, Start } from './start.js';
import { worldFor } from './document/structure.js';
import type { PageWorld } from './nodes/worlds.js';
import { documentOf, x3dom } from './x3dom/x3dom.js';

const X3D = 'x3d, X3D';

/** The page: finds each `<x3d>`, and hands what x3dom tells us to the scene it concerns. */
class Page implements Listener {
  readonly #scenes = new Map<Element, { scene: Scene; start: Start }>();
  readonly #settledInlines = new WeakSet<Element>();
  #registered = false;
  begun = false;

  /** Begins to work; again does nothing. */
  begin(): void {
    if (this.begun) return;
    this.begun = true;
    hideSceneTags();
    listening.begin();
    listening.onchange = (target, name) => this.#listenersChanged(target, name);
    new MutationObserver((records) => this.#changed(records)).observe(document, {
      childList: true,
      subtree: true,
    });
    whenThere(() => this.#register());
    // x3dom says so whenever it has read an <x3d>.
    document.addEventListener('load', () => this.#read());
    this.#findAll();
  }

  /** A custom element was connected. */
  met(element: Element): void {
    this.begin();
    if (element.closest(X3D)) prefetchEngine();
  }

  #register(): boolean {
    const x = x3dom();
    if (!x || this.#registered) return this.#registered;
    this.#registered = true;
    this.#otherPhysics = x.nodeTypes.RigidBody !== undefined;
    registerNodeTypes(x, this);
    for (const x3d of document.querySelectorAll(X3D)) {
      listening.adopt(x3d);
      if (documentOf(x3d)) setUpDropped(x3d);
    }
    this.#read();
    return true;
  }

  /** x3dom-full.js brings a physics engine of its own; said once. */
  #otherPhysics = false;

  #reportOtherPhysics(world: PageWorld, x3d: Element): void {
    if (!this.#otherPhysics) return;
    this.#otherPhysics = false;
    world.report(
      {
        code: 'two-physics-engines',
        severity: 'warning',
        value: 'x3dom-full.js',
        used: 'x3d-physics',
        message:
          'x3dom-full.js has physics of its own; load x3dom.js, or both move the same bodies',
      },
      x3d,
    );
  }

  // ---- the x3d elements -----------------------------------------------------------------------------------------

  #findAll(): void {
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
    const known = this.#scenes.get(x3d);
    this.#scenes.delete(x3d);
    known?.start.stop();
    known?.scene.destroy();
  }

  #found(x3d: Element): void {
    if (!x3d.isConnected) return;
    this.sceneAt(x3d);
    this.#scenes.get(x3d)!.start.check();
    if (hasPhysics(x3d)) prefetchEngine();
    // x3dom's own observer has run when this does.
    queueMicrotask(() => this.#haveRead(x3d));
  }

  /** Elements inserted after window load are read only on request. */
  #haveRead(x3d: Element): void {
    const x = x3dom();
    if (!x || document.readyState !== 'complete' || ![...x3d.children].some(isScene)) return;
    this.#register();
    if (wasLetGo(x3d)) makeUnread(x3d);
    if (wasRead(x3d)) return;
    removeCopies(x3d);
    x.reload();
  }

  #read(): void {
    for (const { scene } of this.#scenes.values()) scene.readByX3DOM();
  }

  sceneAt(x3d: Element): Scene {
    const known = this.#scenes.get(x3d);
    if (known) return known.scene;
    const scene = new Scene(x3d);
    const start = new Start(scene, this.#settledInlines);
    this.#scenes.set(x3d, { scene, start });
    const made = scene.worlds.onmake;
    scene.worlds.onmake = (world) => {
      made(world);
      world.on('ready', () => this.#reportOtherPhysics(world, x3d));
    };
    return scene;
  }

  /** The scene of an element of the page, or of one in an Inline or prototype. */
  sceneOf(element: Element): Scene | undefined {
    const x3d = element.closest(X3D);
    if (x3d?.isConnected && x3d.ownerDocument === document) return this.sceneAt(x3d);
    for (const { scene } of this.#scenes.values()) if (scene.scopeOf(element)) return scene;
    return undefined;
  }

  #listenersChanged(target: EventTarget, name: string): void {
    for (const { scene } of this.#scenes.values()) scene.listenersChanged(target, name);
  }

  // ---- what x3dom tells -------------------------------------------------------------------------------------------

  /** x3dom made a node anew: it stands where its attributes say until it is drawn again. */
  nodeMade(element: Element): void {
    for (const { scene } of this.#scenes.values()) {
      const body = scene.drawing.bodyMoving(element);
      if (body) scene.updates.redraw(body);
    }
  }

  routed(node: PhysicsX3DNode): void {
    queueMicrotask(() => this.#sceneOfNode(node)?.routed(node));
  }

  #sceneOfNode(node: PhysicsX3DNode): Scene | undefined {
    for (const { scene } of this.#scenes.values()) {
      if (scene.document && scene.document === node._nameSpace?.doc) return scene;
    }
    return undefined;
  }

  transformEdited(transform: Element, again: boolean): void {
    for (const { scene } of this.#scenes.values())
      if (scene.live) scene.updates.transformEdited(transform, again);
  }

  unitsOfMoved(transform: Element): Units | undefined {
    for (const { scene } of this.#scenes.values())
      if (scene.drawing.bodyMoving(transform)) return scene.scopeOf(transform)?.units;
    return undefined;
  }

  inlineSettled(inline: Element, loaded: boolean): void {
    this.#settledInlines.add(inline);
    const scene = loaded ? this.sceneOf(inline) : undefined;
    // A file may be there before the page around it has been looked at.
    if (scene?.readPage()) scene.addInline(inline);
  }

  // ---- what users ask -------------------------------------------------------------------------------------------

  /** The binding of a physics element, or of what it stands for by USE. */
  bindingOf(element: Element): Binding | undefined {
    if (!isPhysics(element)) return undefined;
    const scene = this.sceneOf(element);
    if (!scene) return attribute(element, 'USE') ? undefined : ownBinding(element);
    if (scene.readPage()) scene.drain();
    const meant = scene.meant(element);
    return meant && ownBinding(meant);
  }

  /** Where servers render pages there is no world. */
  worldOf(element: Element | null | undefined): PageWorld | undefined {
    const scene = isElement(element) ? this.sceneOf(element) : undefined;
    if (!element || !scene?.readPage()) return undefined;
    const inlined = isInline(element) && scene.worldIn(element);
    if (inlined) return inlined;
    const binding = this.bindingOf(element) ?? this.bodyOf(element);
    if (binding?.scope) return binding.world ?? worldFor(binding) ?? scene.worlds.default;
    return scene.worlds.only ?? scene.firstWorld();
  }

  /** Of a physics element, or of the body that moves any other one. */
  explain(element: Element): Explanation {
    if (!isElement(element))
      throw new TypeError(`explain takes an element of a page, not ${String(element)}`);
    return explanation(element, this.bindingOf(element) ?? this.bodyOf(element));
  }

  /** The element with this DEF or id in any scene, Inlines included. */
  find(name: string): Element | undefined {
    for (const { scene } of this.#scenes.values()) {
      for (const scope of scene.scopes) {
        const element = scope.find(name);
        if (element) return element;
      }
    }
    return undefined;
  }

  /** The body that moves an element which is no physics node. */
  bodyOf(element: Element): Binding | undefined {
    const scene = this.sceneOf(element);
    for (let at: Element | null = element; at && scene && !isX3D(at); at = at.parentElement) {
      const body = scene.drawing.bodyMoving(at);
      if (body) return body;
    }
    return undefined;
  }
}

const isElement = (value: unknown): value is Element =>
  globalThis.Element !== undefined && value instanceof Element;

/**
 * x3dom rewrites its progress text in each frame, and the page would then lay out the thousands of tags under it:
 * 17 ms per frame at 1000 bodies.
 */
function hideSceneTags(): void {
  adoptStyles(document, 'x3d > scene, X3D > Scene { display: none; }');
}

const own = new Page();

export const page = firstCopy(own);

/** Whether another copy of the library began before this one, and has the tags and the page; told if so. */
export function yieldsToFirst(): boolean {
  if (page === own || !page.begun) return false;
  tellTwoCopies();
  return true;
}
