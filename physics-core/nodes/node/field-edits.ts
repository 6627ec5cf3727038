import type { Value } from '../../fields/types.js';
import { codecs } from '../../fields/values.js';
import { accept, takesEvents, writable } from './accept.js';
import type { FieldOwner } from './field-owner.js';
import type { FieldState } from './field-state.js';
import { fieldName, type Field } from './table.js';
import { tellUnchanged } from './unchanged.js';

/** A node whose fields are edited. */
export interface EditedNode extends FieldOwner {
  readonly built: boolean;
  /** Nodes that live in its fields. */
  readonly children: { adopt(name: string, field: Field, value: Value): Value };
  defaultOf(name: string): Value;
  /** Whether an edit of a field waits to be applied. */
  waits(name: string): boolean;
  /** Its author or an event changed a field. */
  edited(name: string): void;
}

/** What authors and events say of the fields of one node. */
export class FieldEdits {
  readonly #node: EditedNode;

  constructor(node: EditedNode) {
    this.#node = node;
  }

  set(spelling: string, value: unknown, text: unknown): void {
    const node = this.#node;
    const name = fieldName(node.type, spelling);
    const field = writable(node, name);
    if (!field) return;
    if (field.access === 'inputOnly') {
      this.event(name, value);
      return;
    }
    const accepted = accept(node, name, field, value, text);
    if (accepted === undefined) return;
    const { authored, beforeEvent } = node.fieldState;
    const same = codecs[field.type].equal(accepted, this.#lastAsked(name));
    if (same && (authored.has(name) || field.read)) {
      authored.add(name);
      if (node.built && !node.waits(name)) tellUnchanged(node, name, field, accepted);
      return;
    }
    beforeEvent.delete(name);
    this.#take(name, accepted);
  }

  /** The author's last word: what events did since does not make the same word an edit. */
  #lastAsked(name: string): Value {
    const { beforeEvent } = this.#node.fieldState;
    if (!beforeEvent.has(name)) return this.#node.asked(name);
    return beforeEvent.get(name) ?? this.#node.defaultOf(name);
  }

  event(spelling: string, value: unknown): void {
    const node = this.#node;
    const name = fieldName(node.type, spelling);
    const field = writable(node, name);
    if (!field || !takesEvents(node, name, field)) return;
    const accepted = accept(node, name, field, value, value);
    if (accepted === undefined) return;
    const { authored, beforeEvent } = node.fieldState;
    if (!beforeEvent.has(name))
      beforeEvent.set(name, authored.has(name) ? node.asked(name) : undefined);
    this.#take(name, accepted);
  }

  unset(spelling: string): void {
    const node = this.#node;
    const name = fieldName(node.type, spelling);
    const field = node.type.fields[name];
    if (!field) return;
    const { asked, authored, beforeEvent, refused } = node.fieldState;
    node.settle(name);
    refused.delete(name);
    beforeEvent.delete(name);
    if (!authored.delete(name)) return;
    asked.delete(name);
    node.children.adopt(name, field, node.defaultOf(name));
    node.edited(name);
  }

  load(state: FieldState): void {
    const { type, children, fieldState } = this.#node;
    for (const [name, value] of state.asked) {
      const field = type.fields[name]!;
      if (field.nodes) state.asked.set(name, children.adopt(name, field, value));
    }
    fieldState.take(state);
  }

  forgetEvents(): void {
    const { beforeEvent } = this.#node.fieldState;
    for (const [name, said] of beforeEvent) {
      if (said === undefined) this.unset(name);
      else this.#take(name, said);
    }
    beforeEvent.clear();
  }

  #take(name: string, value: Value): void {
    const { type, children, fieldState } = this.#node;
    if (!fieldState.refused.has(name)) this.#node.settle(name);
    fieldState.asked.set(name, children.adopt(name, type.fields[name]!, value));
    fieldState.authored.add(name);
    this.#node.edited(name);
  }
}
