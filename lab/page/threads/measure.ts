import { loadavg } from 'node:os';
import { today } from '../../run/machine.js';
import { estimate, median, ninetyFive } from '../../statistics.js';
import type { EditsFound, KeptFound, ScriptFound } from '../asked.js';
import type { FrameCost } from '../in-page/frames.js';
import type { Seen } from '../in-page/probe.js';
import { asked, pageOf, WARM_UP } from '../measure.js';
import type { MeasuredBrowser } from '../pages.js';
import type { Late, Spread, ThreadCell, ThreadSide } from './numbers.js';

/** Boxes of scene 3. */
export const COUNTS = [10, 30, 100, 300, 1000, 2000];
/** Frames of each page that are measured, in turns: two seconds of the scene. */
export const FRAMES = 120;
/** Pages that are opened to see which frames they keep, and seconds of each before that and of it. */
const ROUNDS = 3;
const [BEFORE, SECONDS] = [1, 2];
/** Steady frames before the first edit. */
const EDITS_AFTER = 6;
/** Frames of a second that browsers give a page that has time. */
const RATE = 60;
/** Milliseconds of script from which on a page is left out. */
const MOST = 2000;

const SIDES = { main: 'ours', worker: 'ours-worker' } as const;

const spread = (values: readonly number[]): Spread => ({
  ...estimate(values),
  most: ninetyFive(values),
});

/** Frames of both, in turns, in which nothing is drawn. */
async function scriptOf(browser: MeasuredBrowser, count: number): Promise<ScriptFound> {
  const found = await asked<ScriptFound>(
    browser.ask({
      kind: 'script',
      pages: Object.values(SIDES).map((side) => pageOf(side, 'boxes', count)),
      warmUp: WARM_UP,
      turns: FRAMES,
      frames: 1,
      most: MOST,
    }),
  );
  if (typeof found === 'string') throw new Error(found);
  return found;
}

/** Steady frames with edits. */
async function editsOf(browser: MeasuredBrowser, side: string, count: number): Promise<Seen[]> {
  const question = { page: pageOf(side, 'boxes', count), warmUp: EDITS_AFTER, frames: FRAMES };
  const found = await asked<EditsFound>(browser.ask({ kind: 'edits', ...question }));
  if (typeof found === 'string') throw new Error(found);
  return found.seen;
}

async function keptOf(browser: MeasuredBrowser, side: string, count: number, alone = false) {
  const page = pageOf(side, 'boxes', count);
  const question = { page, warmUp: BEFORE, seconds: SECONDS, alone };
  const found = await asked<KeptFound>(browser.ask({ kind: 'kept', ...question }));
  if (typeof found === 'string') throw new Error(found);
  return found;
}

/** Of all frames that there was time for. */
function shareKept(rounds: readonly KeptFound[]): number {
  const frames = rounds.flatMap(({ frames: of }) => of);
  const seconds = frames.reduce((sum, { gap }) => sum + gap, 0) / 1000;
  return Math.min(1, frames.length / (seconds * RATE));
}

const lateOf = (seen: readonly Seen[]): Late => {
  const frames = seen.map(({ frame }) => frame);
  const behind = seen.map((one) => one.behind);
  return {
    edits: seen.length,
    frame: { median: median(frames), most: ninetyFive(frames) },
    behind: { median: median(behind), most: ninetyFive(behind) },
  };
};

const ownOf = ({ script, tick }: FrameCost): number => script - tick;

const sideOf = (
  costs: readonly FrameCost[],
  steady: readonly Seen[],
  rounds: readonly KeptFound[],
): ThreadSide => ({
  own: spread(costs.map(ownOf)),
  drawing: spread(costs.map(({ tick }) => tick)),
  kept: shareKept(rounds),
  steady: lateOf(steady),
  late: lateOf(rounds.flatMap(({ seen }) => seen)),
});

export async function measureCell(browser: MeasuredBrowser, count: number): Promise<ThreadCell> {
  const { sides } = await scriptOf(browser, count);
  const [main, worker] = [sides[SIDES.main]!, sides[SIDES.worker]!];
  const rounds = { main: [] as KeptFound[], worker: [] as KeptFound[], alone: [] as KeptFound[] };
  for (let i = 0; i < ROUNDS; i++) {
    rounds.main.push(await keptOf(browser, SIDES.main, count));
    rounds.worker.push(await keptOf(browser, SIDES.worker, count));
    rounds.alone.push(await keptOf(browser, SIDES.main, count, true));
  }
  return {
    count,
    date: today(),
    load: loadavg()[0]!,
    main: sideOf(main, await editsOf(browser, SIDES.main, count), rounds.main),
    worker: sideOf(worker, await editsOf(browser, SIDES.worker, count), rounds.worker),
    ratio: estimate(worker.map((cost, i) => ownOf(cost) / ownOf(main[i]!))),
    alone: shareKept(rounds.alone),
  };
}
