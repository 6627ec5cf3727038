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

  /** Steps for which it still counts; 0: not at all. */
  left(component: Component): number {
    return this.#left.get(component) ?? 0;
  }

  goOn(component: Component, left: number): void {
    if (left > 0) this.#left.set(component, left);
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
