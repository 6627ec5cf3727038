import { flatFaces } from '../../../physics-core/shapes/forms/flat-faces.js';
import { PolytopeForm } from '../../../physics-core/shapes/forms/polytope.js';
import { addBody, addFloor, below, box, close, fact, height, sphere, world } from '../helpers.js';

const triangle = (coord: number[]) => ({ type: 'IndexedTriangleSet', coord, index: [0, 1, 2] });

const FLAT = {
  'a rectangle': { type: 'Rectangle2D', size: [1, 1] },
  'a disc': { type: 'Disk2D', innerRadius: 0, outerRadius: 0.5 },
  'a ring': { type: 'Disk2D', innerRadius: 0.3, outerRadius: 0.5 },
  'the bottom of a cylinder': { type: 'Cylinder', radius: 0.5, height: 0, side: false, top: false },
  'a triangle': triangle([-0.5, -0.5, 0, 0.5, -0.5, 0, 0, 0.5, 0]),
};

for (const [name, geometry] of Object.entries(FLAT))
  fact(`${name} without thickness falls onto a box and lies there`, async () => {
    const w = await world();
    addBody(w, { fixed: true, geometry: [box(4, 1, 4)] });
    const level = geometry.type === 'Cylinder' ? [1, 0, 0, 0] : [1, 0, 0, Math.PI / 2];
    const sheet = addBody(w, { position: [0, 1, 0], orientation: level, geometry: [geometry] });
    w.advance(2);
    // 0.1 mm is the margin that Bullet gives it.
    close(height(sheet), 0.5, 1e-3, 'm');
  });

fact('sheets lie on a ball and on each other', async () => {
  const w = await world();
  addBody(w, { fixed: true, geometry: [box(4, 1, 4)] });
  addBody(w, { fixed: true, position: [9, 0, 0], geometry: [sphere(0.5)] });
  const level = [1, 0, 0, Math.PI / 2];
  const sheet = (position: number[]) =>
    addBody(w, { position, orientation: level, geometry: [FLAT['a rectangle']] });
  const [below, above, onBall] = [sheet([0, 0.7, 0]), sheet([0, 0.9, 0]), sheet([9, 0.7, 0])];
  w.advance(1);
  close([height(below), height(above), height(onBall)], [0.5, 0.5, 0.5], 2e-3, 'm');
});

fact('a line and a point have forms, too, and where they stand nothing throws', async () => {
  for (const coord of [
    [0, 0, 0, 1, 1, 0, 0.5, 0.5, 0],
    [0.3, 0, 0, 0.3, 0, 0, 0.3, 0, 0],
  ]) {
    const w = await world();
    addFloor(w);
    const thin = addBody(w, { position: [0, 1, 0], geometry: [triangle(coord)] });
    for (let i = 0; i < 240; i++) {
      w.step();
      below(Math.hypot(...(thin.get('linearVelocity') as number[])), 6, 'm/s');
    }
  }
});

fact('the form of a sheet is its outline, once from each side', () => {
  const out = new Float64Array(30);
  const form = new PolytopeForm(flatFaces([0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 2, 0.5, 0.5, 2]));
  for (const up of [1, -1]) {
    const face = form.facing(0, 0, up, out);
    close([out[0]!, out[1]!, out[2]!], [0, 0, up], 1e-12);
    close(form.face(face, out), 4, 0, 'corners');
    const [ux, uy, vx, vy] = [out[3]! - out[0]!, out[4]! - out[1]!, out[6]! - out[3]!, out[7]! - out[4]!]; // prettier-ignore
    close(ux * vy - uy * vx, up, 1e-12, 'they go against the clock as seen from outside');
  }
});
