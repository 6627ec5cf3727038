/** Of 2^32, the golden section: it spreads what lies at even distances. */
const SPREAD = 0x9e3779b1;

/**
 * Numbers of pointers, from 0 on, in the order in which they come: a Map of a step that makes nothing, in one array. None
 * is taken out by itself.
 */
export class PointerNumbers {
  count = 0;
  /** A pointer and its number at the place that the pointer leads to, or at the next one that is free: pointer 0. */
  #places = new Int32Array(2 * 64);

  clear(): void {
    if (this.count > 0) this.#places.fill(0);
    this.count = 0;
  }

  /** -1: it has none. */
  find(pointer: number): number {
    const at = this.#placeOf(pointer);
    return this.#places[at] === 0 ? -1 : this.#places[at + 1]!;
  }

  /** A new one where it has none yet. */
  numberOf(pointer: number): number {
    const at = this.#placeOf(pointer);
    if (this.#places[at] !== 0) return this.#places[at + 1]!;
    this.#places[at] = pointer;
    this.#places[at + 1] = this.count;
    if (4 * ++this.count > this.#places.length) this.#grow();
    return this.count - 1;
  }

  #placeOf(pointer: number): number {
    const places = this.#places;
    const last = places.length - 2;
    let at = (Math.imul(pointer, SPREAD) >>> 8) & last & ~1;
    while (places[at] !== 0 && places[at] !== pointer) at = (at + 2) & last;
    return at;
  }

  #grow(): void {
    const before = this.#places;
    this.#places = new Int32Array(2 * before.length);
    for (let i = 0; i < before.length; i += 2) {
      if (before[i] === 0) continue;
      const at = this.#placeOf(before[i]!);
      this.#places[at] = before[i]!;
      this.#places[at + 1] = before[i + 1]!;
    }
  }
}
