import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  box,
  claim,
  close,
  fact,
  height,
  position,
  sphere,
  world,
} from '../helpers.js';
import { faces, indexedTriangles, triangles } from './meshes.js';

const quads = (x: number, y: number, z: number): number[] => {
  const { coord, coordIndex } = faces(x, y, z);
  return coordIndex.flatMap((i) => (i < 0 ? [] : coord.slice(i * 3, i * 3 + 3)));
};

/** Height at which a body of this geometry rests on the floor. */
async function restHeight(geometry: object | object[], fields: object = {}): Promise<number> {
  const w = await world();
  addFloor(w);
  const body = addBody(w, {
    position: [0, 3, 0],
    geometry: [geometry].flat(),
    ...fields,
  });
  w.advance(3);
  return height(body);
}

const shear = [1, 0.5, 0, 0, 1, 0, 0, 0, 1];

const HEIGHTS: [what: string, geometry: object, height: number, tolerance: number][] = [
  ['a box at half its size', box(1, 2, 3), 1, 1e-3],
  ['a box of default size at 1', { type: 'Box' }, 1, 1e-3],
  ['a sphere at its radius', sphere(0.7), 0.7, 1e-3],
  ['a cylinder at half its height', { type: 'Cylinder', radius: 1, height: 0.8 }, 0.4, 2e-3],
  [
    'a cone on its base at half its height, 5 mm thicker at most',
    { type: 'Cone', bottomRadius: 1, height: 1 },
    0.5,
    6e-3,
  ],
  ['an IndexedFaceSet as its hull, 5 mm thicker at most', faces(1, 2, 3), 1, 6e-3],
  ['an IndexedTriangleSet as its hull', indexedTriangles(1, 2, 3), 1, 6e-3],
  ['a TriangleSet as its hull', triangles(1, 2, 3), 1, 6e-3],
  [
    'a cone cut off at the top as its hull',
    { type: 'Cone', bottomRadius: 1, topRadius: 0.5, height: 1 },
    0.5,
    6e-3,
  ],
  ['a QuadSet as its hull', { type: 'QuadSet', coord: quads(1, 2, 3) }, 1, 6e-3],
  [
    'an IndexedQuadSet as its hull',
    {
      type: 'IndexedQuadSet',
      coord: quads(1, 2, 3),
      index: Array.from({ length: 24 }, (_, i) => i),
    },
    1,
    6e-3,
  ],
  ['a flat thin box at half its thickness', box(1, 0.002, 1), 0.001, 1e-3],
  ['a scaled box', { ...box(1), linear: [3, 0, 0, 0, 2, 0, 0, 0, 3] }, 1, 1e-3],
  ['an evenly scaled sphere', { ...sphere(0.5), linear: [2, 0, 0, 0, 2, 0, 0, 0, 2] }, 1, 1e-3],
  [
    'an unevenly scaled sphere as a hull',
    { ...sphere(0.5), linear: [2, 0, 0, 0, 1, 0, 0, 0, 2] },
    0.5,
    1e-2,
  ],
  ['a mirrored box', { ...faces(1, 2, 3), linear: [-1, 0, 0, 0, 1, 0, 0, 0, 1] }, 1, 6e-3],
  ['a sheared box', { ...box(3, 1, 3), linear: shear }, 0.5, 6e-3],
  ['a cylinder without a top', { type: 'Cylinder', radius: 1, height: 0.8, top: false }, 0.4, 1e-2],
  [
    'a geometry moved in its collidable',
    { ...box(1), translation: [0, -0.5, 0], rotation: [0, 0, 1, Math.PI / 2] },
    1,
    1e-3,
  ],
  [
    'a box a millimetre thin moved far down',
    { ...box(2, 0.01, 2), translation: [0, -1, 0] },
    1.005,
    5e-3,
  ],
];

for (const [what, geometry, expected, tolerance] of HEIGHTS) {
  fact(`rests: ${what}`, async () => {
    close(await restHeight(geometry), expected, tolerance, 'm');
  });
}

fact('rests: a compound on its lowest part', async () => {
  const offset = { type: 'CollidableOffset', translation: [0, -1, 0], collidable: box(2, 1, 2) };
  close(await restHeight([sphere(0.3), offset]), 1.5, 2e-3, 'm');
});

fact('rests: a compound on a compound', async () => {
  const w = await world();
  const halves = [0.5, -0.5].map((y) => ({
    type: 'CollidableOffset',
    translation: [0, y, 0],
    collidable: box(1),
  }));
  addBody(w, { fixed: true, position: [0, -1, 0], geometry: halves });
  const upper = addBody(w, { position: [0, 3, 0], geometry: halves });
  w.advance(3);
  close(height(upper), 1, 2e-3, 'm');
});

fact('rests: a body on a fixed mesh as on the true surface', async () => {
  for (const [name, make] of Object.entries({ faces, indexedTriangles, triangles })) {
    const w = await world();
    addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [make(20, 1, 20)] });
    const stone = addBody(w, { position: [0, 1, 0], geometry: [box(1)] });
    w.advance(2);
    close(height(stone), 0.5, 2e-3, `m on ${name}`);
  }
});

