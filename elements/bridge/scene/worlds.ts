import type { World } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorlds } from '../nodes/surroundings.js';
import type { Scopes } from '../scopes/scopes.js';
import { attribute, precedes } from '../words/dom.js';
import { SceneWorld } from './scene-world.js';

/**
 * The worlds of one `<x3d>`: one per collection, one per `shared-world` name, and the default one. Each ends with the last
 * that lives in it, but for the default one, which is the `<x3d>`'s own: whoever holds it may go on.
 */
export class Worlds implements PageWorlds {
  readonly #scopes: Scopes;
  readonly #own = new WeakMap<Binding, SceneWorld>();
  readonly #shared = new Map<string, SceneWorld>();
  #default: SceneWorld | undefined;
  /** Those that live in the only world, and so elsewhere when that is another. */
  readonly #inOnly = new Set<Binding>();
  #only: SceneWorld | undefined;
  readonly all = new Set<SceneWorld>();
  readonly #listeners: ((world: SceneWorld) => void)[] = [];

  constructor(scopes: Scopes) {
    this.#scopes = scopes;
  }

  /** Calls `listener` with each world when it is made. */
  onmake(listener: (world: SceneWorld) => void): void {
    this.#listeners.push(listener);
  }

  #make(): SceneWorld {
    const world = new SceneWorld(this.#scopes);
    this.all.add(world);
    for (const listener of this.#listeners) listener(world);
    return world;
  }

  /** For bodies outside any collection. */
  get default(): SceneWorld {
    return (this.#default ??= this.#make());
  }

  /** The world, where there is but one with bodies or a collection. */
  get only(): SceneWorld | undefined {
    const founded = [...this.all].filter((world) => world.founded);
    return founded.length === 1 ? founded[0] : undefined;
  }

  /** The only world, for a node that has to move when that is another. */
  onlyFor(binding: Binding): SceneWorld | undefined {
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
    for (const binding of asked) binding.dirty();
  }

  isDefault(world: World | null): boolean {
    return world !== null && world === this.#default;
  }

  #named(name: string): SceneWorld {
    const known = this.#shared.get(name);
    if (known) return known;
    const world = this.#make();
    this.#shared.set(name, world);
    return world;
  }

  of(collection: Binding): SceneWorld {
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

  #end(world: SceneWorld, gone: string): void {
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
