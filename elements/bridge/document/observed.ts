import { ownBinding } from '../nodes/binding.js';
import { fieldsByAttribute } from '../words/fields.js';
import {
  attribute,
  fileOf,
  isInline,
  isPhysics,
  isTransform,
  isType,
  lowerName,
  subtree,
} from '../words/dom.js';
import type { Readers } from '../scopes/readers.js';
import type { Scope } from '../scopes/scope.js';
import { noteRead, PLACING } from '../x3dom/transform-edits.js';
import { nodeOf } from '../x3dom/x3dom.js';

/** Names and what decides who an element stands for. */
const NAMING = new Set([
  'def',
  'id',
  'use',
  'containerfield',
  'as',
  'localdef',
  'importeddef',
  'inlinedef',
]);

/** Who hears of elements that come and go. */
export interface Elements {
  connect(root: Element, scope: Scope): void;
  /** `from`: what it was taken out of. */
  disconnect(root: Element, scope: Scope, from: Element): void;
  /** It has other names, or stands for another one. */
  renamed(element: Element, scope: Scope): void;
  /** What the nodes of an Inline live in changed. */
  requeueInline(inline: Element): void;
}

/** Follows the document under an `<x3d>` and in its Inlines; x3dom's own observer misses much (x3dom.md). */
export class Observed {
  readonly #elements: Elements;
  readonly #readers: Readers;
  readonly #observers = new Map<Scope, MutationObserver>();

  constructor(elements: Elements, readers: Readers) {
    this.#elements = elements;
    this.#readers = readers;
  }

  observe(scope: Scope): void {
    const observer = new MutationObserver((records) => this.#take(records, scope));
    this.#observers.set(scope, observer);
    observer.observe(scope.root, {
      childList: true,
      attributes: true,
      attributeOldValue: true,
      subtree: true,
    });
  }

  stop(scope: Scope): void {
    this.#observers.get(scope)?.disconnect();
    this.#observers.delete(scope);
  }

  /** What happened so far in this task, now: x3dom hears of it later. */
  takeRecords(): void {
    for (const [scope, observer] of this.#observers) {
      const records = observer.takeRecords();
      if (records.length > 0) this.#take(records, scope);
    }
  }

  #take(records: MutationRecord[], scope: Scope): void {
    for (const record of records) {
      if (!(record.target instanceof Element)) continue;
      if (record.type === 'attributes')
        this.#attribute(record.target, record.attributeName!, record.oldValue, scope);
      else this.#children(record.target, record, scope);
    }
  }

  #children(parent: Element, { addedNodes, removedNodes }: MutationRecord, scope: Scope): void {
    for (const node of removedNodes) {
      if (node instanceof Element && !scope.root.contains(node))
        this.#elements.disconnect(node, scope, parent);
      else if (node instanceof Element) this.#eachMoved(node);
    }
    for (const node of addedNodes) {
      if (node instanceof Element && scope.root.contains(node)) this.#elements.connect(node, scope);
    }
    if ([...addedNodes, ...removedNodes].some((node) => concerns(parent, node)))
      this.#touch(parent);
  }

  /** Taken out and put back within one task. */
  #eachMoved(root: Element): void {
    for (const element of subtree(root)) if (isPhysics(element)) this.#touch(element);
  }

  /** The children of an element changed, or it moved. */
  #touch(element: Element): void {
    const binding = isPhysics(element) ? ownBinding(element) : undefined;
    binding?.dirty();
    for (const reader of this.#readers.of(element)) reader.dirty();
  }

  #attribute(element: Element, name: string, oldValue: string | null, scope: Scope): void {
    const lower = name.toLowerCase();
    if (NAMING.has(lower)) return this.#renamed(element, scope);
    if (isPhysics(element)) return this.#physics(element, name, oldValue);
    const value = attribute(element, name);
    if (isTransform(element)) this.#transform(element, name, oldValue, value);
    else this.#touch(element);
    if (isInline(element) && lower === 'shared-world') this.#elements.requeueInline(element);
    // x3dom follows no attribute in a file of its own.
    if (fileOf(element) !== document && value !== null) nodeOf(element)?.updateField(name, value);
  }

  #renamed(element: Element, scope: Scope): void {
    this.#elements.renamed(element, scope);
    this.#touch(element);
    if (element.parentElement) this.#touch(element.parentElement);
  }

  /** Custom elements hear of the attributes of their fields themselves, at once; of all others they do not. */
  #physics(element: Element, name: string, oldValue: string | null): void {
    const binding = ownBinding(element);
    if (!binding) return;
    const heard = isUpgraded(element) && fieldsByAttribute(binding.type).has(name.toLowerCase());
    if (heard) return;
    if (attribute(element, name) === oldValue) binding.attributeRepeated(name);
    else binding.attributeChanged(name);
  }

  /**
   * x3dom follows an attribute only from one value to another, and later than this: told now, it hears nothing new then.
   */
  #transform(element: Element, name: string, oldValue: string | null, value: string | null): void {
    const lower = name.toLowerCase();
    const node = lower in PLACING ? nodeOf(element) : undefined;
    if (node && oldValue !== null) noteRead(node, lower, oldValue);
    if (value !== oldValue) node?.updateField(name, value ?? PLACING[lower]!);
  }
}

const isUpgraded = (element: Element): boolean => 'attributeChangedCallback' in element;

/** Of its children only some concern a collection; it may have thousands, and they come one by one. */
function concerns(parent: Element, child: Node): boolean {
  if (!(child instanceof Element)) return false;
  return (
    !isType(parent, 'RigidBodyCollection') ||
    (!isType(child, 'RigidBody') && !lowerName(child).endsWith('joint'))
  );
}
