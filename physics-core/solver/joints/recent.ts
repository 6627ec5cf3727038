import type { Component } from './forest.js';

/** Steps for which what was found of a component counts. */
const STEPS = 30;

/** Components of which something was found a few steps ago: that they are taut, or that an edit had torn them. */
export class Recent {
  readonly #left = new Map<Component, number>();

  forget(): void {
    this.#left.clear();
  }

  begin(component: Component): void {
    this.#left.set(component, STEPS);
  }

  has(component: Component): boolean {
    return this.#left.has(component);
  }

  /** A step begins. */
  goesOn(component: Component): boolean {
    const left = this.#left.get(component);
    if (left === undefined) return false;
    if (left > 1) this.#left.set(component, left - 1);
    else this.#left.delete(component);
    return left > 0;
  }
}
