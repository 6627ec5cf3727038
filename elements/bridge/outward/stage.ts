import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import type { Scope } from '../scopes/scope.js';
import type { X3DDocument } from '../x3dom/x3dom.js';
import type { DraggableBody } from './body.js';

/** What those who show a scene, hear of it and reach into it ask of it. */
export interface Stage {
  readonly x3d: Element;
  /** What x3dom has of it. */
  readonly document: X3DDocument | undefined;
  readonly live: boolean;
  readonly worlds: { readonly all: Iterable<PageWorld> };
  readonly draggables: { readonly bodies: ReadonlySet<DraggableBody> };
  readonly events: {
    /** False where a listener forbids its start. */
    drag(binding: Binding, type: string, detail: object): boolean;
  };
  /** The page's own scope. */
  readPage(): Scope | undefined;
  /** All nodes. */
  bindings(): Iterable<Binding>;
  /** What happened to the document so far in this task is seen now. */
  takeRecords(): void;
  requestRender(): void;
}
