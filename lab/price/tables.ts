import { percent, quantity, stepOf, threeDigits } from '../draw/numbers.js';
import type { Table } from '../draw/table.js';
import { engines, levelNames } from './engines.js';
import type { Errors } from './errors.js';
import type { PriceCell, Side } from './measure.js';
import { cellOf, type PriceNumbers } from './numbers.js';
import type { PriceScene } from './scene.js';
import { priceScenes } from './scenes/index.js';

const OTHERS = engines.filter(({ id }) => id !== 'ours');
const BESIDE_AMMO = OTHERS.filter(({ id }) => id !== 'ammo');

/** The level at whose step others stand in tables and pictures of what is left. */
export const COMPARED = 'standard';

export function sideOf(cell: PriceCell | undefined, engine: string): Side | undefined {
  const side = cell?.sides[engine];
  return typeof side === 'string' ? undefined : side;
}

/** What an engine lacks, or nothing where nothing was measured. */
const lacking = (cell: PriceCell, engine: string): string =>
  typeof cell.sides[engine] === 'string' ? `no ${cell.sides[engine]}` : '–';

const within = (value: number, { low, high }: { low: number; high: number }): string =>
  `${threeDigits(value)} (${threeDigits(low)} – ${threeDigits(high)})`;

const medianToAmmo = (cell: PriceCell, engine: string): string => {
  const ratio = sideOf(cell, engine)?.toAmmo;
  return ratio ? within(ratio.median.median, ratio.median) : lacking(cell, engine);
};

const meanToAmmo = (cell: PriceCell, engine: string): string => {
  const ratio = sideOf(cell, engine)?.toAmmo;
  return ratio ? within(ratio.mean.mean, ratio.mean) : lacking(cell, engine);
};

/** Less than this is what numbers of single precision leave. */
const NO_ENERGY = 1e-5;

const energyOf = ({ energy }: Errors): string =>
  energy === null ? '–' : percent(energy < NO_ENERGY ? 0 : energy);

/** Cells of a level, with their scenes. */
export const cellsAt = (numbers: PriceNumbers, level: string): [PriceScene, PriceCell][] =>
  priceScenes.flatMap((scene) => {
    const cell = cellOf(numbers, scene.id, level);
    return cell ? [[scene, cell]] : [];
  });

const levelsIn = (numbers: PriceNumbers): string[] =>
  levelNames.filter((level) => cellsAt(numbers, level).length > 0);

/** Steps of all engines at one level, to Ammo's. */
export const costTable = (numbers: PriceNumbers, level: string): Table => ({
  head: [
    'scene',
    'Ammo, ms',
    'ours : Ammo, median',
    'mean',
    ...BESIDE_AMMO.map(({ name }) => `${name} : Ammo, median`),
  ],
  rows: cellsAt(numbers, level).map(([{ name }, cell]) => [
    name,
    threeDigits(sideOf(cell, 'ammo')?.median ?? NaN),
    medianToAmmo(cell, 'ours'),
    meanToAmmo(cell, 'ours'),
    ...BESIDE_AMMO.map(({ id }) => medianToAmmo(cell, id)),
  ]),
});

/** The first and the worst other step of all engines at one level, to their own medians. */
export const hitchTable = (numbers: PriceNumbers, level: string): Table => ({
  head: [
    'scene',
    ...['first', 'worst'].flatMap((which) => engines.map(({ name }) => `${which}: ${name}`)),
  ],
  rows: cellsAt(numbers, level).map(([{ name }, cell]) => [
    name,
    ...(['first', 'worst'] as const).flatMap((which) =>
      engines.map(({ id }) => {
        const side = sideOf(cell, id);
        return side ? threeDigits(side[which] / side.median) : '–';
      }),
    ),
  ]),
});

/** A number of what is left, ours at all levels and that of others at the step of one. */
function leftTable(
  numbers: PriceNumbers,
  scenes: readonly PriceScene[],
  shown: (scene: PriceScene, side: Side) => string,
): Table {
  const levels = levelsIn(numbers);
  const at = (scene: PriceScene, level: string, engine: string): string => {
    const side = sideOf(cellOf(numbers, scene.id, level), engine);
    return side ? shown(scene, side) : '–';
  };
  return {
    head: ['scene', ...levels, ...OTHERS.map(({ name }) => name)],
    rows: scenes.map((scene) => [
      scene.name,
      ...levels.map((level) => at(scene, level, 'ours')),
      ...OTHERS.map(({ id }) => at(scene, COMPARED, id)),
    ]),
  };
}

export const errorTable = (numbers: PriceNumbers, judged: PriceScene['judged']): Table =>
  leftTable(
    numbers,
    priceScenes.filter((scene) => scene.judged === judged),
    (_, { errors }) => quantity(errors[judged], 'm'),
  );

export const energyTable = (numbers: PriceNumbers): Table =>
  leftTable(
    numbers,
    priceScenes.filter(({ driven }) => !driven),
    (_, { errors }) => energyOf(errors),
  );

/** One cell, for people who wait for it. */
export const cellTable = ({ level, step, sides }: PriceCell): Table => ({
  head: [
    `${level}, ${stepOf(step)}`,
    'ms',
    'mean',
    'first',
    'worst',
    'to Ammo',
    'mean',
    'overlap',
    'gap',
    'energy',
  ],
  rows: Object.entries(sides).map(([engine, side]) =>
    typeof side === 'string'
      ? [engine, `no ${side}`, ...Array<string>(8).fill('')]
      : [
          engine,
          ...[side.median, side.mean, side.first, side.worst].map(threeDigits),
          side.toAmmo ? within(side.toAmmo.median.median, side.toAmmo.median) : '',
          side.toAmmo ? within(side.toAmmo.mean.mean, side.toAmmo.mean) : '',
          quantity(side.errors.overlap, 'm'),
          quantity(side.errors.gap, 'm'),
          energyOf(side.errors),
        ],
  ),
});
