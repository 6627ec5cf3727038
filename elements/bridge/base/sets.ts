/** Sets by key. None is kept empty, so that a key that has gone is held by nothing here. */
export class Sets<Key, Item> {
  readonly #sets = new Map<Key, Set<Item>>();

  get isEmpty(): boolean {
    return this.#sets.size === 0;
  }

  add(key: Key, item: Item): void {
    const set = this.#sets.get(key);
    if (set) set.add(item);
    else this.#sets.set(key, new Set([item]));
  }

  delete(key: Key, item: Item): void {
    const set = this.#sets.get(key);
    if (set?.delete(item) && set.size === 0) this.#sets.delete(key);
  }

  deleteAll(key: Key): void {
    this.#sets.delete(key);
  }

  get(key: Key): ReadonlySet<Item> | undefined {
    return this.#sets.get(key);
  }

  /** A list of its own: the set may change meanwhile. */
  list(key: Key): Item[] {
    return [...(this.#sets.get(key) ?? [])];
  }
}
