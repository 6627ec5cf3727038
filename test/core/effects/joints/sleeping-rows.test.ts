import { jointSolve } from '../../../../physics-core/inside.js';
import { addBody, addJoint, below, close, fact, sphere, velocity, world } from '../../helpers.js';
import type { World } from '../../../../physics-core/inside.js';

/** A ball on its way to two of its kind, a metre apart, that a joint holds together. */
function shot(w: World) {
  w.add('CollisionCollection', { collidables: '*', bounce: 1 });
  const ball = (x: number, speed = 0) =>
    addBody(w, { position: [x, 0, 0], linearVelocity: [speed, 0, 0], geometry: [sphere(0.2)] });
  const [cue, one, two] = [ball(-2, 3), ball(0), ball(1)];
  const joint = addJoint(w, 'BallJoint', { body1: one, body2: two, anchorPoint: [0.5, 0, 0] });
  return { cue, one, two, joint };
}

fact('the first touch meets all that a joint holds together', async () => {
  const w = await world({ gravity: [0, 0, 0], rest: 'never' });
  const { cue, one, two } = shot(w);
  w.advance(1.5);
  // One kilogram against two, elastic: (1 - 2) / 3 and 2 / 3 of the speed.
  close(velocity(cue)[0], -1, 1e-4, 'm/s');
  for (const ball of [one, two]) close(velocity(ball)[0], 2, 1e-4, 'm/s');
});

fact('so does the first touch of bodies that sleep', async () => {
  const w = await world({ gravity: [0, 0, 0], rest: 'never' });
  const { cue, one, two } = shot(w);
  w.advance(0.1);
  one.sleep();
  two.sleep();
  w.advance(1.4);
  close(velocity(cue)[0], -1, 1e-4, 'm/s');
  for (const ball of [one, two]) close(velocity(ball)[0], 2, 1e-4, 'm/s');
});

fact('where the solve is switched off in mid-run, Bullet holds the joints', async () => {
  const w = await world({ accuracy: 'fine', gravity: [0, -9.81, 0], rest: 'never' });
  const ball = addBody(w, { position: [1, 0, 0], geometry: [sphere(0.2)] });
  const joint = addJoint(w, 'BallJoint', { body1: ball, anchorPoint: [0, 0, 0] });
  w.advance(0.5);
  w.registry.get(jointSolve).on = false;
  w.advance(0.5);
  below(joint.gap, 0.01, 'm');
});
