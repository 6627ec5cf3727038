import { hypot } from '../../base/exact/index.js';

const GOLDEN = (1 + Math.sqrt(5)) / 2;

type Point = [number, number, number];

const onBall = (x: number, y: number, z: number): Point => {
  const size = hypot(x, y, z);
  return [x / size, y / size, z / size];
};

const ENDS = [
  [-1, GOLDEN, 0],
  [1, GOLDEN, 0],
  [-1, -GOLDEN, 0],
  [1, -GOLDEN, 0],
].flatMap(([x, y, z]) => [onBall(x!, y!, z!), onBall(z!, x!, y!), onBall(y!, z!, x!)]);

const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Neighbours of the twelve ends are alike near: of each three the one of two that looks outward. */
function twenty(): Point[][] {
  const near = (a: Point, b: Point): boolean => a !== b && dot(a, b) > 0;
  const faces: Point[][] = [];
  for (const [i, a] of ENDS.entries())
    for (const [j, b] of ENDS.entries())
      for (const c of ENDS.slice(j + 1))
        if (i < j && near(a, b) && near(b, c) && near(a, c))
          faces.push(dot(cross(a, b), c) > 0 ? [a, b, c] : [a, c, b]);
  return faces;
}

function split([a, b, c]: Point[]): Point[][] {
  const between = (p: Point, q: Point): Point => onBall(p[0] + q[0], p[1] + q[1], p[2] + q[2]);
  const ab = between(a!, b!);
  const bc = between(b!, c!);
  const ca = between(c!, a!);
  return [
    [a!, ab, ca],
    [ab, b!, bc],
    [ca, bc, c!],
    [ab, bc, ca],
  ];
}

const areaOf = ([a, b, c]: Point[]): number => {
  const [u, v] = [b!, c!].map((end) => end.map((each, k) => each - a![k]!) as Point);
  return hypot(...cross(u!, v!)) / 2;
};

/** Eighty triangles of a ball of radius 1, with as much skin. */
function ball(): number[] {
  const faces = twenty().flatMap(split);
  const area = faces.reduce((sum, each) => sum + areaOf(each), 0);
  const larger = Math.sqrt((4 * Math.PI) / area);
  return faces.flat(2).map((each) => each * larger);
}

let made: readonly number[] | undefined;

export const unitBall = (): readonly number[] => (made ??= ball());
