import { hypot, lengthOf } from '../base/exact/index.js';
import { orient3d } from 'robust-predicates';

/** A triangle of the hull, and the faces across its sides: from each corner to the next. */
interface Face {
  corners: [number, number, number];
  across: Face[];
  /** Points that see it, and wait for their turn. */
  seenBy: number[];
  gone: boolean;
}

/** A side of what an eye sees, and the face beyond it, which the eye does not see. */
interface Side {
  from: number;
  to: number;
  beyond: Face;
}

/** How far a point lies above three others, by their order: six times a volume. Its sign is exact. */
type Height = (corners: Face['corners'], point: number) => number;

/** The convex hull of points. */
export interface Hull {
  /** The numbers of the points that stand out, ascending. */
  corners: number[];
  /** From each point of the hull along its sides to others; also from those within a face or on an edge. */
  neighbours: Map<number, number[]>;
  /** Its triangles, against the clock as seen from outside. */
  triangles: [number, number, number][];
}

const face = (a: number, b: number, c: number): Face => ({
  corners: [a, b, c],
  across: [],
  seenBy: [],
  gone: false,
});

function heightsOver(at: number[]): Height {
  return (corners, point) => {
    const a = 3 * corners[0];
    const b = 3 * corners[1];
    const c = 3 * corners[2];
    const d = 3 * point;
    // prettier-ignore
    return orient3d(
      at[a]!, at[a + 1]!, at[a + 2]!, at[b]!, at[b + 1]!, at[b + 2]!,
      at[c]!, at[c + 1]!, at[c + 2]!, at[d]!, at[d + 1]!, at[d + 2]!,
    );
  };
}

/** The number with the greatest measure, if that is above 0. */
function greatest(numbers: Iterable<number>, measure: (number: number) => number) {
  let [best, most]: [number | undefined, number] = [undefined, 0];
  for (const number of numbers) {
    const value = measure(number);
    if (value > most) [best, most] = [number, value];
  }
  return best;
}

/** Four points far from each other, the last above the others; undefined where all lie in one plane. */
function simplex(points: number[], height: Height): [number, number, number, number] | undefined {
  const all = [...Array(Math.floor(points.length / 3)).keys()];
  const from = (p: number) => [0, 1, 2].map((axis) => points[3 * p + axis]! - points[axis]!);
  const b = greatest(all, (p) => lengthOf(from(p)));
  if (b === undefined) return undefined;
  const [x, y, z] = from(b) as [number, number, number];
  const c = greatest(all, (p) => {
    const [u, v, w] = from(p) as [number, number, number];
    return hypot(y * w - z * v, z * u - x * w, x * v - y * u);
  });
  if (c === undefined) return undefined;
  const d = greatest(all, (p) => Math.abs(height([0, b, c], p)));
  if (d === undefined) return undefined;
  return height([0, b, c], d) > 0 ? [0, b, c, d] : [0, c, b, d];
}

/** Sets faces side to side that hang together along all of theirs. */
function join(faces: Face[]): void {
  const sides = new Map<string, Face>();
  const each = (act: (face: Face, i: number, from: number, to: number) => void): void =>
    faces.forEach((one) =>
      one.corners.forEach((from, i) => act(one, i, from, one.corners[(i + 1) % 3]!)),
    );
  each((one, _, from, to) => sides.set(`${from} ${to}`, one));
  each((one, i, from, to) => (one.across[i] = sides.get(`${to} ${from}`)!));
}

/** Takes away all faces that the eye sees, beginning with one of them: the sides of the hole. */
function clear(first: Face, eye: number, height: Height): { hole: Side[]; gone: Face[] } {
  const gone = [first];
  const hole: Side[] = [];
  first.gone = true;
  for (const { corners, across } of gone)
    across.forEach((beyond, i) => {
      if (beyond.gone) return;
      if (height(beyond.corners, eye) <= 0) {
        hole.push({ from: corners[i]!, to: corners[(i + 1) % 3]!, beyond });
      } else {
        beyond.gone = true;
        gone.push(beyond);
      }
    });
  return { hole, gone };
}

/** Faces from the sides of a hole to the eye, joined to each other and to those beyond. */
function close(hole: Side[], eye: number): Face[] {
  const made = new Map(hole.map(({ from, to }) => [from, face(from, to, eye)]));
  for (const { from, to, beyond } of hole) {
    const [one, following] = [made.get(from)!, made.get(to)!];
    one.across[0] = beyond;
    beyond.across[beyond.corners.indexOf(to)] = one;
    one.across[1] = following;
    following.across[2] = one;
  }
  return [...made.values()];
}

/** Each point to the first face that it sees; one that sees none is inside. */
function share(waiting: number[], faces: Face[], height: Height): void {
  for (const point of waiting)
    faces.find(({ corners }) => height(corners, point) > 0)?.seenBy.push(point);
}

/** What stands out has three edges or more; on an edge there are two, within a face none. */
function hullFrom(faces: Face[], height: Height): Hull {
  const neighbours = new Map<number, number[]>();
  const edges = new Map<number, number>();
  for (const { corners, across } of faces)
    corners.forEach((from, i) => {
      const to = corners[(i + 1) % 3]!;
      const tip = across[i]!.corners.find((corner) => corner !== from && corner !== to)!;
      const known = neighbours.get(from);
      if (known) known.push(to);
      else neighbours.set(from, [to]);
      if (height(corners, tip) !== 0) edges.set(from, (edges.get(from) ?? 0) + 1);
    });
  const corners = [...neighbours.keys()].filter((point) => (edges.get(point) ?? 0) >= 3);
  // A face's own corners go with the clock.
  const triangles = faces.map(({ corners: [a, b, c] }): Hull['triangles'][0] => [a, c, b]);
  return { corners: corners.sort((a, b) => a - b), neighbours, triangles };
}

/**
 * Quickhull (Barber, Dobkin, Huhdanpaa 1996); undefined where all points lie in one plane. Who sees which face is decided
 * exactly: with a tolerance in its place (tried with quickhull3d), about one in a hundred finely divided boxes with six
 * decimals in their file lost a corner.
 */
export function hullOf(points: number[]): Hull | undefined {
  const height = heightsOver(points);
  const first = simplex(points, height);
  if (!first) return undefined;
  const [a, b, c, d] = first;
  const faces = [face(a, c, b), face(a, b, d), face(b, c, d), face(c, a, d)];
  join(faces);
  share([...Array(Math.floor(points.length / 3)).keys()], faces, height);
  // Grows as it is walked through.
  for (const next of faces) {
    const eye = next.gone ? undefined : greatest(next.seenBy, (p) => height(next.corners, p));
    if (eye === undefined) continue;
    const { hole, gone } = clear(next, eye, height);
    const made = close(hole, eye);
    for (const { seenBy } of gone) share(seenBy, made, height);
    faces.push(...made);
  }
  return hullFrom(
    faces.filter(({ gone }) => !gone),
    height,
  );
}
