import type { Scope } from '../scopes/scope.js';

/** What a body or collidable stands for in the scene: the Transform it moves, and where its Shapes are. */
export interface StandIn {
  scope: Scope;
  /** Undefined for a Shape with no Transform above it: nothing can be moved. */
  transform: Element | undefined;
  shapes: Element;
}
