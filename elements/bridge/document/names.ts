import type { Binding } from '../nodes/binding.js';
import { attribute, precedes } from './dom.js';

type Index<T> = Map<string, Set<T>>;

function put<T>(index: Index<T>, name: string, item: T): void {
  const set = index.get(name);
  if (set) set.add(item);
  else index.set(name, new Set([item]));
}

function take<T>(index: Index<T>, name: string, item: T): void {
  const set = index.get(name);
  if (set?.delete(item) && set.size === 0) index.delete(name);
}

interface Entry {
  def: string | null;
  id: string | null;
  use: string | null;
}

/**
 * The names of one scope: who carries a name, who stands for it by USE, and which nodes wait for it or use it.
 * A change of one name touches only those.
 */
export class Names {
  readonly #entries = new Map<Element, Entry>();
  readonly #defs: Index<Element> = new Map();
  readonly #ids: Index<Element> = new Map();
  readonly #uses: Index<Element> = new Map();
  readonly #watchers: Index<Binding> = new Map();
  readonly #watched = new Map<Binding, Set<string>>();
  /** Called with each name whose bearers or users changed. */
  onchange: (name: string, watchers: Iterable<Binding>) => void = () => {};

  add(element: Element): void {
    const entry = {
      def: attribute(element, 'DEF'),
      id: attribute(element, 'id'),
      use: attribute(element, 'USE'),
    };
    if (!entry.def && !entry.id && !entry.use) return;
    this.#entries.set(element, entry);
    if (entry.def) put(this.#defs, entry.def, element);
    if (entry.id) put(this.#ids, entry.id, element);
    if (entry.use) put(this.#uses, entry.use, element);
    this.#changed(entry);
  }

  remove(element: Element): void {
    const entry = this.#entries.get(element);
    if (!entry) return;
    this.#entries.delete(element);
    if (entry.def) take(this.#defs, entry.def, element);
    if (entry.id) take(this.#ids, entry.id, element);
    if (entry.use) take(this.#uses, entry.use, element);
    this.#changed(entry);
  }

  has(element: Element): boolean {
    return this.#entries.has(element);
  }

  #changed({ def, id, use }: Entry): void {
    for (const name of new Set([def, id, use])) if (name) this.touch(name);
  }

  touch(name: string): void {
    this.onchange(name, [...(this.#watchers.get(name) ?? [])]);
  }

  /** DEF before id; the last DEF wins, as in X3D. */
  find(name: string): Element | undefined {
    return this.bearers(name).at(-1) ?? this.#ids.get(name)?.values().next().value;
  }

  /** All elements with this DEF, in document order. */
  bearers(name: string): Element[] {
    const bearers = [...(this.#defs.get(name) ?? [])];
    return bearers.length > 1 ? bearers.sort(precedes) : bearers;
  }

  /** The elements that stand for `element` by USE, in document order. */
  usesOf(element: Element): Element[] {
    const entry = this.#entries.get(element);
    const names = [entry?.def, entry?.id].filter((name) => name && this.find(name) === element);
    const uses = names.flatMap((name) => [...(this.#uses.get(name!) ?? [])]);
    return uses.length > 1 ? uses.sort(precedes) : uses;
  }

  get allUses(): Element[] {
    return [...this.#uses.values()].flatMap((uses) => [...uses]);
  }

  /** `binding` is to hear when the bearers of `name` change. */
  watch(name: string, binding: Binding): void {
    put(this.#watchers, name, binding);
    binding.watching.add(this);
    const names = this.#watched.get(binding) ?? new Set();
    this.#watched.set(binding, names.add(name));
  }

  unwatch(binding: Binding): void {
    for (const name of this.#watched.get(binding) ?? []) take(this.#watchers, name, binding);
    this.#watched.delete(binding);
  }
}
