import { cross, dot, minus, normalized, type Surface } from './surface.js';

// X3D's Extrusion (ISO/IEC 19775-1, 13.3.5): a cross-section that is carried along a spine.

type Vector = [number, number, number];

export interface Extruded {
  crossSection: [number, number][];
  spine: Vector[];
  /** Across x and z of the cross-section, at each point of the spine; the last one holds for the rest. */
  scale: [number, number][];
  /** Unit quaternions, x y z w, likewise. */
  orientation: [number, number, number, number][];
  beginCap: boolean;
  endCap: boolean;
}

/** Axes of the plane that the cross-section lies in: x, the direction of the spine, z. */
type Frame = [x: Vector, y: Vector, z: Vector];

/** `faces` makes triangles of a polygon of points. */
export function extrude(
  g: Extruded,
  faces: (points: number[], polygon: number[]) => number[],
): Surface {
  const [across, along] = [g.crossSection.length, g.spine.length];
  if (across < 2 || along < 2) return { points: [], index: [] };
  const frames = framesOf(g.spine);
  const points = frames.flatMap((frame, i) => ring(g, frame, i).flat());
  const surface: Required<Surface> = {
    ...{ points, index: [], faces: [], texIndex: [] },
    texCoords: g.spine.flatMap((_, i) =>
      g.crossSection.flatMap((__, j) => [j / (across - 1), i / (along - 1)]),
    ),
  };
  for (let i = 0; i + 1 < along; i++)
    for (let j = 0; j + 1 < across; j++) side(surface, i * across + j, across);
  const caps: [boolean, number][] = [
    [g.beginCap, 0],
    [g.endCap, along - 1],
  ];
  for (const [is, i] of caps) if (is) cap(surface, g, i, faces);
  return surface;
}

function side({ index, faces, texIndex }: Required<Surface>, a: number, across: number): void {
  const [b, d] = [a + 1, a + across];
  const face = faces.length / 2;
  index.push(a, b, d + 1, a, d + 1, d);
  texIndex.push(a, b, d + 1, a, d + 1, d);
  faces.push(face, face);
}

/** The begin looks back. */
function cap(
  { points, index, faces, texCoords, texIndex }: Required<Surface>,
  { crossSection }: Extruded,
  i: number,
  triangles: (points: number[], polygon: number[]) => number[],
): void {
  const isClosed = same(crossSection[0], crossSection.at(-1)!);
  const across = crossSection.length;
  const polygon = Array.from({ length: isClosed ? across - 1 : across }, (_, j) => i * across + j);
  const first = texCoords.length / 2;
  texCoords.push(...flatTexCoords(crossSection));
  const made = triangles(points, i === 0 ? polygon.toReversed() : polygon);
  const face = (faces.at(-1) ?? -1) + 1;
  for (let t = 0; t < made.length; t += 3) faces.push(face);
  index.push(...made);
  texIndex.push(...made.map((point) => first + point - i * across));
}

/** The larger side from 0 to 1. */
function flatTexCoords(crossSection: [number, number][]): number[] {
  const range = (axis: 0 | 1): [number, number] => {
    const values = crossSection.map((point) => point[axis]);
    return [Math.min(...values), Math.max(...values)];
  };
  const [[left, right], [low, high]] = [range(0), range(1)];
  const size = Math.max(right - left, high - low) || 1;
  return crossSection.flatMap(([x, z]) => [(x - left) / size, (z - low) / size]);
}

const same = (a: number[], b: number[]): boolean => a.every((value, i) => value === b[i]);

const atOrLast = <T>(list: T[], i: number): T | undefined => list[i] ?? list.at(-1);

function ring(g: Extruded, [x, y, z]: Frame, i: number): Vector[] {
  const [sx, sz] = atOrLast(g.scale, i) ?? [1, 1];
  const turn = atOrLast(g.orientation, i) ?? [0, 0, 0, 1];
  return g.crossSection.map(([cx, cz]) => {
    const [a, b, c] = rotated([cx * sx, 0, cz * sz], turn);
    return [0, 1, 2].map((k) => g.spine[i][k] + a * x[k] + b * y[k] + c * z[k]) as Vector;
  });
}

function rotated(v: Vector, [x, y, z, w]: [number, number, number, number]): Vector {
  const u: Vector = [x, y, z];
  const t = cross(u, v).map((value) => 2 * value) as Vector;
  const again = cross(u, t);
  return [0, 1, 2].map((k) => v[k] + w * t[k] + again[k]) as Vector;
}

/** Where the spine gives no direction, that of its neighbour holds. */
function framesOf(spine: Vector[]): Frame[] {
  const isClosed = same(spine[0], spine.at(-1)!);
  const along = filled(spine.map((_, i) => normalized(alongAt(spine, i, isClosed)))) ?? [];
  if (along.length === 0) return spine.map(() => [X, Y, Z]);
  const bends = filled(spine.map((_, i) => normalized(bendAt(spine, i, isClosed))));
  if (!bends) {
    const frame = straight(along[0]);
    return spine.map(() => frame);
  }
  for (let i = 1; i < bends.length; i++)
    if (dot(bends[i], bends[i - 1]) < 0) bends[i] = bends[i].map((value) => -value) as Vector;
  return along.map((y, i) => {
    const z = bends[i];
    return [normalized(cross(y, z)) ?? X, y, z];
  });
}

const X: Vector = [1, 0, 0];
const Y: Vector = [0, 1, 0];
const Z: Vector = [0, 0, 1];

function alongAt(spine: Vector[], i: number, isClosed: boolean): Vector {
  const last = spine.length - 1;
  if (i > 0 && i < last) return minus(spine[i + 1], spine[i - 1]);
  if (isClosed) return minus(spine[1], spine[last - 1]);
  return i === 0 ? minus(spine[1], spine[0]) : minus(spine[last], spine[last - 1]);
}

/** Across the plane in which the spine bends. */
function bendAt(spine: Vector[], i: number, isClosed: boolean): Vector {
  const last = spine.length - 1;
  const isEnd = i === 0 || i === last;
  if (isEnd && !isClosed) return [0, 0, 0];
  const [before, after] = isEnd ? [spine[last - 1], spine[1]] : [spine[i - 1], spine[i + 1]];
  return cross(minus(after, spine[i]), minus(before, spine[i]));
}

/** Gaps take what is before them, those at the begin what comes first; undefined where there is nothing. */
function filled(list: (Vector | undefined)[]): Vector[] | undefined {
  const first = list.find((each) => each !== undefined);
  if (!first) return undefined;
  let last = first;
  return list.map((each) => (last = each ?? last));
}

/** A spine without a bend: the shortest turn that takes Y to it. */
function straight(y: Vector): Frame {
  const axis = cross(Y, y);
  const turn: [number, number, number, number] =
    y[1] < -1 + 1e-9 ? [1, 0, 0, 0] : unitQuaternion([...axis, 1 + y[1]]);
  return [rotated(X, turn), y, rotated(Z, turn)];
}

function unitQuaternion(q: [number, number, number, number]): [number, number, number, number] {
  const length = Math.hypot(...q);
  return q.map((value) => value / length) as [number, number, number, number];
}
