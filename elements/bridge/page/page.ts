import type { Units } from '../../../physics-core/inside.js';
import { adoptStyles } from '../base/sheets.js';
import { worldFor } from '../document/world-for.js';
import { ownBinding, type Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { prefetch } from '../scene/code.js';
import { registerNodeTypes, type Listener } from '../scene/node-types.js';
import type { Scene } from '../scene/scene.js';
import { attribute, isInline, isPhysics, isX3D } from '../words/dom.js';
import { setUpDropped, whenThere } from '../x3dom/late.js';
import { listening } from '../x3dom/listening.js';
import { stopOwnEngine, type OwnTypes } from '../x3dom/own-engine.js';
import { documentOf, x3dom, type PhysicsX3DNode } from '../x3dom/x3dom.js';
import { firstCopy, tellTwoCopies } from './copies.js';
import { explanation, type Explanation } from '../outward/explain.js';
import { Scenes, X3D } from './scenes.js';

/** The page: hands what x3dom tells us to the scene it concerns, and answers what users ask. */
class Page implements Listener {
  readonly #scenes = new Scenes({
    register: () => this.#register(),
  });
  #registered = false;
  begun = false;

  /** Begins to work; again does nothing. */
  begin(): void {
    if (this.begun) return;
    this.begun = true;
    adoptStyles(document, SCENE_TAGS, SPINNER);
    listening.begin();
    listening.onchange = (target, name) => this.#listenersChanged(target, name);
    this.#scenes.begin();
    whenThere(() => this.#register());
    // x3dom says so whenever it has read an <x3d>.
    document.addEventListener('load', () => this.#read());
    this.#scenes.findAll();
  }

  /** A custom element was connected. */
  met(element: Element): void {
    this.begin();
    if (element.closest(X3D)) prefetch([element]);
  }

  #register(): boolean {
    const x = x3dom();
    if (!x || this.#registered) return this.#registered;
    this.#registered = true;
    const types = stopOwnEngine(x);
    registerNodeTypes(x, this);
    // The last frame of x3dom's engine comes before ours.
    if (types) requestAnimationFrame(() => void this.#takeOver(types));
    for (const x3d of document.querySelectorAll(X3D)) {
      listening.adopt(x3d);
      if (documentOf(x3d)) setUpDropped(x3d);
    }
    this.#read();
    return true;
  }

  #read(): void {
    for (const scene of this.#scenes) scene.readByX3DOM();
  }

  /** What x3dom made for an engine of its own before we came. */
  async #takeOver(types: OwnTypes): Promise<void> {
    const { makeOurs } = await import('../x3dom/take-over.js');
    for (const x3d of document.querySelectorAll(X3D))
      if (makeOurs(x3d, types))
        this.#scenes.of(x3d)?.noteFault(x3d, (faults) => faults.otherPhysics());
  }

  /** Of our own nodes their binding tells. */
  circleRefused(use: Element): void {
    if (!isPhysics(use)) this.#scenes.of(use)?.noteFault(use, (faults) => faults.circle(use));
  }

  #listenersChanged(target: EventTarget, name: string): void {
    for (const scene of this.#scenes) scene.listenersChanged(target, name);
  }

  // ---- what x3dom tells -------------------------------------------------------------------------------------------

  /** x3dom made a node anew: it stands where its attributes say until it is drawn again. */
  nodeMade(element: Element): void {
    for (const scene of this.#scenes) {
      const body = scene.drawing.bodyMoving(element);
      if (body) scene.updates.redraw(body);
    }
  }

  routed(node: PhysicsX3DNode): void {
    queueMicrotask(() => this.#sceneOfNode(node)?.routed(node));
  }

  #sceneOfNode(node: PhysicsX3DNode): Scene | undefined {
    for (const scene of this.#scenes) {
      if (scene.document && scene.document === node._nameSpace?.doc) return scene;
    }
    return undefined;
  }

  transformEdited(transform: Element, again: boolean): void {
    for (const scene of this.#scenes)
      if (scene.live) scene.updates.transformEdited(transform, again);
  }

  unitsOfMoved(transform: Element): Units | undefined {
    for (const scene of this.#scenes)
      if (scene.drawing.bodyMoving(transform)) return scene.scopes.around(transform)?.units;
    return undefined;
  }

  inlineSettled(inline: Element, loaded: boolean): void {
    this.#scenes.settledInlines.add(inline);
    const scene = this.#scenes.of(inline);
    if (!loaded) return scene?.noteFault(inline, (faults) => faults.unread(inline));
    // A file may be there before the page around it has been looked at.
    if (!scene?.readPage()) return;
    scene.strangers.delete(inline);
    scene.tree.addInline(inline);
  }

  // ---- what users ask -------------------------------------------------------------------------------------------

  /** The binding of a physics element, or of what it stands for by USE. */
  bindingOf(element: Element): Binding | undefined {
    if (!isPhysics(element)) return undefined;
    const scene = this.#scenes.of(element);
    if (!scene) return attribute(element, 'USE') ? undefined : ownBinding(element);
    if (scene.readPage()) scene.drain();
    const meant = scene.scopes.meant(element);
    return meant && ownBinding(meant);
  }

  /** Where servers render pages there is no world. */
  worldOf(element: Element | null | undefined): PageWorld | undefined {
    const scene = isElement(element) ? this.#scenes.of(element) : undefined;
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
    for (const scene of this.#scenes) {
      for (const scope of scene.scopes) {
        const element = scope.find(name);
        if (element) return element;
      }
    }
    return undefined;
  }

  /** The body that moves an element which is no physics node. */
  bodyOf(element: Element): Binding | undefined {
    const scene = this.#scenes.of(element);
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
 * x3dom rewrites its progress text in each frame, and the page would then lay out the thousands of tags under it: 17 ms per
 * frame at 1000 bodies. Its spinner, once it is transparent, turns on for ever, and the browser draws the page for that.
 */
const SCENE_TAGS = 'x3d > scene, X3D > Scene { display: none; }';
const SPINNER =
  '.x3dom-progress[style*="opacity: 0"] > .x3dom-progress-spinner { animation: none; }';

const own = new Page();

export const page = firstCopy(own);

/** Whether another copy of the library began before this one, and has the tags and the page; told if so. */
export function yieldsToFirst(): boolean {
  if (page === own || !page.begun) return false;
  tellTwoCopies();
  return true;
}
