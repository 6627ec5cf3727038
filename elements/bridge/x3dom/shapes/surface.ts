/** Triangles, and what makes a picture of them. */
export interface Surface {
  /** Flat x y z. */
  points: number[];
  /** Three indices into the points a triangle, counter-clockwise from where it is seen. */
  index: number[];
  /** The face that each triangle is of, for colours and normals per face; undefined: its own. */
  faces?: number[] | undefined;
  /** Flat s t, and for each corner of each triangle which; undefined: as the points. */
  texCoords?: number[] | undefined;
  texIndex?: number[] | undefined;
}

type Vector = [number, number, number];

/** Flat normals for each corner: faces that meet at less than the crease angle are smooth there. */
export function normalsOf({ points, index }: Surface, creaseAngle: number): number[] {
  const flat = trianglesOf(index).map((triangle) => normalOf(points, triangle));
  if (creaseAngle <= 0) return flat.flatMap(({ unit }) => [...unit, ...unit, ...unit]);
  const least = Math.cos(Math.min(creaseAngle, Math.PI));
  const meeting = facesByPlace(points, index);
  return index.flatMap((point, corner) => {
    const own = flat[Math.floor(corner / 3)];
    const sum: Vector = [0, 0, 0];
    for (const face of meeting.get(place(points, point))!) {
      const { unit, area } = flat[face];
      if (dot(unit, own.unit) < least - 1e-6) continue;
      for (let i = 0; i < 3; i++) sum[i] += unit[i] * area;
    }
    return normalized(sum) ?? own.unit;
  });
}

const trianglesOf = (index: number[]): number[][] =>
  Array.from({ length: index.length / 3 }, (_, t) => index.slice(3 * t, 3 * t + 3));

function normalOf(points: number[], triangle: number[]): { unit: Vector; area: number } {
  const [a, b, c] = triangle.map((i) => points.slice(3 * i, 3 * i + 3) as Vector);
  const normal = cross(minus(b, a), minus(c, a));
  return { unit: normalized(normal) ?? [0, 1, 0], area: Math.hypot(...normal) };
}

/** Points in one place are one, also where a seam has two. */
const place = (points: number[], i: number): string =>
  `${points[3 * i]} ${points[3 * i + 1]} ${points[3 * i + 2]}`;

function facesByPlace(points: number[], index: number[]): Map<string, number[]> {
  const found = new Map<string, number[]>();
  index.forEach((point, corner) => {
    const key = place(points, point);
    const faces = found.get(key);
    if (faces) faces.push(Math.floor(corner / 3));
    else found.set(key, [Math.floor(corner / 3)]);
  });
  return found;
}

export const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Undefined where it has no direction. */
export function normalized(v: Vector): Vector | undefined {
  const length = Math.hypot(...v);
  return length > 1e-12 ? [v[0] / length, v[1] / length, v[2] / length] : undefined;
}
