import type { Units } from '../../../physics-core/inside.js';
import type { NodeType } from '../words/dom.js';
import { authoredText, holdsNodes, inSI } from '../words/fields.js';
import { elementsAmong } from './named.js';

/** What the author of an element wrote: by script since the attribute was last written, else in the attribute. */
export class Authored {
  readonly #element: Element;
  readonly #type: NodeType;
  /** By script; in file units. */
  readonly #properties = new Map<string, unknown>();

  constructor(element: Element, type: NodeType) {
    this.#element = element;
    this.#type = type;
  }

  /** Undefined when nothing. */
  get(name: string): unknown {
    if (this.#properties.has(name)) return this.#properties.get(name);
    return authoredText(this.#element, name, this.#type);
  }

  byScript(name: string): boolean {
    return this.#properties.has(name);
  }

  set(name: string, value: unknown): void {
    this.#properties.set(name, value);
  }

  /** Script takes its word back; false where it gave none. */
  takeBack(name: string): boolean {
    return this.#properties.delete(name);
  }

  /** All fields that hold values, in SI. */
  fields(units: Units): Record<string, unknown> {
    const fields: Record<string, unknown> = {};
    for (const [name, field] of Object.entries(this.#type.fields)) {
      if (holdsNodes(field)) continue;
      const value = this.get(name);
      if (value !== undefined) fields[name] = inSI(field, value, units);
    }
    return fields;
  }

  /** Elements named for a field that holds nodes; undefined: its children stand for it. */
  named(name: string): Element[] | undefined {
    return elementsAmong(this.#properties.get(name));
  }

  /** All that are named. */
  get allNamed(): Element[] {
    return [...this.#properties.keys()].flatMap((name) => this.named(name) ?? []);
  }
}
