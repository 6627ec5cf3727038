import type { Emitter } from './emitter.js';

// What a world tells its listeners, and when.
//
// Nobody is told anything in the middle of the world's own work. What a step, an edit or a call brings about is queued
// and told when that is completely over: Bullet has stepped, poses are read, effects have settled, edits are applied.
// It is told in the order in which it came about. A step so goes: `beforestep`; pending edits, Bullet, effects; all
// that these brought about; `afterstep`.
//
// A listener may do anything: edit, remove nodes, listen or cease to, reset(), restore(), destroy().
// - What it does in `beforestep` acts in that very step, in any other listener before the next one.
// - What it brings about is told after what came about before.
// - step() within a step does nothing.
// - Of a node that was removed meanwhile, what it did in the step is told all the same, and then the ends of its
//   collisions.
// - reset(), restore() and destroy() make void what is not told yet, so that nothing of the old run acts on the new
//   one: who was not told of a beginning is not told of its end, and who was is. Their step has no `afterstep`.
// - Problems are always told.

/** What lasts, and the event that says its end. A sensor's isActive says both. */
const ENDS: Record<string, string> = {
  collisionstart: 'collisionend',
  sleep: 'wake',
  isActive: 'isActive',
};
const BEGINNINGS: Record<string, string> = { collisionend: 'collisionstart', wake: 'sleep' };

/** What is of its step only. */
const PASSING = ['jointlimit', 'intersections', 'contacts'];

interface Entry {
  readonly emitter: Emitter;
  readonly event: string;
  readonly detail: unknown;
  void: boolean;
}

/** Keeps what is asked for by methods. */
interface Keeper {
  keep<T>(who: object, method: string, args: readonly unknown[], work: () => T): T;
  /** Somebody began or ceased to listen. */
  listened?(who: object, event: string): void;
}

/** Events on their way to listeners; the order and what a listener may do stand above. */
export class EventQueue {
  readonly #entries: Entry[] = [];
  /** The first that is not told yet. */
  #next = 0;
  /** Is told what is asked for, while somebody keeps it, and does it. */
  keeper: Keeper | undefined;
  /** What nodes bring about here is no news: the world runs elsewhere, and they tell what it says. */
  silent = false;
  /** How much work is under way. */
  #held = 0;
  /** How often somebody outside has much to do, besides. */
  #delays = 0;
  #delivering = false;

  /** Whether anything is to be told. */
  get waiting(): boolean {
    return this.#next < this.#entries.length;
  }

  /** Work begins: until it is over nobody is told anything. */
  hold(): void {
    this.#held++;
  }

  /** Work is over. Within a listener the others that wait come after it. */
  release(): void {
    this.#held--;
    if (!this.#delivering) this.deliver();
  }

  /** Somebody outside has much to do: until he is done nobody is told anything. */
  delay(): void {
    this.#delays++;
    this.hold();
  }

  /** He is done. */
  proceed(): void {
    this.#delays--;
    this.release();
  }

  /** Does some work as a whole. */
  during<T>(work: () => T): T {
    this.hold();
    try {
      return work();
    } finally {
      this.release();
    }
  }

  /** Does as a whole what `who` is asked for by a method; asked from outside, and not by the work under way, it is kept. */
  call<T>(who: object, method: string, args: readonly unknown[], work: () => T): T {
    const { keeper } = this;
    if (!keeper || this.#held > this.#delays) return this.during(work);
    return keeper.keep(who, method, args, () => this.during(work));
  }

  listened(who: object, event: string): void {
    this.keeper?.listened?.(who, event);
  }

  /** The world begins anew, or ends: what came about before and is not told yet is void. */
  anew(work: () => void): void {
    this.during(() => {
      const before = this.#entries.length;
      work();
      this.#withdraw(before);
    });
  }

  /** Nothing is queued for nobody. Who is told of an end may have to know whether its beginning was told. */
  tell(emitter: Emitter, event: string, detail: unknown): void {
    const beginning = BEGINNINGS[event];
    if (!emitter.heard(event) && !(beginning && emitter.heard(beginning))) return;
    this.#entries.push({ emitter, event, detail, void: false });
    if (!this.#delivering) this.deliver();
  }

  /** Tells all that waits, unless work is under way. */
  deliver(): void {
    const within = this.#delivering;
    this.#delivering = true;
    while (this.waiting && this.#held === 0) {
      const entry = this.#entries[this.#next++]!;
      if (!entry.void) entry.emitter.emit(entry.event, entry.detail);
    }
    this.#delivering = within;
    if (this.waiting) return;
    this.#entries.length = 0;
    this.#next = 0;
  }

  #withdraw(before: number): void {
    for (let i = this.#next; i < before; i++) {
      const entry = this.#entries[i]!;
      if (PASSING.includes(entry.event)) entry.void = true;
      if (entry.void || !(entry.event in ENDS) || entry.detail === false) continue;
      const end = this.#entries.findIndex((later, at) => at > i && isEnd(later, entry));
      // Without an end it still holds: a body that slept sleeps in a restored world, too.
      if (end >= 0) this.#entries[end]!.void = entry.void = true;
    }
  }
}

function isEnd(later: Entry, { emitter, event, detail }: Entry): boolean {
  return (
    !later.void &&
    later.emitter === emitter &&
    later.event === ENDS[event] &&
    later.detail !== true &&
    otherIn(later.detail) === otherIn(detail)
  );
}

/** Of a collision. */
const otherIn = (detail: unknown): unknown => (detail as { other?: unknown }).other;
