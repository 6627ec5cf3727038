import type { Line } from '../../shapes/geometry.js';

const isNumbers = (value: unknown): boolean =>
  ArrayBuffer.isView(value) || (Array.isArray(value) && typeof value.flat()[0] === 'number');

const isLine = (value: unknown): value is Line =>
  typeof value === 'object' &&
  value !== null &&
  'type' in value &&
  (value.type === 'LineSet' || value.type === 'IndexedLineSet');

/** Of a Coordinate, what it has. */
const pointsOf = (coord: unknown): unknown =>
  typeof coord === 'object' && coord !== null && 'point' in coord ? coord.point : coord;

/** The first line of a set, or the flat list of its numbers, as it is kept: looked through as all geometry is. */
export function keptLine(value: unknown): unknown {
  if (isNumbers(value)) return { type: 'Mesh', points: value };
  return isLine(value) ? { type: 'Mesh', points: firstOf(value) } : value;
}

function firstOf(line: Line): unknown {
  const coord = pointsOf(line.coord);
  if (!isNumbers(coord)) return coord;
  const points = [...(coord as ArrayLike<number> & Iterable<number>)].flat() as number[];
  if (line.type === 'LineSet') return points.slice(0, 3 * (line.vertexCount?.[0] ?? Infinity));
  const index = line.coordIndex ?? points.flatMap((_, i) => (i % 3 === 0 ? [i / 3] : []));
  const end = index.indexOf(-1);
  return index
    .slice(0, end < 0 ? undefined : end)
    .filter((i) => i >= 0 && 3 * i + 2 < points.length)
    .flatMap((i) => points.slice(3 * i, 3 * i + 3));
}
