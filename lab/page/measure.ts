import { estimate, median } from '../statistics.js';
import { MACHINE, today } from '../run/machine.js';
import type { Found, FramesFound, PageAt, ScriptFound, StartFound } from './asked.js';
import type { FrameCost } from './in-page/frames.js';
import type { BrowserPages, FrameRate, PageCell, ScriptCost } from './numbers.js';
import { addressOf, type MeasuredBrowser } from './pages.js';

/**
 * Steady frames before anything is measured, pairs of turns, and frames of a turn: the second and the third second of a
 * scene, in which 500 boxes come to lie.
 */
export const WARM_UP = 60;
export const TURNS = 30;
export const FRAMES = 4;
/** Milliseconds of script from which on a page is left out. */
const MOST = 2000;
/** Seconds of frames as the browser gives them. */
const [BEFORE, SECONDS] = [1, 2];
/** Pages that are opened one after the other, and those that are measured. */
const [UNCOUNTED, ROUNDS] = [1, 15];

const IN_SCRIPT = ['ours', 'ours-awake', 'ours-worker', 'ours-xhtml', 'x-ite', 'a-frame', 'ammo'];
const IN_FRAMES = ['ours', 'ours-worker', 'ours-xhtml', 'x-ite', 'a-frame'];
const AT_START = ['ours', 'ours-classic', 'ours-xhtml', 'x-ite', 'a-frame'];
/** Boxes of the scene that starts. */
const FEW = 10;

export const pageOf = (library: string, scene: string, count: number): PageAt => [
  library,
  addressOf({ library, scene, count }),
];

/** What was found, or why nothing was. */
export async function asked<T extends Found>(answer: Promise<Found>): Promise<T | string> {
  const found = await answer;
  return 'failed' in found ? found.failed : (found as T);
}

function costOf(turns: readonly FrameCost[], height: number | null, ours?: FrameCost[]) {
  const cost: ScriptCost = {
    script: estimate(turns.map(({ script }) => script)),
    physics: estimate(turns.map(({ physics }) => physics)),
    drawing: estimate(turns.map(({ script, physics }) => script - physics)),
    height,
  };
  if (ours) cost.ours = estimate(turns.map(({ script }, i) => ours[i]!.script / script));
  return cost;
}

async function scriptOf(browser: MeasuredBrowser, scene: string, count: number) {
  const pages = IN_SCRIPT.map((library) => pageOf(library, scene, count));
  const question = { pages, warmUp: WARM_UP, turns: TURNS, frames: FRAMES, most: MOST };
  const found = await asked<ScriptFound>(browser.ask({ kind: 'script', ...question }));
  return Object.fromEntries(
    IN_SCRIPT.map((side): [string, ScriptCost | string] => {
      if (typeof found === 'string') return [side, found];
      const turns = found.sides[side];
      if (!turns) return [side, `a frame takes more than ${MOST} ms`];
      const ours = side.startsWith('ours') ? undefined : found.sides.ours;
      return [side, costOf(turns, found.heights[side]!, ours)];
    }),
  );
}

function rateOf(frames: readonly FrameCost[]): FrameRate {
  const seconds = frames.reduce((sum, { gap }) => sum + gap, 0) / 1000;
  return {
    perSecond: frames.length / seconds,
    script: median(frames.map(({ script }) => script)),
    physics: median(frames.map(({ physics }) => physics)),
  };
}

async function framesOf(browser: MeasuredBrowser, scene: string, count: number) {
  const rates: PageCell['frames'] = {};
  for (const side of IN_FRAMES) {
    const question = { page: pageOf(side, scene, count), warmUp: BEFORE, seconds: SECONDS };
    const found = await asked<FramesFound>(browser.ask({ kind: 'frames', ...question }));
    rates[side] = typeof found === 'string' ? found : rateOf(found.frames);
  }
  return rates;
}

export const measureCell = async (
  browser: MeasuredBrowser,
  scene: string,
  count: number,
): Promise<PageCell> => ({
  scene,
  count,
  script: await scriptOf(browser, scene, count),
  frames: await framesOf(browser, scene, count),
});

/** Each library's page, opened again and again, in turns. */
export async function measureStart(browser: MeasuredBrowser): Promise<BrowserPages['start']> {
  const times: Record<string, number[]> = {};
  const failed: Record<string, string> = {};
  for (let round = 0; round < UNCOUNTED + ROUNDS; round++)
    for (const side of AT_START) {
      if (failed[side]) continue;
      const page = pageOf(side, 'falling', FEW);
      const found = await asked<StartFound>(browser.ask({ kind: 'start', page }));
      if (typeof found === 'string') failed[side] = found;
      else if (round >= UNCOUNTED) (times[side] ??= []).push(found.ms);
    }
  return Object.fromEntries(AT_START.map((side) => [side, failed[side] ?? estimate(times[side]!)]));
}

export const emptyPages = (): BrowserPages => ({
  version: '',
  machine: MACHINE,
  date: today(),
  cells: [],
  start: {},
});
