import { ownBinding, type Binding } from './binding.js';
import { isPhysics, subtree } from '../words/dom.js';
import type { Scope } from '../scopes/scope.js';

/** The nodes of a scope, in the order of the document. */
export function* bindingsIn(scope: Scope): Generator<Binding> {
  for (const element of subtree(scope.root)) {
    const binding = isPhysics(element) ? ownBinding(element) : undefined;
    if (binding?.scope) yield binding;
  }
}
