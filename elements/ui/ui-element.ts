import {
  adoptStyles,
  camel,
  keepInternals,
  setState,
  loadFailed,
  tellPage,
  worldShown,
} from '../bridge/index.js';
import { setAgain } from '../set-again.js';
import type { View, ViewModule } from './view.js';

// Servers that render pages may import this, too; they have no elements.
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

/** One attribute of an element of the ui, and the property that reflects it. */
export interface UIAttribute {
  name: string;
  type: string;
  default?: string;
  doc: string;
}

/** What the manifest, editor data and framework types say of an element of the ui. */
export interface UIDescription {
  doc: string;
  attributes: readonly UIAttribute[];
  /** Names for `::part()`. */
  parts: Readonly<Record<string, string>>;
}

/**
 * An element that shows something of a world. The class is light and in every build; what it shows comes with lit in a
 * chunk of its own when the first such element is in a page.
 */
export abstract class X3DUIElement extends Base {
  static readonly observedAttributes: readonly string[] = ['for'];

  #view: View | undefined;
  /** The view is there or on its way. */
  #asked = false;
  #running = false;
  #inSight = false;
  #sight: IntersectionObserver | undefined;

  constructor() {
    super();
    keepInternals(this);
  }

  /** What people call it in messages. @internal */
  protected abstract readonly label: string;
  /** Properties that pages set. @internal */
  protected get settable(): readonly string[] {
    return (this.constructor as typeof X3DUIElement).observedAttributes.map(camel);
  }

  /** @internal */
  protected abstract load(): Promise<ViewModule>;

  /** DEF or id of an `<x3d>`, a collection or any other physics element; without it the nearest `<x3d>` is meant. */
  get for(): string {
    return this.getAttribute('for') ?? '';
  }

  set for(name: string) {
    if (name) this.setAttribute('for', name);
    else this.removeAttribute('for');
  }

  /** The world it shows, as the page is now; it may come later, or be another one after an edit. @internal */
  get world() {
    return worldShown(this, this.for);
  }

  /** What a view looks like. */
  applyStyles(...texts: string[]): void {
    adoptStyles(this.shadowRoot!, ...texts);
  }

  connectedCallback(): void {
    setAgain(this, this.settable);
    this.#sight ??= new IntersectionObserver((entries) => {
      this.#inSight = entries.at(-1)!.isIntersecting;
      this.#turn();
    });
    this.#sight.observe(this);
    if (!this.#asked) void this.#load();
  }

  disconnectedCallback(): void {
    this.#sight?.disconnect();
    this.#inSight = this.#running = false;
    // Out of sight, too, work may be under way.
    this.#view?.stop();
  }

  attributeChangedCallback(_name: string, before: string | null, after: string | null): void {
    if (before !== after) this.changed();
  }

  /** What it is to show is another. @internal */
  protected changed(): void {
    this.#view?.changed();
  }

  async #load(): Promise<void> {
    this.#asked = true;
    // The height it will about have: an element without one would never come into sight.
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
    root.textContent = `Loading the ${this.label} …`;
    try {
      const { createView } = await this.load();
      root.textContent = '';
      this.#view = createView(this);
      setState(this, 'problem', false);
      this.#turn();
    } catch (error) {
      this.#asked = false;
      this.#tellMissing(root, error);
    }
  }

  #tellMissing(root: ShadowRoot, error: unknown): void {
    const problem = loadFailed('ui', `the ${this.label}`, error);
    const message = `${problem.message}; a classic script needs the folder ui beside it, and pages opened from disk load no modules`;
    root.textContent = message;
    tellPage({ ...problem, message }, this);
  }

  /** Starts or stops the view, as it is in sight or not. */
  #turn(): void {
    const run = this.#inSight && this.isConnected && this.#view !== undefined;
    if (run === this.#running) return;
    this.#running = run;
    if (run) this.#view!.start();
    else this.#view?.stop();
  }
}
