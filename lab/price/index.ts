// npm run lab -- price: what a step costs, beside other engines with the same step, and what it leaves.
//   --scene <id>     only this scene (poured stands for all of poured-*)
//   --level <name>   only this level
//   --turns <n>      turns of each engine, each a tenth of a second of the scene (20)
//   --keep           put what is measured into lab/report/price.json, and draw docs/price.md and its picture anew
//   --draw           measure nothing: page and picture of the numbers of last time
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { pricePicture } from '../draw/price-chart.js';
import { columnsOf } from '../draw/table.js';
import { progress } from '../run/progress.js';
import { levelNames } from './engines.js';
import { measureCell } from './measure.js';
import { readPrice, withCell, writePrice } from './numbers.js';
import type { PriceScene } from './scene.js';
import { priceScenes } from './scenes/index.js';
import { cellTable } from './tables.js';
import { withPrice } from './text.js';

const { values: options } = parseArgs({
  options: {
    scene: { type: 'string' },
    level: { type: 'string' },
    turns: { type: 'string', default: '20' },
    keep: { type: 'boolean', default: false },
    draw: { type: 'boolean', default: false },
  },
});

/** Below, an interval says little. */
const LEAST_TURNS = 15;

const TEXT = new URL('../../docs/price.md', import.meta.url);
const PICTURE = new URL('../../docs/pictures/price.svg', import.meta.url);

const { scene: name, level: only } = options;
const turns = Number(options.turns);
const chosen = priceScenes.filter(({ id }) => !name || id === name || id.startsWith(`${name}-`));
const levels = levelNames.filter((level) => !only || level === only);
if (chosen.length === 0 || levels.length === 0) throw new Error('no such scene or level');
if (options.keep && !(turns >= LEAST_TURNS))
  throw new Error(`what is kept stands on at least ${LEAST_TURNS} turns`);

/** A level that is asked for is measured, however long it takes. */
const reaches = ({ finest }: PriceScene, level: string): boolean =>
  !finest || Boolean(only) || levelNames.indexOf(level) <= levelNames.indexOf(finest);

async function measure(scene: PriceScene, level: string): Promise<void> {
  const start = performance.now();
  const cell = await measureCell(scene, level, turns, (doing) =>
    progress(`${scene.id}, ${level}: ${doing}`),
  );
  progress('');
  const { head, rows } = cellTable(cell);
  const seconds = ((performance.now() - start) / 1000).toFixed(0);
  console.log(`\n${scene.name}: ${cell.bodies} bodies, ${cell.joints} joints, in ${seconds} s`);
  console.log(columnsOf([head, ...rows], 1));
  if (options.keep) writePrice(withCell(readPrice(), cell));
}

/** The cheap ones of all scenes first. */
async function measureAll(): Promise<void> {
  for (const level of levels)
    for (const scene of chosen) if (reaches(scene, level)) await measure(scene, level);
}

function draw(): void {
  const numbers = readPrice();
  writeFileSync(PICTURE, pricePicture(numbers));
  writeFileSync(TEXT, withPrice(readFileSync(TEXT, 'utf8'), numbers));
}

if (!options.draw) await measureAll();
if (options.draw || options.keep) draw();
