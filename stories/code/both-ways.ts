// Bodies drawn one by one or in few calls: switches, and tells what a frame of each costs.
interface Canvas {
  tick(...args: unknown[]): void;
  doc: { needRender: boolean; ctx: { numDrawCalls: number } };
}

type Collection = HTMLElementTagNameMap['x3d-rigid-body-collection'];
type Stats = NonNullable<Collection['world']>['stats'] & { batches?: number; drawsSaved?: number };
type Body = HTMLElementTagNameMap['x3d-rigid-body'];

/** Where the ball begins. */
const START = [6.5, 1.5, 13];

/** Frames that a figure is the median of. */
const FRAMES = 9;

const median = (values: number[]): number => [...values].sort((a, b) => a - b)[values.length >> 1]!;
const milliseconds = (value: number): string => `${value.toFixed(value < 10 ? 1 : 0)} ms`;

class BothWays {
  readonly #main: Element;
  readonly #canvas: Canvas;
  readonly #collection: Collection;
  #script: number[] = [];

  constructor(main: Element) {
    this.#main = main;
    this.#collection = main.querySelector<Collection>('x3d-rigid-body-collection')!;
    const x3d = main.querySelector('x3d') as Element & { runtime: { canvas: Canvas } };
    this.#canvas = x3d.runtime.canvas;
    this.#hearFrames(this.#canvas);
    this.begin();
  }

  get #way(): 'plain' | 'batched' {
    return this.#collection.getAttribute('batch') === 'false' ? 'plain' : 'batched';
  }

  /** Some frames by the way that is set now, even if nothing moves. */
  begin(): void {
    this.#script = [];
    this.#canvas.doc.needRender = true;
  }

  #hearFrames(canvas: Canvas): void {
    const { tick } = canvas;
    canvas.tick = (...args) => {
      const draws = canvas.doc.needRender;
      const start = performance.now();
      tick.apply(canvas, args);
      if (draws) this.#drawn(performance.now() - start);
    };
  }

  #drawn(tick: number): void {
    const { doc } = this.#canvas;
    const stats: Stats | undefined = this.#collection.world?.stats;
    // Who looks like whom is found out in the first frame, by code that comes with the first eight bodies.
    const ready = stats?.batches !== undefined && stats.batches > 0 === (this.#way === 'batched');
    if (ready) this.#script.push(stats.ms.write + tick);
    if (this.#script.length < FRAMES) doc.needRender = true;
    else this.#tell(stats!);
  }

  #tell({ ms, batches, drawsSaved }: Stats): void {
    const write = (name: string, text: string): void => {
      this.#main.querySelector(`[data-value="${name}"]`)!.textContent = text;
    };
    write(`${this.#way} script`, milliseconds(median(this.#script)));
    write(`${this.#way} draws`, String(this.#canvas.doc.ctx.numDrawCalls));
    write('physics', milliseconds(ms.step));
    write('batches', `${batches}, which save ${drawsSaved} draws`);
    this.#script = [];
  }
}

const shown = new WeakMap<Element, BothWays>();
const mainOf = (event: Event): Element => (event.currentTarget as Element).closest('main')!;

/** The world has started. */
export function watchFrames(event: Event): void {
  const main = mainOf(event);
  shown.set(main, new BothWays(main));
}

export function switchWay(event: Event): void {
  const main = mainOf(event);
  const { checked } = event.currentTarget as HTMLInputElement;
  const collection = main.querySelector('x3d-rigid-body-collection')!;
  collection.toggleAttribute('batch', !checked);
  if (!checked) collection.setAttribute('batch', 'false');
  shown.get(main)?.begin();
}

/** At the pyramid, from its place before it. */
export function throwBall(event: Event): void {
  const ball = mainOf(event).querySelector<Body>('#ball')!;
  ball.teleport(START);
  ball.linearVelocity = [0, 3, -20];
}
