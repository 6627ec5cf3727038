import assert from 'node:assert/strict';
import { addBody, addJoint, close, fact, height, way, world, codes } from '../../helpers.js';
import { only } from '../problems.js';

fact('a joint that names nobody is told and holds once it names somebody', async () => {
  const w = await world();
  const joint = addJoint(w, 'BallJoint', {});
  w.step();
  only(w, 'no-body');
  assert.equal(w.stats.joints, 0);
  const ball = addBody(w);
  joint.set('body2', ball);
  w.advance(0.5);
  close(height(ball), 0, 1e-4, 'm');
  assert.deepEqual(codes(w), []);
});

fact('a joint that names one body twice is told, holds nothing and breaks nothing', async () => {
  const w = await world();
  const ball = addBody(w);
  const joint = addJoint(w, 'BallJoint', { body1: ball, body2: ball });
  w.advance(0.5);
  close(height(ball), -way(9.8, 0.5), 1e-3, 'm');
  only(w, 'same-body');
  joint.set('body2', null);
  w.step(0);
  assert.deepEqual(codes(w), [], 'cured');
});

fact('masses very unlike on one joint are told', async () => {
  const w = await world();
  const [light, heavy] = [addBody(w, { mass: 0.01 }), addBody(w, { mass: 50 })];
  addJoint(w, 'BallJoint', { body1: light, body2: heavy });
  w.step();
  close(only(w, 'mass-ratio').value as number, 5000, 1e-6);
});

fact('a hinge without a direction is told and takes Y', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { angularVelocity: [1, 2, 3] });
  const hinge = addJoint(w, 'SingleAxisHingeJoint', { body1: ball, axis: [0, 0, 0] });
  w.advance(0.2);
  assert.equal(only(w, 'bad-value').attribute, 'axis');
  close(ball.get('angularVelocity') as number[], [0, 2, 0], 2e-3, 'rad/s');
  hinge.set('axis', [0, 0, 1]);
  w.step();
  assert.deepEqual(codes(w), []);
});
