// npm run lab -- drawing: what it costs to draw many bodies, one by one, in one call and by three.js, in turns on one page;
// what one change costs; and scene 3 of the paper. It needs dist/ and Chromium, and no network. Numbers go into
// lab/report/drawing.json, tables and pictures into docs/drawing.md.
//   --part rows        only this part anew: rows, edits or room
//   --sizes 100,1000   these numbers of bodies or boxes only
//   --draw             measure nothing: tables and pictures of the numbers of last time
import { readFileSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { parseArgs } from 'node:util';
import { drawingPicture } from '../draw/drawing-chart.js';
import { roomPicture } from '../draw/room-chart.js';
import { MACHINE, today } from '../run/machine.js';
import { median } from '../run/median.js';
import type { Frames } from './in-page/turns.js';
import type { RoomFrames } from './in-page/room.js';
import { readDrawing, writeDrawing, type Cost, type Row, type RoomRow } from './numbers.js';
import { Pages } from './pages.js';
import { pageOf, roomOf } from './scene.js';
import { tablesOf } from './text.js';

const { values: options } = parseArgs({
  options: {
    part: { type: 'string' },
    sizes: { type: 'string' },
    draw: { type: 'boolean', default: false },
  },
});

const ROUNDS = 3;
const EDITS = 15;
const DOCS = new URL('../../docs/', import.meta.url);

const numbers = readDrawing();
const say = (line: string): void => void process.stderr.write(`${line}\n`);
const sizes = (all: number[]): number[] => options.sizes?.split(',').map(Number) ?? all;

const costOf = (turns: Frames[]): Cost => ({
  ms: median(turns.map(({ write, tick }) => write + tick)),
  calls: median(turns.map(({ calls }) => calls)),
});

async function rowOf(pages: Pages, bodies: number, stub: boolean): Promise<Row> {
  const { plain, batched, three } = await pages.measure(pageOf(bodies), 1, (page) =>
    page.evaluate(([none, rounds]) => window.measure.turns(none, rounds), [stub, ROUNDS] as const),
  );
  const webgl = stub ? 'none' : 'software';
  return { bodies, webgl, plain: costOf(plain), batched: costOf(batched), three: costOf(three) };
}

async function measureRows(pages: Pages): Promise<void> {
  numbers.rows = [];
  for (const bodies of sizes([100, 500, 1000, 2000, 5000]))
    for (const stub of [true, false]) {
      const row = await rowOf(pages, bodies, stub);
      numbers.rows.push(row);
      const { plain, batched, three } = row;
      say(
        `${bodies} bodies, WebGL ${row.webgl}: ${[plain, batched, three].map(({ ms }) => ms.toFixed(2)).join(', ')} ms, 1/${(plain.ms / batched.ms).toFixed(1)}`,
      );
    }
}

async function measureEdits(pages: Pages): Promise<void> {
  numbers.edits = [];
  for (const bodies of sizes([50, 1000])) {
    const ms = await pages.measure(pageOf(bodies), 1, (page) =>
      page.evaluate((times) => window.measure.changes(times), EDITS),
    );
    numbers.edits.push({ bodies, ms });
    say(`one of ${bodies} changed: ${JSON.stringify(ms)} ms`);
  }
}

const framesOf = (turns: RoomFrames[]): RoomFrames => ({
  physics: median(turns.map(({ physics }) => physics)),
  drawing: median(turns.map(({ drawing }) => drawing)),
  frame: median(turns.map(({ frame }) => frame)),
});

async function measureRoom(pages: Pages): Promise<void> {
  numbers.room = [];
  for (const boxes of sizes([10, 50, 100, 200, 500, 1000])) {
    const { plain, batched } = await pages.measure(roomOf(boxes), 1, (page) =>
      page.evaluate((rounds) => window.measure.room(rounds), ROUNDS),
    );
    const row: RoomRow = { boxes, plain: framesOf(plain), batched: framesOf(batched) };
    numbers.room.push(row);
    say(`${boxes} boxes: ${JSON.stringify(row)}`);
  }
}

const PARTS: Record<string, (pages: Pages) => Promise<void>> = {
  rows: measureRows,
  edits: measureEdits,
  room: measureRoom,
};

async function measure(): Promise<void> {
  const pages = await Pages.open();
  for (const part of options.part ? [options.part] : Object.keys(PARTS)) {
    await PARTS[part]!(pages);
    const load = loadavg()[0]!.toFixed(1);
    numbers.measured[part] = `${today()}: ${MACHINE}, Chromium, a load of ${load}`;
    writeDrawing(numbers);
  }
  await pages.close();
}

if (!options.draw) await measure();
writeFileSync(new URL('pictures/drawing.svg', DOCS), drawingPicture(numbers));
writeFileSync(new URL('pictures/drawing-room.svg', DOCS), roomPicture(numbers));
const page = new URL('drawing.md', DOCS);
const text = Object.entries(tablesOf(numbers)).reduce(
  (before, [name, table]) =>
    before.replace(
      new RegExp(`(?<=<!-- ${name} -->)[^]*(?=<!-- end of ${name} -->)`),
      () => `\n\n${table}\n\n`,
    ),
  readFileSync(page, 'utf8'),
);
writeFileSync(page, text);
