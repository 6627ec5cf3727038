import type { FieldType, Value } from '../fields/types.js';
import { codecs } from '../fields/values.js';
import { guards, LARGEST } from '../base/guards.js';
import { show } from '../base/show.js';
import { geometryFields, isGeometry, type Geometry, type GeometryType } from './geometry.js';

/** A geometry that may go to Bullet, or why it may not. */
export type Sound =
  { geometry: Geometry; fault?: undefined } | { geometry?: undefined; fault: string };

/** What plain data says of a geometry, each value as its field has it: one that is not sound would reach Bullet as NaN. */
export function soundGeometry(data: { type: string }): Sound {
  const { type } = data;
  if (!isGeometry(type)) return { fault: `${show(type)} is no geometry` };
  const sound: { type: GeometryType; [field: string]: Value } = { type };
  for (const [name, fieldType] of Object.entries(geometryFields(type))) {
    const given = (data as Record<string, unknown>)[name];
    if (given === undefined) continue;
    const value = read(fieldType, given);
    const says = `${name}="${show(given)}" of its ${type}`;
    if (value === undefined) return { fault: `${says} is not ${fieldType}` };
    if (!guards.finiteVector(numbersOf(value)))
      return { fault: `${says} is beyond ±${LARGEST}, the most that single precision holds` };
    sound[name] = value;
  }
  return { geometry: sound as Geometry };
}

/** Points may be X3D's Coordinate node; they stay a flat list. */
function read(type: FieldType, given: unknown): Value | undefined {
  if (type !== 'MFVec3f') return guards.wellFormed(codecs[type], given);
  const points = isCoordinate(given) ? given.point : given;
  const numbers = guards.wellFormed(codecs.MFFloat, points) as number[] | undefined;
  return numbers && numbers.length % 3 === 0 ? numbers : undefined;
}

const isCoordinate = (value: unknown): value is { point: unknown } =>
  typeof value === 'object' && value !== null && 'point' in value;

const numbersOf = (value: Value): number[] =>
  typeof value === 'number' ? [value] : Array.isArray(value) ? value : [];
