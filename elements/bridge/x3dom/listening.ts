import { nodeOf } from './x3dom.js';

// Nothing is computed for an event that nobody listens to. The platform does not tell who listens, and a listener
// at the document hears what bubbles from any element, so that it is not enough to look at our own elements: the
// methods of EventTarget itself are replaced, once. Calls with other names than ours pass straight through.

/** Events that cost something to find out or to send, and x3dom's own for the outputs of a node. */
const NAMES = new Set([
  'collisionstart',
  'collisionend',
  'jointlimit',
  'sleep',
  'wake',
  'waterenter',
  'waterleave',
  'beforestep',
  'afterstep',
  'outputchange',
]);

type Callback = EventListenerOrEventListenerObject;
type Options = boolean | AddEventListenerOptions | undefined;

interface Entry {
  callback: Callback | null;
  capture: boolean;
  /** Undoes what was added natively to hear when it ends. */
  end?: (() => void) | undefined;
}

const captures = (options: Options): boolean =>
  typeof options === 'object' && options !== null ? !!options.capture : !!options;

/** Who listens to our events, anywhere in the page. */
class Listening {
  readonly #entries = new WeakMap<EventTarget, Map<string, Entry[]>>();
  /** Names that somebody has ever listened to. */
  readonly #ever = new Set<string>();
  #native: Pick<EventTarget, 'addEventListener' | 'removeEventListener'> | undefined;
  /** Called when somebody begins or ceases to listen. */
  onchange: (target: EventTarget, name: string) => void = () => {};

  /** Begins to take notice; again does nothing. */
  begin(): void {
    if (this.#native) return;
    const { prototype } = EventTarget;
    const native = (this.#native = {
      addEventListener: prototype.addEventListener,
      removeEventListener: prototype.removeEventListener,
    });
    const { noteAdded, noteRemoved } = this;
    prototype.addEventListener = function (type, callback, options) {
      // Called as a bare function it means the window.
      const target = (this as EventTarget | undefined) ?? window;
      if (callback && NAMES.has(type)) noteAdded(target, type, callback, options);
      native.addEventListener.call(target, type, callback, options);
    };
    prototype.removeEventListener = function (type, callback, options) {
      const target = (this as EventTarget | undefined) ?? window;
      if (callback && NAMES.has(type)) noteRemoved(target, type, callback, options);
      native.removeEventListener.call(target, type, callback, options);
    };
    for (const name of earlyNames()) this.#put(window, name, { callback: null, capture: false });
  }

  /** Whether an event of this name, fired at `element`, would be heard by anybody. */
  heard(element: Element, name: string): boolean {
    if (!this.#ever.has(name)) return false;
    for (let at: EventTarget | null = element; at; at = next(at))
      if (this.#entries.get(at)?.has(name)) return true;
    return false;
  }

  /**
   * x3dom keeps copies of both methods on the elements that it reads. Those it made before ours came go past us, and
   * what was added through them stands in its own list.
   */
  adopt(root: Element): void {
    const native = this.#native!;
    for (const element of root.querySelectorAll('*')) {
      const own = element as Element & Record<string, unknown>;
      if (!Object.hasOwn(own, '__addEventListener')) continue;
      if (own.__addEventListener !== native.addEventListener) continue;
      own.__addEventListener = EventTarget.prototype.addEventListener;
      own.__removeEventListener = EventTarget.prototype.removeEventListener;
      for (const [name, callbacks] of Object.entries(nodeOf(element)?._listeners ?? {})) {
        if (!NAMES.has(name)) continue;
        for (const callback of callbacks)
          this.noteAdded(element, name, callback as Callback, undefined);
      }
    }
  }

  readonly noteAdded = (
    target: EventTarget,
    name: string,
    callback: Callback,
    options: Options,
  ): void => {
    const { once, signal } = (typeof options === 'object' && options) || {};
    const capture = captures(options);
    if (signal?.aborted || this.#find(target, name, callback, capture)) return;
    const entry: Entry = { callback, capture };
    const end = (): void => this.noteRemoved(target, name, callback, options);
    signal?.addEventListener('abort', end, { once: true });
    if (once) this.#native!.addEventListener.call(target, name, end, { capture, once });
    entry.end = (): void => {
      signal?.removeEventListener('abort', end);
      if (once) this.#native!.removeEventListener.call(target, name, end, capture);
    };
    this.#put(target, name, entry);
  };

  readonly noteRemoved = (
    target: EventTarget,
    name: string,
    callback: Callback,
    options: Options,
  ): void => {
    const entry = this.#find(target, name, callback, captures(options));
    const entries = entry && this.#entries.get(target)!.get(name)!;
    if (!entry || !entries) return;
    entry.end?.();
    entries.splice(entries.indexOf(entry), 1);
    if (entries.length > 0) return;
    this.#entries.get(target)!.delete(name);
    this.onchange(target, name);
  };

  #find(target: EventTarget, name: string, callback: Callback, capture: boolean) {
    const entries = this.#entries.get(target)?.get(name);
    return entries?.find((each) => each.callback === callback && each.capture === capture);
  }

  #put(target: EventTarget, name: string, entry: Entry): void {
    const names = this.#entries.get(target) ?? new Map<string, Entry[]>();
    this.#entries.set(target, names);
    const entries = names.get(name);
    if (entries) return void entries.push(entry);
    names.set(name, [entry]);
    this.#ever.add(name);
    this.onchange(target, name);
  }
}

/** The way of an event that bubbles and is composed. */
function next(target: EventTarget): EventTarget | null {
  if (target === document) return window;
  if (!(target instanceof Node)) return null;
  return target.parentNode ?? (target instanceof ShadowRoot ? target.host : null);
}

const CLASSIC = /^(|(text|application)\/(x-)?(java|ecma)script)$/i;

/**
 * Scripts that ran before this library may listen already, and nobody can ask. Those that stand in the page are looked
 * through for our names; a file that listens is to come after the library, or to import it.
 */
function earlyNames(): Set<string> {
  const names = new Set<string>();
  for (const { src, text, type } of document.scripts) {
    const mayListen = !src && (CLASSIC.test(type.trim()) || type === 'module');
    for (const name of NAMES) if (mayListen && text.includes(name)) names.add(name);
  }
  return names;
}

export const listening = new Listening();
