export type Listener = (detail: unknown) => void;

interface Entry {
  readonly listener: Listener;
  gone: boolean;
}

/**
 * Listeners by event name, as in the DOM: one added while an event is told hears the next one, one removed hears no
 * more. A listener that throws is reported to the page, and the others still hear.
 */
export class Emitter {
  /** Lists are replaced, never changed, so that who walks one walks a copy. */
  #entries?: Map<string, readonly Entry[]>;

  /** The same listener twice is one. */
  on(event: string, listener: Listener): () => void {
    const before = this.#of(event);
    let entry = before.find((each) => each.listener === listener);
    if (!entry) this.#set(event, [...before, (entry = { listener, gone: false })]);
    return () => this.#remove(event, entry);
  }

  #remove(event: string, entry: Entry): void {
    if (entry.gone) return;
    entry.gone = true;
    this.#set(
      event,
      this.#of(event).filter((each) => each !== entry),
    );
  }

  #of(event: string): readonly Entry[] {
    return this.#entries?.get(event) ?? [];
  }

  #set(event: string, entries: readonly Entry[]): void {
    (this.#entries ??= new Map()).set(event, entries);
  }

  /** What is listened to. */
  get events(): string[] {
    return [...(this.#entries ?? [])].flatMap(([event, list]) => (list.length > 0 ? [event] : []));
  }

  heard(event: string): boolean {
    return (this.#entries?.get(event)?.length ?? 0) > 0;
  }

  emit(event: string, detail: unknown): void {
    const entries = this.#entries?.get(event);
    if (!entries) return;
    for (const entry of entries) {
      if (entry.gone) continue;
      try {
        entry.listener(detail);
      } catch (error) {
        queueMicrotask(() => {
          throw error;
        });
      }
    }
  }
}
