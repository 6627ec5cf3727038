import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  box,
  claim,
  close,
  fact,
  sphere,
  spin,
  world,
  type Body,
  WEIGHTLESS,
} from '../../helpers.js';

/** kg m² about x, by what a torque makes of the spin in one step. */
function inertia(body: Body): number {
  const [before] = spin(body);
  body.applyTorque([100, 0, 0]);
  (body.world as World).step();
  return (100 * body.world.timeStep) / (spin(body)[0] - before);
}

fact('a massDensityModel that is none leaves the body the inertia of its geometry', async () => {
  const w = await world(WEIGHTLESS);
  claim(w, 'bad-value', 'misplaced');
  const plain = addBody(w, { geometry: [box(1, 2, 3)] });
  const models = [
    { type: 'Sphere', radius: Infinity },
    { type: 'Sphere', radius: 1e39 },
    { type: 'Box', size: [1, NaN, 1] },
    { type: 'Banana' },
    { type: 'BallJoint' },
    { radius: 1 },
    'Sphere',
    plain,
  ];
  const bodies = models.map((massDensityModel, i) =>
    addBody(w, { massDensityModel, position: [9 * (i + 1), 0, 0], geometry: [box(1, 2, 3)] }),
  );
  w.advance(0.5);
  assert.equal(w.paused, false);
  for (const body of bodies) {
    close(inertia(body), 13 / 12, 1e-4, 'kg m²');
    assert.equal(w.problemsOf(body).length, 1);
    assert.equal(w.problemsOf(body)[0]!.attribute, 'massDensityModel');
    body.set('massDensityModel', sphere(2));
    w.step(0);
    assert.deepEqual(w.problemsOf(body), [], 'mended');
    close(inertia(body), 1.6, 1e-4, 'kg m²');
  }
});
