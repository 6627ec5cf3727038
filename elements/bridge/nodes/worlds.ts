import {
  World,
  type PhysicsNode,
  type Problem,
  type RayHit,
} from '../../../physics-core/inside.js';
import { ownBinding, type Binding } from './binding.js';
import { logInPage } from '../document/console.js';
import { attribute, precedes } from '../document/dom.js';
import type { Scene } from '../scene.js';
import { setState } from '../states.js';

/** The longest stretch a world takes at once without calling it lag, seconds. */
const STRETCH = 0.1;

/** What a ray hits in a page. */
export interface PageHit extends RayHit {
  element: Element;
}

/** A world whose nodes stand in an `<x3d>`. */
export class PageWorld extends World {
  readonly scene: Scene;
  /** All that live in it, with a node or without one yet. */
  readonly #members = new Set<Binding>();
  /** Those of them that make a world; the others go where those are. */
  #founders = 0;
  /** Its RigidBodyCollections, in the order of the document. */
  readonly collections = new Set<Binding>();

  constructor(scene: Scene) {
    super({ console: (problem) => logInPage(problem, problem.element) });
    this.scene = scene;
    this.onwork = () => scene.loop.wake();
    this.on('debug', (on) => scene.debug.turn(this, on as boolean));
  }

  /** Edits of plain tags are seen by an observer that has not run yet: have it run now. */
  override flush(): void {
    this.scene.drain();
    super.flush();
  }

  /** A paused world is drawn after a step by hand, too. */
  override step(n = 1): number {
    const seconds = super.step(n);
    this.work();
    return seconds;
  }

  /** A field with a value that the core can use may still have a problem in the markup: that stands. */
  override settle(about: unknown, attributeName?: string, code?: string): void {
    const element = about instanceof Element ? about : (about as { host?: unknown }).host;
    if (!(element instanceof Element)) {
      super.settle(about, attributeName, code);
      for (const collection of this.collections) this.#showProblems(collection.element);
      return;
    }
    for (const problem of this.problemsOf(element)) {
      if (attributeName && problem.attribute !== attributeName) continue;
      if (!code && ownBinding(element)?.found(problem.code, problem.attribute)) continue;
      if (!code || problem.code === code) super.settle(element, problem.attribute, problem.code);
    }
    this.#showProblems(element);
  }

  /** A collection shows those of the world itself, too. */
  #showProblems(element: Element): void {
    const binding = ownBinding(element);
    const own = this.problemsOf(element).length > 0;
    const worlds = !!binding && this.collections.has(binding) && this.problemsOf(this).length > 0;
    setState(element, 'problem', own || worlds);
  }

  /** The element beside the node: that of the body, or of the collidable without one. */
  override raycast(...way: Parameters<World['raycast']>): PageHit | null {
    const hit = super.raycast(...way);
    return hit && { ...hit, element: hit.node.host as Element };
  }

  /** By name, or by an element, also one that only stands for another by USE. */
  override node(nameOrElement: unknown): PhysicsNode | undefined {
    if (typeof nameOrElement === 'string')
      return this.#named(nameOrElement) ?? super.node(nameOrElement);
    const element =
      nameOrElement instanceof Element ? this.scene.meant(nameOrElement) : nameOrElement;
    if (element instanceof Element) return this.#nodeOf(element);
    return element == null ? undefined : super.node(element);
  }

  /** Asked of its host, the core might answer with the collidable that a shortcut gives a body. */
  #nodeOf(element: Element): PhysicsNode | undefined {
    const binding = ownBinding(element);
    return binding?.world === this ? (binding.node ?? undefined) : undefined;
  }

  /** Its node has one name only, an element may have a DEF and an id. */
  #named(name: string): PhysicsNode | undefined {
    for (const scope of this.scene.scopes) {
      const element = scope.find(name);
      const node = element && this.#nodeOf(element);
      if (node) return node;
    }
    return undefined;
  }

  /** Time passes, in seconds; a hidden page gets a frame per second, which is taken in pieces. */
  pass(seconds: number, hidden: boolean): boolean {
    let left = seconds;
    for (; hidden && left > STRETCH; left -= STRETCH) this.frame(STRETCH, false);
    return this.frame(left, !hidden);
  }

  // ---- who lives in it --------------------------------------------------------------------------------------------

  enter(member: Binding): void {
    this.#members.add(member);
    if (isFounder(member)) this.#founders++;
  }

  leave(member: Binding): void {
    this.#members.delete(member);
    if (isFounder(member)) this.#founders--;
  }

  /** Whether it has a body or a collection. */
  get founded(): boolean {
    return this.#founders > 0;
  }

  /** Whether nothing lives in it any more, what script added included. */
  get deserted(): boolean {
    const [node] = this.nodes;
    return this.#members.size === 0 && !node;
  }

  /** For good; what it holds of Bullet is given back. `gone`: what left the page. */
  end(gone: string): void {
    if (!this.started) this.fail(this.#over(gone));
    this.destroy();
  }

  #over(gone: string): Problem {
    return {
      code: 'world-ended',
      severity: 'info',
      value: gone,
      message: `the world ended before it had started: ${gone} left the page`,
      element: this.scene.x3d,
    };
  }

  /** Keeps running while the page is hidden or the scene scrolled away. */
  get runsHidden(): boolean {
    for (const collection of this.collections) if (collection.get('runHidden')) return true;
    return false;
  }
}

