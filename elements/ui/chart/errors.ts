import type { LevelMeasurement } from '../../../physics-core/inside.js';

/** What may be drawn against the cost. */
export type ErrorName = keyof LevelMeasurement['error'];

interface ErrorKind {
  label: string;
  /** How the axis is called. */
  axis: string;
  text(value: number): string;
}

const ofThree = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 });

function metres(value: number): string {
  if (value === 0) return '0';
  if (value >= 1) return `${ofThree.format(value)} m`;
  if (value >= 1e-3) return `${ofThree.format(value * 1e3)} mm`;
  return value >= 1e-6 ? `${ofThree.format(value * 1e6)} µm` : '< 1 µm';
}

function share(value: number): string {
  if (value === 0) return '0';
  return value >= 1e-6 ? `${ofThree.format(value * 100)} %` : '< 0.0001 %';
}

/** Milliseconds per simulated second. */
export const work = (value: number): string => ofThree.format(value);

export const ERRORS: Readonly<Record<ErrorName, ErrorKind>> = {
  position: { label: 'Position', axis: 'farthest body', text: metres },
  energy: { label: 'Energy', axis: 'energy off by', text: share },
  joint: { label: 'Joint gap', axis: 'widest gap', text: metres },
  penetration: { label: 'Overlap', axis: 'deepest overlap', text: metres },
};
