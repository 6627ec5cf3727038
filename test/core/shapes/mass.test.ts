import { addBody, box, close, fact, sphere, spin, world, type Vec3 } from '../helpers.js';
import { faces, indexedTriangles, triangles } from './meshes.js';

/** Moments of inertia, kg·m², seen in the spin that 1 N·m gives in one step. */
async function moments(geometry: object | object[], fields: object = {}): Promise<Vec3> {
  const w = await world({ gravity: [0, 0, 0] });
  const body = addBody(w, { geometry: [geometry].flat(), ...fields });
  return [0, 1, 2].map((axis) => {
    body.event('angularVelocity', [0, 0, 0]);
    body.event('orientation', [0, 0, 1, 0]);
    body.applyTorque([0, 1, 2].map((i) => (i === axis ? 1 : 0)) as Vec3);
    w.step();
    return w.timeStep / spin(body)[axis]!;
  }) as Vec3;
}

const cuboid = (m: number, x: number, y: number, z: number): Vec3 => [
  (m * (y * y + z * z)) / 12,
  (m * (x * x + z * z)) / 12,
  (m * (x * x + y * y)) / 12,
];

const MOMENTS: [what: string, geometry: object, moments: Vec3, tolerance: number][] = [
  ['box: m (a² + b²) / 12', box(1, 2, 3), cuboid(2, 1, 2, 3), 1e-3],
  ['sphere: 2/5 m r²', sphere(1.5), [1.8, 1.8, 1.8], 1e-3],
  [
    'cylinder: m r² / 2 and m (3 r² + h²) / 12',
    { type: 'Cylinder', radius: 1, height: 3 },
    [2, 1, 2],
    1e-3,
  ],
  [
    // About its origin at half height: 3/80 m (4 r² + h²) and m (h / 4)² more.
    'cone about its origin',
    { type: 'Cone', bottomRadius: 1, height: 2 },
    [0.6 + 0.5, 0.6, 0.6 + 0.5],
    1e-3,
  ],
  ['IndexedFaceSet by its volume', faces(1, 2, 3), cuboid(2, 1, 2, 3), 1e-3],
  ['IndexedTriangleSet by its volume', indexedTriangles(1, 2, 3), cuboid(2, 1, 2, 3), 1e-3],
  ['TriangleSet by its volume', triangles(1, 2, 3), cuboid(2, 1, 2, 3), 1e-3],
  ['scaled box', { ...box(1), linear: [1, 0, 0, 0, 2, 0, 0, 0, 3] }, cuboid(2, 1, 2, 3), 1e-3],
  [
    'ellipsoid: m (b² + c²) / 5',
    { ...sphere(1), linear: [1, 0, 0, 0, 2, 0, 0, 0, 3] },
    [(2 * 13) / 5, (2 * 10) / 5, (2 * 5) / 5],
    1e-3,
  ],
  ['turned box', { ...box(1, 2, 3), rotation: [0, 0, 1, Math.PI / 2] }, cuboid(2, 2, 1, 3), 1e-3],
];

for (const [what, geometry, expected, tolerance] of MOMENTS) {
  fact(`inertia of a ${what}`, async () => {
    close(await moments(geometry, { mass: 2 }), expected, tolerance, 'kg·m²');
  });
}

fact('inertia of a compound: each part by its share of the volume and its distance', async () => {
  const ball = (x: number) => ({
    type: 'CollidableOffset',
    translation: [x, 0, 0],
    collidable: sphere(0.5),
  });
  // Two balls of 1 kg two metres apart: 2/5 r² + d² each.
  close(await moments([ball(-1), ball(1)], { mass: 2 }), [0.2, 2.2, 2.2], 1e-3, 'kg·m²');
});

fact('inertia about the centre of mass that is authored', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const body = addBody(w, { geometry: [box(1)], centerOfMass: [0, 0, 2], torques: [[0, 1, 0]] });
  w.advance(0.1);
  close(spin(body)[1], 0.1 / (1 / 6 + 4), 1e-4, 'rad/s');
});

fact('a needle keeps its moments within a ratio of ten thousand (S15)', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const needle = addBody(w, { geometry: [box(10, 0.001, 0.001)], torques: [[1e-4, 0, 0]] });
  w.advance(1);
  // 100/12 kg·m² across, so 1/1200 along.
  close(spin(needle)[0], 0.12, 2e-3, 'rad/s');
});