const isFounder = (member: Binding): boolean => member.is('RigidBodyCollection', 'RigidBody');

/**
 * The worlds of one `<x3d>`: one per collection, one per `shared-world` name, and the default one. Each ends with the last
 * that lives in it, but for the default one, which is the `<x3d>`'s own: whoever holds it may go on.
 */
export class Worlds {
  readonly #scene: Scene;
  readonly #own = new WeakMap<Binding, PageWorld>();
  readonly #shared = new Map<string, PageWorld>();
  #default: PageWorld | undefined;
  /** Those that live in the only world, and so elsewhere when that is another. */
  readonly #inOnly = new Set<Binding>();
  #only: PageWorld | undefined;
  readonly all = new Set<PageWorld>();
  /** Called with each world when it is made. */
  onmake: (world: PageWorld) => void = () => {};

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  #make(): PageWorld {
    const world = new PageWorld(this.#scene);
    this.all.add(world);
    this.onmake(world);
    return world;
  }

  /** For bodies outside any collection. */
  get default(): PageWorld {
    return (this.#default ??= this.#make());
  }

  /** The world, where there is but one with bodies or a collection. */
  get only(): PageWorld | undefined {
    const founded = [...this.all].filter((world) => world.founded);
    return founded.length === 1 ? founded[0] : undefined;
  }

  /** The only world, for a node that has to move when that is another. */
  onlyFor(binding: Binding): PageWorld | undefined {
    this.#inOnly.add(binding);
    return this.only;
  }

  /** It has left. */
  forget(binding: Binding): void {
    this.#inOnly.delete(binding);
  }

  /** Bodies or collections came or went: those that live in the only world are asked anew. */
  checkOnly(): void {
    const { only } = this;
    if (only === this.#only) return;
    this.#only = only;
    const asked = [...this.#inOnly];
    this.#inOnly.clear();
    for (const binding of asked) if (binding.scope) this.#scene.dirty(binding);
  }

  isDefault(world: PageWorld | null): boolean {
    return world !== null && world === this.#default;
  }

  #named(name: string): PageWorld {
    const known = this.#shared.get(name);
    if (known) return known;
    const world = this.#make();
    this.#shared.set(name, world);
    return world;
  }

  of(collection: Binding): PageWorld {
    const shared = attribute(collection.element, 'shared-world') ?? collection.scope?.sharedWorld;
    if (shared) return this.#named(shared);
    if (isDefaultCollection(collection.element)) return this.default;
    const known = this.#own.get(collection);
    if (known && this.all.has(known)) return known;
    const world = this.#make();
    this.#own.set(collection, world);
    return world;
  }

  /** The collection that gives the default world its fields. */
  defaultCollection(): Binding | undefined {
    return [...(this.#default?.collections ?? [])].sort((a, b) =>
      precedes(a.element, b.element),
    )[0];
  }

  /** Never within a step: worlds that nothing lives in any more end. */
  endDeserted(): void {
    for (const world of this.all)
      if (world.deserted && world !== this.#default) this.#end(world, 'all that lived in it');
  }

  #end(world: PageWorld, gone: string): void {
    this.all.delete(world);
    for (const [name, shared] of this.#shared) if (shared === world) this.#shared.delete(name);
    world.end(gone);
  }

  destroy(): void {
    for (const world of this.all) this.#end(world, 'its <x3d>');
    this.#default = undefined;
  }
}

export function isDefaultCollection(element: Element): boolean {
  const text = attribute(element, 'default');
  return text !== null && text.trim().toLowerCase() !== 'false';
}
