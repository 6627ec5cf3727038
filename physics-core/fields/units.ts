import type { Dimension, FieldType, Value } from './types.js';

/** How many SI units one unit of a file is. `UNIT` statements change it; the core itself is always SI. */
export interface Units {
  angle: number;
  length: number;
  mass: number;
  force: number;
}

export const SI: Readonly<Units> = Object.freeze({ angle: 1, length: 1, mass: 1, force: 1 });

function factorOf(dimension: Dimension, units: Units): number {
  let factor = 1;
  for (const name of ['angle', 'length', 'mass', 'force'] as const) {
    const power = dimension[name];
    if (power) factor *= units[name] ** power;
  }
  return factor;
}

function scaled(value: Value, factor: number): Value {
  if (factor === 1) return value;
  if (typeof value === 'number') return value * factor;
  if (Array.isArray(value)) return value.map((item) => scaled(item, factor));
  return value;
}

function convert(type: FieldType, value: Value, dimension: Dimension, units: Units, back: boolean) {
  const factor = back ? 1 / factorOf(dimension, units) : factorOf(dimension, units);
  if (type === 'SFRotation') {
    const [x, y, z, angle] = value as number[];
    return [x, y, z, angle! * factor];
  }
  return scaled(value, factor);
}

/** A value as a file writes it, in SI. */
export const toSI = (
  type: FieldType,
  value: Value,
  dimension: Dimension | undefined,
  units: Units,
): Value => (dimension ? convert(type, value, dimension, units, false) : value);

/** An SI value in the units of a file. */
export const fromSI = (
  type: FieldType,
  value: Value,
  dimension: Dimension | undefined,
  units: Units,
): Value => (dimension ? convert(type, value, dimension, units, true) : value);
