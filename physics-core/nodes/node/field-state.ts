import type { Value } from '../../fields/types.js';

/** What is asked of the fields of one node. */
export class FieldState {
  /** The values last asked for; a field that is not here has its default. */
  readonly asked = new Map<string, Value>();
  /** The fields that the author wrote, in markup or since. */
  readonly authored = new Set<string>();
  /** What the author had asked for where an event has come since; undefined: nothing. */
  readonly beforeEvent = new Map<string, Value | undefined>();

  /** Fields of which the author knows that an equal value is no edit. */
  readonly toldUnchanged = new Set<string>();

  /** The fields whose last value was not used as it was given: a problem tells so. */
  readonly refused = new Set<string>();

  /** Takes all of another's words. */
  take(other: FieldState): void {
    this.clear();
    for (const [name, value] of other.asked) this.asked.set(name, value);
    for (const name of other.authored) this.authored.add(name);
    for (const [name, value] of other.beforeEvent) this.beforeEvent.set(name, value);
  }

  clear(): void {
    this.asked.clear();
    this.authored.clear();
    this.beforeEvent.clear();
    this.refused.clear();
  }
}
