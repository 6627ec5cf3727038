// The first script of each measured page; the page around it asks `bench`.
import { adapters } from './adapters.js';
import { hold, install, listen, realNow, steadyFrame, type FrameCost } from './frames.js';
import { drawNothing } from './no-drawing.js';

const library = document.currentScript!.dataset.library!;
const adapter = adapters[library]!;

install();

/** What went wrong in this page, for who waits for it. */
const errors: string[] = [];
addEventListener('error', ({ message }) => errors.push(message));
addEventListener('unhandledrejection', ({ reason }) => errors.push(String(reason)));

/** With what the library tells of its physics itself. */
const told = (cost: FrameCost): FrameCost =>
  adapter.physics ? { ...cost, physics: adapter.physics() } : cost;

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
  firstMove: () => firstMove,
  hold,
  drawNothing,

  /** Frames in a row: their mean. */
  turn(count: number): FrameCost {
    const sum = { script: 0, physics: 0, gap: 0 };
    for (let i = 0; i < count; i++) {
      const { script, physics, gap } = told(steadyFrame());
      sum.script += script / count;
      sum.physics += physics / count;
      sum.gap += gap / count;
    }
    return sum;
  },

  /** The frames that the browser gives in so many seconds. */
  watch(seconds: number): Promise<FrameCost[]> {
    const costs: FrameCost[] = [];
    return new Promise((resolve) => {
      const end = realNow() + seconds * 1000;
      listen((cost) => {
        costs.push(told(cost));
        if (realNow() < end) return;
        listen(undefined);
        resolve(costs);
      });
    });
  },
};

/** Watches from the first frame on, until something has moved. */
listen(() => {
  if (firstMove === undefined) lookForMove();
});

export type Bench = typeof bench;
(window as any).bench = bench;
