import { cross, dot, length, subtract } from '../../../physics-core/base/math.js';
import type { Geometry } from '../../../physics-core/shapes/geometry.js';
import { tessellate } from '../../../physics-core/shapes/tessellate.js';
import { meshes } from '../../../physics-core/shapes/meshes.js';
import assert from 'node:assert/strict';
import { addBody, below, close, fact, height, sphere, world, type Vec3 } from '../helpers.js';

await meshes.load();

type Points = [number, number][];

/** In a plane that stands askew, where nothing is zero by chance. */
const askew = ([x, y]: [number, number]): Vec3 => [0.6 * x + 3, 0.8 * x - y / 3, y + 5];

/** What one square metre of the plane is on `askew`. */
const SQUARE = cross([0.6, 0.8, 0], [0, -1 / 3, 1]);

const faceSet = (points: Points): Geometry => ({
  type: 'IndexedFaceSet',
  coord: points.flatMap(askew),
  coordIndex: [...points.keys(), -1],
});

/** Every triangle of a geometry, as the vector of twice its area. */
function areasOf(g: Geometry): Vec3[] {
  const { points, index } = tessellate(g);
  const at = (i: number): Vec3 => [points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!];
  return index.flatMap((a, i) =>
    i % 3 ? [] : [cross(subtract(at(index[i + 1]!), at(a)), subtract(at(index[i + 2]!), at(a)))],
  );
}

const total = (areas: Vec3[]): number => areas.reduce((sum, area) => sum + length(area), 0) / 2;

const L: Points = [
  [0, 0],
  [2, 0],
  [2, 1],
  [1, 1],
  [1, 2],
  [0, 2],
];
const STAR: Points = Array.from({ length: 10 }, (_, i) => {
  const r = i % 2 ? 0.4 : 1;
  return [r * Math.cos((i * Math.PI) / 5), r * Math.sin((i * Math.PI) / 5)];
});
const DART: Points = [
  [-1, 0],
  [0, 0.2],
  [1, 0],
  [0, 2],
];

/** Of a polygon, square metres. */
const areaOf = (points: Points): number =>
  points.reduce((sum, [x, y], i) => {
    const [u, v] = points[(i + 1) % points.length]!;
    return sum + (x * v - y * u) / 2;
  }, 0);

fact(
  'a concave face is covered exactly, all triangles facing its way, from whichever corner',
  () => {
    for (const [name, points] of Object.entries({ L, STAR, DART }))
      for (const first of points.keys())
        for (const turned of [false, true]) {
          const around = [...points.slice(first), ...points.slice(0, first)];
          const areas = areasOf(faceSet(turned ? around.reverse() : around));
          const what = `${name} from corner ${first}`;
          assert.equal(areas.length, points.length - 2, what);
          assert.ok(
            areas.every((area) => dot(area, SQUARE) > 0 !== turned),
            what,
          );
          close(total(areas), areaOf(points) * length(SQUARE), 1e-12, what);
        }
  },
);

fact('a convex face stays the fan of its first corner', () => {
  const hexagon: Points = [
    [2, 0],
    [1, 2],
    [-1, 2],
    [-2, 0],
    [-1, -2],
    [1, -2],
  ];
  assert.deepEqual(tessellate(faceSet(hexagon)).index, [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5]);
  assert.deepEqual(tessellate(faceSet(hexagon.slice(0, 4))).index, [0, 1, 2, 0, 2, 3]);
});

fact('points in the middle of a side leave a face the fan it is', () => {
  const points: Points = [
    [0, 0],
    [1, 0],
    [2, 0],
    [2, 2],
    [0.3, 2],
    [0, 2],
  ];
  const coord = points.flatMap(askew).map(Math.fround);
  const { index } = tessellate({ type: 'IndexedFaceSet', coord, coordIndex: [0, 1, 2, 3, 4, 5] });
  assert.deepEqual(index, [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5]);
});

fact('a concave quad is covered exactly, too', () => {
  const coord = [DART, DART.map(([x, y]): [number, number] => [x + 5, y])].flat().flatMap(askew);
  const quads: Geometry[] = [
    { type: 'QuadSet', coord },
    { type: 'IndexedQuadSet', coord, index: [0, 1, 2, 3, 4, 5, 6, 7] },
    { type: 'IndexedQuadSet', coord, index: [1, 2, 3, 0, 5, 6, 7, 4, 1] },
  ];
  for (const quad of quads)
    close(total(areasOf(quad)), 2 * areaOf(DART) * length(SQUARE), 1e-12, quad.type);
});

fact(
  'faces without an area, crossing themselves or naming points that are not there do no harm',
  () => {
    const faces: Points[] = [
      [
        [0, 0],
        [1, 0],
        [2, 0],
        [3, 0],
      ],
      [
        [1, 1],
        [1, 1],
        [1, 1],
        [1, 1],
        [1, 1],
      ],
      [
        [0, 0],
        [2, 2],
        [2, 0],
        [0, 2],
      ],
      [
        [0, 0],
        [3, 3],
        [3, 0],
        [0, 2],
        [1, -1],
      ],
      [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 0],
        [1, 0],
        [1, 1],
      ],
      Array.from({ length: 5 }, (_, i) => [Math.cos(i * 2.513), Math.sin(i * 2.513)]),
      L.map(([x, y]) => [x * 1e30, y * 1e30]),
      L.map(([x, y]) => [x * 1e-30, y * 1e-30]),
    ];
    for (const face of faces)
      assert.ok(areasOf(faceSet(face)).flat().every(Number.isFinite), JSON.stringify(face));
    const beyond = { ...faceSet(L), coordIndex: [0, 1, 2, 3, 9, 5, -1] } as Geometry;
    assert.ok(areasOf(beyond).flat().every(Number.isFinite));
  },
);

fact('a ball falls through the gap of a concave face, and rests on its arms', async () => {
  const w = await world();
  const U: Points = [
    [0, 0],
    [3, 0],
    [3, 3],
    [2, 3],
    [2, 1],
    [1, 1],
    [1, 3],
    [0, 3],
  ];
  // Lying, and facing up.
  const coord = U.flatMap(([x, y]) => [x, 0, -y]);
  const plate = { type: 'IndexedFaceSet', coord, coordIndex: [...U.keys(), -1] };
  addBody(w, { fixed: true, geometry: [plate] });
  const [through, left, right] = [1.5, 0.5, 2.5].map((x) =>
    addBody(w, { position: [x, 0.5, -2.2], geometry: [sphere(0.3)] }),
  );
  w.advance(1);
  below(height(through!), -3, 'm');
  close(height(left!), 0.3, 0.01, 'm');
  close(height(right!), 0.3, 0.01, 'm');
});
