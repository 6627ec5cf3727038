import { attribute } from '../words/dom.js';
import { Scope } from './scope.js';

/** The scopes of one `<x3d>`, by the element they stand under. */
export class Scopes {
  readonly x3d: Element;
  readonly #byRoot = new Map<Element, Scope>();

  constructor(x3d: Element) {
    this.x3d = x3d;
  }

  [Symbol.iterator](): Iterator<Scope> {
    return this.#byRoot.values();
  }

  add(root: Element, host: Element | null, parent: Scope | null): Scope {
    const scope = new Scope(this, root, host, parent);
    this.#byRoot.set(root, scope);
    return scope;
  }

  delete({ root }: Scope): void {
    this.#byRoot.delete(root);
  }

  under(root: Element): Scope | undefined {
    return this.#byRoot.get(root);
  }

  /** The nearest scope around an element. */
  around(element: Element): Scope | undefined {
    for (let at: Element | null = element; at; at = at.parentElement) {
      const scope = this.#byRoot.get(at);
      if (scope) return scope;
    }
    return undefined;
  }

  /** The scope that an Inline or a prototype's instance stands for. */
  in(host: Element): Scope | undefined {
    for (const scope of this) if (scope.host === host) return scope;
    return undefined;
  }

  /** The element that an element means: itself, or what it stands for by USE. */
  meant(element: Element): Element | undefined {
    const use = attribute(element, 'USE');
    return use ? this.around(element)?.find(use) : element;
  }
}
