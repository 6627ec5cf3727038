import type { Binding } from '../nodes/binding.js';
import { precedes } from '../words/dom.js';
import type { Scope } from '../scopes/scope.js';

/** By rank, then in document order: arrival is that within a scope. */
export function inOrder(bindings: Binding[]): Binding[] {
  return bindings.sort((a, b) => a.type.rank - b.type.rank || byScope(a, b));
}

const byScope = (a: Binding, b: Binding): number => (a.scope === b.scope ? 0 : byPlace(a, b));

/** In document order: what stands in a scope inside stands where that scope does. */
export function byPlace(a: Binding, b: Binding): number {
  let [left, right] = [a.element, b.element];
  let [inLeft, inRight] = [a.scope!, b.scope!];
  while (inLeft !== inRight) {
    if (depth(inLeft) >= depth(inRight)) [left, inLeft] = [inLeft.host!, inLeft.parent!];
    else [right, inRight] = [inRight.host!, inRight.parent!];
  }
  return precedes(left, right);
}

const depth = (scope: Scope): number => (scope.parent ? depth(scope.parent) + 1 : 0);
