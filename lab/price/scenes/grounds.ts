import type { CaseBody, CaseJoint, CaseScene, Heights, Triangles, Vec3 } from '../../case.js';
import { ball, box, floor, layers, random, touching, type PriceScene } from '../scene.js';

// What rolls and falls on grounds of triangles, and hulls of many points.

/** Metres from point to point of a ground, and how high its waves are. */
const [GRID, WAVE] = [1, 0.3];

/** So many points to a side, waves over them. */
function waves(points: number): Heights {
  const height = Array.from({ length: points ** 2 }, (_, i) => {
    const [x, z] = [i % points, Math.floor(i / points)];
    return WAVE * (Math.sin(0.5 * x * GRID) + Math.sin(0.4 * z * GRID));
  });
  return {
    type: 'ElevationGrid',
    xDimension: points,
    zDimension: points,
    xSpacing: GRID,
    zSpacing: GRID,
    height,
  };
}

/** A ground by its triangles, two for each square. */
function meshOf({ xDimension, zDimension, xSpacing, zSpacing, height }: Heights): Triangles {
  const coord = height.flatMap((y, i) => [
    (i % xDimension) * xSpacing,
    y,
    Math.floor(i / xDimension) * zSpacing,
  ]);
  const index: number[] = [];
  for (let z = 1; z < zDimension; z++)
    for (let x = 1; x < xDimension; x++) {
      const here = z * xDimension + x;
      const [left, back, corner] = [here - 1, here - xDimension, here - xDimension - 1];
      index.push(corner, left, here, corner, here, back);
    }
  return { type: 'IndexedTriangleSet', coord, index };
}

/** About the origin. */
const ground = (points: number, shape: CaseBody['shape']): CaseBody => ({
  name: 'ground',
  fixed: true,
  position: [(-(points - 1) * GRID) / 2, 0, (-(points - 1) * GRID) / 2],
  shape,
});

// ---- cars ------------------------------------------------------------------------------------------------------------

/** Metres from the middle of a car; rad/s and newton metres of each wheel. */
const WHEELS: Vec3[] = [-0.7, 0.7].flatMap((x) => [-0.55, 0.55].map((z): Vec3 => [x, -0.25, z]));
const [SPEED, TORQUE] = [8, 60];

function car(name: string, place: Vec3): { bodies: CaseBody[]; joints: CaseJoint[] } {
  const at = (own: Vec3): Vec3 => [place[0] + own[0], place[1] + own[1], place[2] + own[2]];
  const body: CaseBody = { name, mass: 200, position: place, shape: box(1.8, 0.4, 0.8) };
  const wheels = WHEELS.map((own, i): CaseBody => ({
    name: `${name} ${i}`,
    mass: 15,
    position: at(own),
    orientation: [1, 0, 0, Math.PI / 2],
    shape: { type: 'Cylinder', radius: 0.3, height: 0.2 },
  }));
  const axles = wheels.map((wheel, i): CaseJoint => ({
    type: 'DoubleAxisHingeJoint',
    body1: name,
    body2: wheel.name,
    anchorPoint: at(WHEELS[i]!),
    axis1: [0, 1, 0],
    axis2: [0, 0, 1],
    minAngle1: 0,
    maxAngle1: 0,
    desiredAngularVelocity2: SPEED,
    maxTorque2: TORQUE,
  }));
  return { bodies: [body, ...wheels], joints: axles };
}

/** Side by side on waves that are a mesh. */
function cars(count: number): CaseScene {
  const row = Math.ceil(Math.sqrt(count));
  const points = 4 * row + 10;
  const all = layers(count, row, 3, 1.6).map((place, i) => car(`car ${i}`, place));
  return touching(
    [ground(points, meshOf(waves(points))), ...all.flatMap(({ bodies }) => bodies)],
    all.flatMap(({ joints }) => joints),
  );
}

// ---- what is mixed ---------------------------------------------------------------------------------------------------

/** Hulls on rings about y, of so many points each, and two poles; an ellipsoid of these half axes goes through them. */
function hull(rings: number, sides: number, [a, b, c]: Vec3): Triangles {
  const pole = rings * sides;
  const coord = Array.from({ length: pole }, (_, i) => {
    const down = (Math.PI * (Math.floor(i / sides) + 1)) / (rings + 1);
    const around = (2 * Math.PI * (i % sides)) / sides;
    return [
      a * Math.sin(down) * Math.cos(around),
      b * Math.cos(down),
      -c * Math.sin(down) * Math.sin(around),
    ];
  }).flat();
  const index: number[] = [];
  for (let i = 0; i < pole; i++) {
    const ring = Math.floor(i / sides);
    const beside = ring * sides + ((i + 1) % sides);
    if (ring === 0) index.push(pole, i, beside);
    if (ring === rings - 1) index.push(i, pole + 1, beside);
    else index.push(i, i + sides, beside, beside, i + sides, beside + sides);
  }
  return { type: 'IndexedTriangleSet', coord: [...coord, 0, b, 0, 0, -b, 0], index };
}

/** Of the ellipsoid, kg m². */
const momentsOf = (mass: number, [a, b, c]: Vec3): Vec3 => [
  (mass / 5) * (b ** 2 + c ** 2),
  (mass / 5) * (a ** 2 + c ** 2),
  (mass / 5) * (a ** 2 + b ** 2),
];

const rounded = (rings: number, sides: number, axes: Vec3) => ({
  shape: hull(rings, sides, axes),
  inertia: momentsOf(1, axes),
});

/** Half axes. */
const STONE: Vec3 = [0.3, 0.2, 0.25];
const KINDS: Pick<CaseBody, 'shape' | 'inertia'>[] = [
  { shape: ball(0.25) },
  { shape: box(0.5, 0.4, 0.45) },
  { shape: { type: 'Cylinder', radius: 0.25, height: 0.4 } },
  rounded(2, 5, STONE),
];

function thrown(places: readonly Vec3[], kinds: typeof KINDS): CaseBody[] {
  const next = random();
  return places.map((position, i) => ({
    name: `${i}`,
    position,
    orientation: [next() - 0.5, next() - 0.5, next() - 0.5, 3 * next()],
    ...kinds[i % kinds.length],
  }));
}

/** Jolt takes a power of two of points to a side. */
const fieldUnder = (row: number): CaseBody => {
  const points = row > 10 ? 64 : 16;
  return ground(points, waves(points));
};

const mixed = (count: number): CaseScene => {
  const row = Math.max(2, Math.round(Math.sqrt(count / 4)));
  const bodies = thrown(layers(count, row, 0.9, 1.2), KINDS);
  return touching([fieldUnder(row), ...bodies]);
};

/** Rings and points of each: with the poles 200. */
const stones = (count: number): CaseScene => {
  const bodies = thrown(layers(count, 3, 0.8, 0.6), [rounded(11, 18, STONE)]);
  return touching([floor(40), ...bodies]);
};

export const grounds: PriceScene[] = [
  {
    id: 'cars-100',
    name: '100 cars on a mesh',
    size: 100,
    small: 1,
    judged: 'gap',
    driven: 'their motors',
    finest: 'fine',
    bound: 4,
    build: cars,
  },
  {
    id: 'mixed-1000',
    name: '1000 mixed on a field of heights',
    size: 1000,
    small: 8,
    judged: 'overlap',
    finest: 'fine',
    build: mixed,
  },
  {
    id: 'hulls-40',
    name: '40 hulls of 200 points',
    size: 40,
    small: 2,
    judged: 'overlap',
    build: stones,
  },
];
