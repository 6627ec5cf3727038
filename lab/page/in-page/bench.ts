// What the page around each measured page asks of it.
import type { Adapter } from './adapter.js';
import { hold, install, listen, realNow, steadyFrame, type FrameCost } from './frames.js';
import { drawNothing } from './no-drawing.js';
import { playBack } from './play-back.js';
import { Probe } from './probe.js';

/** Of the library of this page. */
let adapter: Adapter;

/** What went wrong in this page, for who waits for it. */
const errors: string[] = [];

/** With what the library tells of its physics itself. */
const told = (cost: FrameCost): FrameCost =>
  adapter.physics ? { ...cost, physics: adapter.physics(cost) } : cost;

/** Until all is here that was asked of another thread: it counts in the next frame. */
async function answered(): Promise<void> {
  while (adapter.answered && !adapter.answered())
    await new Promise((resolve) => setTimeout(resolve, 0));
}

let probe: Probe | undefined;

/** Milliseconds after the page was asked for; undefined until something moves. */
let firstMove: number | undefined;
let start: number | undefined;

function lookForMove(): void {
  const height = adapter.height();
  start ??= height;
  if (height !== start) firstMove = realNow();
}

const bench = {
  errors,
  ready: () => adapter.ready(),
  height: () => adapter.height(),
  count: () => adapter.count?.(),
  firstMove: () => firstMove,
  hold,
  drawNothing,
  playBack,

  /** Frames in a row: their mean. */
  async turn(count: number): Promise<FrameCost> {
    const sum = { script: 0, physics: 0, tick: 0, gap: 0 };
    for (let i = 0; i < count; i++) {
      const { script, physics, tick, gap } = told(steadyFrame());
      sum.script += script / count;
      sum.physics += physics / count;
      sum.tick += tick / count;
      sum.gap += gap / count;
      probe?.look(gap);
      if (adapter.answered) await answered();
    }
    return sum;
  },

  /** From now on a body is edited again and again, while frames are watched. */
  edit(): void {
    probe = new Probe();
  },

  /** How late that was seen since it was asked last. */
  seen: () => probe?.seen.splice(0) ?? [],

  /** The frames that the browser gives in so many seconds. */
  watch(seconds: number): Promise<FrameCost[]> {
    const costs: FrameCost[] = [];
    return new Promise((resolve) => {
      const end = realNow() + seconds * 1000;
      listen((cost) => {
        costs.push(told(cost));
        probe?.look(cost.gap);
        if (realNow() < end) return;
        listen(undefined);
        resolve(costs);
      });
    });
  },
};

export type Bench = typeof bench;

/** Frames and the clock are ours from now on: before any other script of the page. */
export function begin(library: Adapter): void {
  adapter = library;
  install();
  addEventListener('error', ({ message }) => errors.push(message));
  addEventListener('unhandledrejection', ({ reason }) => errors.push(String(reason)));
  // From the first frame on, until something has moved.
  listen(() => {
    if (firstMove === undefined) lookForMove();
  });
  (window as any).bench = bench;
}

/** As the tag of this script names it. */
export const libraryHere = (): string => document.currentScript!.dataset.library!;
