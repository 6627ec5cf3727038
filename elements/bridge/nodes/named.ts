import type { Binding } from './binding.js';

// Nodes that a property, a ROUTE or a prototype names for a field, in the place of the field's child elements.

const namers = new WeakMap<Element, Set<Binding>>();

/** `binding` names these now, and no longer those of before. */
export function noteNamed(binding: Binding, before: Element[], after: Element[]): void {
  for (const element of before) namers.get(element)?.delete(binding);
  for (const element of after) {
    const set = namers.get(element) ?? new Set();
    namers.set(element, set.add(binding));
  }
}

/** Nodes of these types that stand in a scene and name an element. */
export function namersOf(element: Element, ...types: string[]): Binding[] {
  const all = namers.get(element);
  return all ? [...all].filter((binding) => binding.is(...types)) : [];
}

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
