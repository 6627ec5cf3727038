import type { Row } from '../run/row.js';

const COLUMNS: [string, (row: Row) => unknown][] = [
  ['case', (row) => row.case],
  ['scene', (row) => row.scene],
  ['engine', (row) => row.engine],
  ['level', (row) => row.level],
  ['step (s)', (row) => row.step],
  ['iterations', (row) => row.iterations],
  ['effects', (row) => row.effects.join(' ')],
  ['error', (row) => row.error],
  ['unit', (row) => row.unit],
  ['gap (m)', (row) => row.gap],
  ['energy change (J)', (row) => row.energyChange],
  ['ms per simulated second', (row) => row.ms],
  ['contacts', (row) => row.contacts],
  ['joints', (row) => row.joints],
  ['state hash', (row) => row.hash],
];

const cell = (value: unknown): string => {
  const text = value === null || value === undefined ? '' : String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

/** One line per run. */
export const csvOf = (rows: readonly Row[]): string =>
  [COLUMNS.map(([name]) => name), ...rows.map((row) => COLUMNS.map(([, read]) => read(row)))]
    .map((cells) => `${cells.map(cell).join(',')}\n`)
    .join('');
