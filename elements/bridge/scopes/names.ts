import { Sets } from '../base/sets.js';
import { attribute, precedes } from '../words/dom.js';

interface Entry {
  def: string | null;
  id: string | null;
  use: string | null;
}

/** Who hears when something changes that it reads. */
export interface Watcher {
  /** The scopes in which it watches names. */
  readonly watching: Set<Names>;
  /** What its node is to be may be another now. */
  dirty(): void;
}

/**
 * The names of one scope: who carries a name, who stands for it by USE, and which nodes wait for it or use it.
 * A change of one name touches only those.
 */
export class Names {
  readonly #entries = new Map<Element, Entry>();
  readonly #defs = new Sets<string, Element>();
  readonly #ids = new Sets<string, Element>();
  readonly #uses = new Sets<string, Element>();
  readonly #watchers = new Sets<string, Watcher>();
  readonly #watched = new Sets<Watcher, string>();
  /** Called with each name whose bearers or users changed. */
  onchange: (name: string, watchers: Iterable<Watcher>) => void = () => {};

  add(element: Element): void {
    const entry = {
      def: attribute(element, 'DEF'),
      id: attribute(element, 'id'),
      use: attribute(element, 'USE'),
    };
    if (!entry.def && !entry.id && !entry.use) return;
    this.#entries.set(element, entry);
    if (entry.def) this.#defs.add(entry.def, element);
    if (entry.id) this.#ids.add(entry.id, element);
    if (entry.use) this.#uses.add(entry.use, element);
    this.#changed(entry);
  }

  remove(element: Element): void {
    const entry = this.#entries.get(element);
    if (!entry) return;
    this.#entries.delete(element);
    if (entry.def) this.#defs.delete(entry.def, element);
    if (entry.id) this.#ids.delete(entry.id, element);
    if (entry.use) this.#uses.delete(entry.use, element);
    this.#changed(entry);
  }

  has(element: Element): boolean {
    return this.#entries.has(element);
  }

  #changed({ def, id, use }: Entry): void {
    for (const name of new Set([def, id, use])) if (name) this.touch(name);
  }

  touch(name: string): void {
    this.onchange(name, this.#watchers.list(name));
  }

  /** DEF before id; the last DEF wins, as in X3D. */
  find(name: string): Element | undefined {
    return this.bearers(name).at(-1) ?? this.#ids.get(name)?.values().next().value;
  }

  /** All elements with this DEF, in document order. */
  bearers(name: string): Element[] {
    const bearers = this.#defs.list(name);
    return bearers.length > 1 ? bearers.sort(precedes) : bearers;
  }

  /** The elements that stand for `element` by USE, in document order. */
  usesOf(element: Element): Element[] {
    const entry = this.#entries.get(element);
    const names = [entry?.def, entry?.id].filter((name) => name && this.find(name) === element);
    const uses = names.flatMap((name) => this.#uses.list(name!));
    return uses.length > 1 ? uses.sort(precedes) : uses;
  }

  /** The elements that stand for a node of this name, whichever that is. */
  usesNamed(name: string): Element[] {
    return this.#uses.list(name);
  }

  /** `watcher` is to hear when the bearers of `name` change. */
  watch(name: string, watcher: Watcher): void {
    this.#watchers.add(name, watcher);
    this.#watched.add(watcher, name);
    watcher.watching.add(this);
  }

  unwatch(watcher: Watcher): void {
    for (const name of this.#watched.get(watcher) ?? []) this.#watchers.delete(name, watcher);
    this.#watched.deleteAll(watcher);
  }
}
