import type { FieldType, Value } from '../fields/types.js';
import { codecs } from '../fields/values.js';
import { BOUNDS, shownBound } from '../fields/bounds.js';
import { guards } from '../base/guards.js';
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
    const most = COUNTS.includes(fieldType) ? Infinity : BOUNDS.geometry;
    if (!guards.bounded(numbersOf(value), most))
      return { fault: `${says} is beyond ±${shownBound(most)}, the most that it may be` };
    sound[name] = value;
  }
  const geometry = sound as Geometry;
  const fault = tooMuch(geometry);
  return fault === undefined ? { geometry } : { fault };
}

/** Counts and indices: what they point at where nothing is, is left out. */
const COUNTS: readonly FieldType[] = ['SFInt32', 'MFInt32'];

/** Points of one geometry: Bullet takes some 100 bytes for each, and its hull some seconds. */
const MOST_POINTS = 2 ** 20;

/** Why a geometry whose fields are sound each is none. */
function tooMuch(geometry: Geometry): string | undefined {
  const { type } = geometry;
  const isGrid = type === 'ElevationGrid';
  const across = isGrid ? [geometry.xDimension ?? 0, geometry.zDimension ?? 0] : [1, 1];
  const points = isGrid ? across[0]! * across[1]! : pointsIn(geometry);
  if (points > MOST_POINTS) return `a ${type} of ${points} points has more than ${MOST_POINTS}`;
  const scale = Math.max(1, ...across) * largest(geometry.linear ?? [1]);
  if (largestLength(geometry) * scale <= BOUNDS.geometry) return undefined;
  return `a ${type} that is scaled to more than ${shownBound(BOUNDS.geometry)} m is beyond the most that it may be`;
}

const PLACEMENT = ['translation', 'rotation', 'linear'];

const pointsIn = (geometry: object): number =>
  Math.max(0, ...Object.values(geometry).map((value) => numbersOf(value).length / 3));

const largest = (numbers: readonly number[]): number =>
  numbers.reduce((most, number) => Math.max(most, Math.abs(number)), 0);

function largestLength(geometry: Geometry): number {
  const fields = geometryFields(geometry.type);
  const lengths = Object.entries(geometry).filter(
    ([name]) => fields[name] && !COUNTS.includes(fields[name]) && !PLACEMENT.includes(name),
  );
  return lengths.reduce((most, [, value]) => Math.max(most, largest(numbersOf(value))), 0);
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