fact('flat geometry, strips and fans carry bodies where they are fixed', async () => {
  const lying = { rotation: [1, 0, 0, -Math.PI / 2] };
  const corners = [-5, 0, 5, 5, 0, 5, -5, 0, -5, 5, 0, -5];
  const round = [-5, 0, 5, 5, 0, 5, 5, 0, -5, -5, 0, -5];
  for (const ground of [
    { type: 'Rectangle2D', size: [10, 10], ...lying },
    { type: 'Disk2D', outerRadius: 5, ...lying },
    { type: 'TriangleStripSet', coord: corners, stripCount: [4] },
    { type: 'TriangleFanSet', coord: round, fanCount: [4] },
    { type: 'IndexedTriangleStripSet', coord: corners, index: [0, 1, 2, 3, -1] },
    { type: 'IndexedTriangleFanSet', coord: round, index: [0, 1, 2, 3, -1] },
  ]) {
    const w = await world();
    addBody(w, { fixed: true, geometry: [ground] });
    const ball = addBody(w, { position: [1, 1, -1] });
    w.advance(1);
    close(height(ball), 0.5, 2e-3, `m on a ${ground.type}`);
  }
});

fact('a fixed torus lets a ball through its hole, and a disk with a hole too', async () => {
  const lying = { rotation: [1, 0, 0, -Math.PI / 2] };
  for (const ring of [
    { type: 'Torus', innerRadius: 0.5, outerRadius: 3, ...lying },
    { type: 'Disk2D', innerRadius: 1, outerRadius: 5, ...lying },
  ]) {
    const w = await world();
    addBody(w, { fixed: true, geometry: [ring] });
    const through = addBody(w, { position: [0, 2, 0] });
    const held = addBody(w, { position: [3, 2, 0] });
    w.advance(0.7);
    assert.ok(height(through) < 0, `m through a ${ring.type}`);
    assert.ok(height(held) > 0.4, `m on a ${ring.type}`);
  }
});

fact('a fixed mesh is hollow where its hull would be full', async () => {
  const w = await world();
  // A valley along Z: 45° walls that meet at y = 0.
  const valley = {
    type: 'IndexedFaceSet',
    coord: [-3, 3, -5, 0, 0, -5, 3, 3, -5, -3, 3, 5, 0, 0, 5, 3, 3, 5],
    coordIndex: [0, 3, 4, 1, -1, 1, 4, 5, 2, -1],
  };
  const ground = addBody(w, { fixed: true, geometry: [valley] });
  const ball = addBody(w, { position: [0, 2, 0] });
  w.advance(4);
  // Touching both walls.
  close(position(ball), [0, 0.5 * Math.SQRT2, 0], 5e-3, 'm, in the valley');
  // Made movable it is its hull: a roof on y = 3 instead of the valley.
  claim(w, 'concave-dynamic');
  ground.set('useGlobalGravity', false);
  ground.set('fixed', false);
  ground.set('mass', 1e5);
  ball.event('position', [0, 4, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(1);
  close(height(ball) - height(ground), 3.5, 0.02, 'm, on the hull');
});

fact('a fixed cylinder without a top catches a ball inside, with one on top', async () => {
  for (const [top, expected] of [
    [false, -0.5],
    [true, 1.5],
  ] as const) {
    const w = await world();
    const can = { type: 'Cylinder', radius: 2, height: 2, top };
    addBody(w, { fixed: true, geometry: [can] });
    const ball = addBody(w, { position: [0, 3, 0] });
    w.advance(3);
    close(height(ball), expected, 1e-2, `m, top ${top}`);
  }
});

fact('an ElevationGrid carries bodies at its heights, between its points too', async () => {
  const w = await world();
  const [x, z] = [5, 4];
  // A slope of 1 : 4 along X, from its corner as X3D has it.
  const grid = {
    type: 'ElevationGrid',
    xDimension: x,
    zDimension: z,
    xSpacing: 2,
    zSpacing: 3,
    height: Array.from({ length: x * z }, (_, i) => 0.5 * (i % x)),
  };
  addBody(w, { fixed: true, geometry: [grid] });
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [1, 1] });
  for (const at of [1, 3.3, 5]) {
    const stone = addBody(w, {
      position: [at, 0.25 * at + 0.3, 4.5],
      orientation: [0, 0, 1, Math.atan(0.25)],
      geometry: [box(0.4)],
    });
    w.advance(1);
    close(height(stone), 0.25 * position(stone)[0] + 0.2 * Math.hypot(1, 0.25), 5e-3, 'm');
    stone.remove();
  }
});

fact('malformed meshes are cleaned: indices without points are left out', async () => {
  const mesh = faces(2, 2, 2);
  mesh.coordIndex.push(0, 1, 99, -1, 5, -1, -7, -1);
  close(await restHeight(mesh), 1, 6e-3, 'm');
  assert.ok(true);
});

fact('a body that is told where it starts has its shape there, too', async () => {
  const w = await world();
  addFloor(w);
  const geometry = [sphere(0.5)];
  const body = w.add('RigidBody', { geometry }, { start: { p: [1, 3, 0], q: [0, 0, 0, 1] } });
  w.advance(3);
  close(position(body)[1]!, 0.5, 0.01, 'm');
});
