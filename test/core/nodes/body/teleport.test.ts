import assert from 'node:assert/strict';
import {
  addBody,
  claim,
  close,
  codes,
  fact,
  position,
  spin,
  velocity,
  world,
  WEIGHTLESS,
  overflow,
} from '../../helpers.js';

fact(
  'teleport takes velocities; what is left out stays, also about a centre of mass aside',
  async () => {
    for (const centerOfMass of [
      [0, 0, 0],
      [0.3, 0, 0],
    ]) {
      // prettier-ignore
      const w = await world(WEIGHTLESS);
      claim(w, 'bad-value');
      const ball = addBody(w, {
        linearVelocity: [1, 0, 0],
        angularVelocity: [0, 0, 2],
        centerOfMass,
      });
      w.step();
      const linear = velocity(ball);
      ball.teleport([0, 9, 0], [0, 1, 0, 1]);
      close(velocity(ball), linear, 1e-5, 'm/s, kept');
      close(spin(ball), [0, 0, 2], 1e-5, 'rad/s, kept');
      ball.teleport([0, 0, 0], undefined, { linearVelocity: [0, 3, 0] });
      close(ball.get('orientation') as number[], [0, 1, 0, 1], 1e-6, 'kept');
      close(velocity(ball), [0, 3, 0], 1e-5, 'm/s');
      close(spin(ball), [0, 0, 2], 1e-5, 'rad/s, kept');
      ball.sleep();
      ball.teleport([0, 0, 0], [0, 0, 1, 0], {
        linearVelocity: [2, 0, 0],
        angularVelocity: [0, 0, 0],
      });
      assert.equal(ball.sleeping, false);
      w.advance(1);
      close(position(ball), [2, 0, 0], 1e-4, 'm, with that velocity');
      const at = position(ball);
      ball.teleport([7, 7, 7], undefined, { linearVelocity: 'up' as never });
      ball.teleport([7, 7, 7], [1] as never);
      close(position(ball), at, 0, 'm, all or nothing');
    }
  },
);

fact('teleport puts a body back that had lost its numbers', async () => {
  const w = await world(WEIGHTLESS);
  claim(w, 'nan-state');
  const ball = addBody(w, { mass: 0.1 });
  overflow(ball, [1e38, 0, 0]);
  w.step(2);
  assert.deepEqual(codes(w), ['nan-state']);
  ball.teleport([1, 0, 0], undefined, { linearVelocity: [1, 0, 0] });
  w.advance(1);
  close(position(ball), [2, 0, 0], 1e-4, 'm');
  assert.deepEqual(w.problems, []);
});
