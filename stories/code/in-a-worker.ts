// What a page can do while many bodies fall: how its frames follow each other, and whose time the steps take.
type Collection = HTMLElementTagNameMap['x3d-rigid-body-collection'];

/** Milliseconds that figures are of. */
const LAST = 2000;
/** Milliseconds between two frames of a screen; what takes half as much again left out one. */
const FRAME = 1000 / 60;
/** Share of the boxes that are still awake when they are poured again. */
const AT_REST = 0.1;

const milliseconds = (value: number): string => `${value.toFixed(value < 10 ? 1 : 0)} ms`;

class Watched {
  readonly #main: Element;
  readonly #collection: Collection;
  #frames: { at: number; gap: number }[] = [];
  #told = 0;

  constructor(main: Element) {
    this.#main = main;
    this.#collection = main.querySelector('x3d-rigid-body-collection')!;
    // Another thread is taken when the world begins again.
    new MutationObserver(() => this.#collection.world?.reset()).observe(this.#collection, {
      attributeFilter: ['thread'],
    });
    requestAnimationFrame(this.#frame);
  }

  readonly #frame = (now: number): void => {
    if (!this.#main.isConnected) return;
    requestAnimationFrame(this.#frame);
    const last = this.#frames.at(-1)?.at ?? now;
    this.#frames = this.#frames.filter(({ at }) => at > now - LAST);
    this.#frames.push({ at: now, gap: now - last });
    if (now < this.#told + 500) return;
    this.#told = now;
    this.#tell();
  };

  #tell(): void {
    const { world } = this.#collection;
    if (!world) return;
    const { stats, mirrored } = world;
    const { step, read, write, events } = stats.ms;
    const isHere = mirrored === undefined;
    const gaps = this.#frames.map(({ gap }) => gap);
    const missed = gaps.reduce((sum, gap) => sum + Math.max(0, Math.round(gap / FRAME) - 1), 0);
    this.#write('thread', isHere ? 'this page' : 'a worker');
    this.#write('page', milliseconds(isHere ? step + read + write + events : write));
    this.#write('worker', isHere ? '–' : milliseconds(step + read + events));
    this.#write('missed', `${missed} of ${missed + gaps.length}`);
    this.#write('longest', milliseconds(Math.max(...gaps)));
    this.#write('awake', `${stats.awake} of ${stats.bodies - 1}`);
    if (world.time > 2 && stats.awake < AT_REST * stats.bodies) world.reset();
  }

  #write(name: string, text: string): void {
    this.#main.querySelector(`[data-value=${name}]`)!.textContent = text;
  }
}

const known = new WeakSet<Element>();

/** The world has started. */
export function watchPage(event: Event): void {
  const main = (event.currentTarget as Element).closest('main')!;
  if (known.has(main)) return;
  known.add(main);
  new Watched(main);
}
