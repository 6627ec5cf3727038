// Bundled for the page that a browser is opened at: shows the measured pages in frames, measures what it is asked for
// and tells what it found, until there is no more.
import type {
  Asked,
  EditsFound,
  Found,
  FramesFound,
  KeptFound,
  ScriptFound,
  StartFound,
} from '../asked.js';
import type { Bench } from './bench.js';
import type { FrameCost } from './frames.js';

/** Milliseconds that a scene may take to be there. */
const PATIENCE = 60_000;

const wait = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));

interface Shown {
  side: string;
  frame: HTMLIFrameElement;
  bench: Bench;
}

/** Opens a page, which is there when its library is. */
function open(address: string): HTMLIFrameElement {
  const frame = document.createElement('iframe');
  frame.src = address;
  document.body.append(frame);
  return frame;
}

const benchOf = (frame: HTMLIFrameElement): Bench | undefined =>
  (frame.contentWindow as any)?.bench as Bench | undefined;

async function until<T>(frame: HTMLIFrameElement, look: (bench: Bench) => T): Promise<T & {}> {
  for (const start = performance.now(); performance.now() - start < PATIENCE; await wait(20)) {
    const bench = benchOf(frame);
    const found = bench && look(bench);
    if (found) return found;
  }
  throw new Error(`not there in time; ${benchOf(frame)?.errors.join('; ')}`);
}

async function show(side: string, address: string): Promise<Shown> {
  const frame = open(address);
  const bench = await until(frame, (there) => there.ready() && there);
  return { side, frame, bench: bench as Bench };
}

/** Not in the tasks of each other. */
async function turn({ bench }: Shown, count: number): Promise<FrameCost> {
  const cost = await bench.turn(count);
  await wait(0);
  return cost;
}

/** Until the scene is under way; false where three frames in a row are beyond all patience. */
async function warm(shown: Shown, frames: number, most: number): Promise<boolean> {
  let late = 0;
  for (let i = 0; i < frames && late < 3; i++)
    late = (await turn(shown, 1)).script > most ? late + 1 : 0;
  return late < 3;
}

/** Steady frames of all pages in turns; nothing is drawn. All are measured in the same frames of the scene. */
async function script(asked: Asked<'script'>): Promise<ScriptFound> {
  const found: ScriptFound = { sides: {}, heights: {}, counts: {} };
  const all: Shown[] = [];
  for (const [side, address] of asked.pages) {
    const shown = await show(side, address);
    shown.bench.hold();
    shown.bench.drawNothing();
    if (await warm(shown, asked.warmUp, asked.most)) all.push(shown);
    else shown.frame.remove();
  }
  for (const { side } of all) found.sides[side] = [];
  for (let i = 0; i < asked.turns; i++)
    for (let k = 0; k < all.length; k++) {
      // None is always the first.
      const shown = all[(i + k) % all.length]!;
      found.sides[shown.side]!.push(await turn(shown, asked.frames));
    }
  for (const { side, bench } of all) {
    found.heights[side] = bench.height() ?? null;
    found.counts[side] = bench.count() ?? null;
  }
  return found;
}

/** The frames of one page as the browser gives them, drawn. */
async function frames({ page, warmUp, seconds }: Asked<'frames'>): Promise<FramesFound> {
  const { bench } = await show(page[0], page[1]);
  await bench.watch(warmUp);
  return { frames: await bench.watch(seconds) };
}

/** Steady frames of one page, in which a body is edited. */
async function edits({ page, warmUp, frames: count }: Asked<'edits'>): Promise<EditsFound> {
  const shown = await show(page[0], page[1]);
  const { bench } = shown;
  bench.hold();
  bench.drawNothing();
  for (let i = 0; i < warmUp; i++) await turn(shown, 1);
  bench.edit();
  for (let i = 0; i < count; i++) await turn(shown, 1);
  return { seen: bench.seen() };
}

/** Frames as the browser gives them, with nothing drawn, while a body is edited; or drawing alone. */
async function kept({ page, warmUp, seconds, alone }: Asked<'kept'>): Promise<KeptFound> {
  const { bench } = await show(page[0], page[1]);
  bench.drawNothing();
  if (alone) await bench.playBack(warmUp + seconds);
  else bench.edit();
  await bench.watch(warmUp);
  bench.seen();
  return { frames: await bench.watch(seconds), seen: bench.seen() };
}

/** Milliseconds from asking for a page to the first frame in which something has moved. */
async function start({ page }: Asked<'start'>): Promise<StartFound> {
  const frame = open(page[1]);
  return { ms: await until(frame, (bench) => bench.firstMove()) };
}

const KINDS = { script, frames, edits, kept, start };

async function answer(asked: Asked): Promise<Found> {
  try {
    return await (KINDS[asked.kind] as (asked: Asked) => Promise<Found>)(asked);
  } catch (error) {
    return { failed: String(error) };
  } finally {
    for (const frame of document.querySelectorAll('iframe')) frame.remove();
    await wait(200);
  }
}

async function main(): Promise<void> {
  for (;;) {
    const asked = (await (await fetch('/next')).json()) as Asked;
    await fetch('/found', { method: 'POST', body: JSON.stringify(await answer(asked)) });
  }
}

void main();
