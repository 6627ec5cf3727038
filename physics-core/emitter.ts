export type Listener = (detail: unknown) => void;

/** Listeners by event name. A listener that throws is reported to the page, and the others still hear. */
export class Emitter {
  #listeners?: Map<string, Set<Listener>>;

  on(event: string, listener: Listener): () => void {
    this.#listeners ??= new Map();
    const set = this.#listeners.get(event) ?? new Set();
    this.#listeners.set(event, set.add(listener));
    return () => {
      set.delete(listener);
    };
  }

  /** What is listened to. */
  get events(): string[] {
    return [...(this.#listeners ?? [])].flatMap(([event, set]) => (set.size > 0 ? [event] : []));
  }

  heard(event: string): boolean {
    return (this.#listeners?.get(event)?.size ?? 0) > 0;
  }

  emit(event: string, detail: unknown): void {
    const set = this.#listeners?.get(event);
    if (!set) return;
    for (const listener of set) {
      try {
        listener(detail);
      } catch (error) {
        queueMicrotask(() => {
          throw error;
        });
      }
    }
  }
}
