import type { Binding } from '../nodes/binding.js';
import { inOrder as elementsInOrder } from '../scopes/standing.js';

/** By rank, then in document order: arrival is that within a scope. */
export function inOrder(bindings: Binding[]): Binding[] {
  return bindings.sort((a, b) => a.type.rank - b.type.rank || byScope(a, b));
}

const byScope = (a: Binding, b: Binding): number => (a.scope === b.scope ? 0 : byPlace(a, b));

/** In document order: what stands in a scope inside stands where that scope does. */
export const byPlace = (a: Binding, b: Binding): number =>
  elementsInOrder(a.element, a.scope!, b.element, b.scope!);
