// Nodes that a property, a ROUTE or a prototype names for a field, in the place of the field's child elements.

/** What script may hand over for nodes: one element, any list of them, or text; undefined: nothing is named. */
export function nodesGiven(value: unknown): unknown {
  if (value === null || value === undefined) return undefined;
  const list = typeof value === 'object' && !(value instanceof Element) && Symbol.iterator in value;
  return list ? [...(value as Iterable<unknown>)] : value;
}

/** The elements among them; undefined where text or nothing was given. */
export function elementsAmong(value: unknown): Element[] | undefined {
  if (value instanceof Element) return [value];
  return Array.isArray(value) ? value.filter((each) => each instanceof Element) : undefined;
}

/** Which nodes name which elements. */
export class Namers<Namer extends { is(...types: string[]): boolean }> {
  readonly #byElement = new WeakMap<Element, Set<Namer>>();

  /** `namer` names these now, and no longer those of before. */
  note(namer: Namer, before: Element[], after: Element[]): void {
    for (const element of before) this.#byElement.get(element)?.delete(namer);
    for (const element of after) {
      const set = this.#byElement.get(element) ?? new Set();
      this.#byElement.set(element, set.add(namer));
    }
  }

  /** Nodes of these types that stand in a scene and name an element. */
  of(element: Element, ...types: string[]): Namer[] {
    const all = this.#byElement.get(element);
    return all ? [...all].filter((namer) => namer.is(...types)) : [];
  }
}
