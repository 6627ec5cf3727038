import type { Case } from '../case.js';
import { casesNamed } from '../cases/index.js';
import { quantity, threeDigits } from '../draw/numbers.js';
import type { Table } from '../draw/table.js';
import type { Row } from '../run/row.js';
import type { ContactCost } from './cost.js';

/** Cases of what touches, in the order of the page. */
export const contactCases: readonly Case[] = [
  'stack',
  'house-of-cards',
  'slope-block-stays',
  'roll-cylinders',
  'carried',
  'hit-oblique',
  'hit-oblique-rough',
].flatMap((name) => [...casesNamed(name)]);

/** Others at the step of `standard`, with the iterations that they have by themselves. */
const OTHERS: [name: string, engine: string, iterations: number][] = [
  ['raw Ammo', 'ammo', 10],
  ['Jolt', 'jolt', 10],
  ['Rapier', 'rapier', 4],
  ['cannon-es', 'cannon', 10],
];
const STEP = 1 / 120;
const LEVELS = ['game', 'standard', 'fine', 'reference'];

/** Errors at our levels, and of others at the step of `standard`. */
export function contactErrors(rows: readonly Row[]): Table {
  const shown = (which: Case, is: (row: Row) => boolean): string => {
    const row = rows.find((one) => one.case === which.id && is(one));
    return row ? quantity(row.error, which.unit) : '–';
  };
  return {
    head: ['case', ...LEVELS, ...OTHERS.map(([name]) => name)],
    rows: contactCases.map((which) => [
      which.name,
      ...LEVELS.map((level) => shown(which, (row) => row.level === level)),
      ...OTHERS.map(([, engine, iterations]) =>
        shown(
          which,
          (row) => row.engine === engine && row.step === STEP && row.iterations === iterations,
        ),
      ),
    ]),
  };
}

export const contactCosts = (costs: readonly ContactCost[]): Table => ({
  head: [
    'scene',
    'contact points',
    'ours, ms',
    'by iterations, ms',
    'Bullet, ms',
    'ours : Bullet',
    'ours : by iterations',
  ],
  rows: costs.map(({ scene, contacts, solve, iterated, bullet, ratio, more }) => [
    scene,
    String(contacts),
    ...[solve, iterated, bullet, ratio, more].map(threeDigits),
  ]),
});
