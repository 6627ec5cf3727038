import assert from 'node:assert/strict';
import { levelNames } from '../../../../../physics-core/dynamics/levels.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  claim,
  close,
  fact,
  height,
  position,
  sphere,
  spin,
  velocity,
  world,
  type Body,
} from '../../../../core/helpers.js';
import { GRAVITY, dropped, flight } from '../../../../core/effects/hits/scenes.js';

for (const accuracy of levelNames) {
  fact(`at ${accuracy} a ball keeps its height over ten bounces`, async () => {
    const { w, ball } = await dropped(accuracy, 1);
    for (let i = 0; i < 140; i++) {
      w.advance(0.1);
      // 2.17 m at the tenth bounce before hits had a time within the step.
      close(flight(ball), 2, 1e-3, 'm');
    }
  });

  fact(`at ${accuracy} each bounce is as high as the law of e says, at its time`, async () => {
    const { w, ball } = await dropped(accuracy, 0.8);
    const fall = Math.sqrt(4 / GRAVITY);
    let [peak, middle] = [2, 0];
    for (let i = 0; i < 4; i++) {
      middle += fall * (0.8 ** i + (i > 0 ? 0.8 ** i : 0));
      if (i > 0) {
        w.advance(middle - fall * 0.8 ** i - w.time);
        close(flight(ball), peak, 1e-3, 'm, of the flight');
      }
      peak *= 0.64;
    }
  });

  fact(`at ${accuracy} a thrown block stops on its line after v² / 2 μ g`, async () => {
    const friction = 0.4;
    for (const angle of [0, Math.PI / 4, 1]) {
      const w = await world({ accuracy, gravity: [0, -GRAVITY, 0] });
      addFloor(w);
      w.add('CollisionCollection', {
        collidables: '*',
        frictionCoefficients: [friction, friction],
      });
      const block = addBody(w, {
        position: [0, 0.1, 0],
        geometry: [box(1, 0.2, 1)],
        linearVelocity: [3 * Math.cos(angle), 0, 3 * Math.sin(angle)],
      });
      w.advance(1);
      const way = 9 / (2 * friction * GRAVITY);
      const [x, , z] = position(block);
      close([x, z], [way * Math.cos(angle), way * Math.sin(angle)], 1e-3, 'm');
    }
  });

  fact(
    `at ${accuracy} a ball launched without spin comes to roll at 5/7 of its speed`,
    async () => {
      const w = await world({ accuracy, gravity: [0, -GRAVITY, 0] });
      addFloor(w);
      w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0.3, 0.3] });
      const ball = addBody(w, { position: [0, 0.5, 0], linearVelocity: [5, 0, 0] });
      w.advance(1);
      close(velocity(ball)[0], 25 / 7, 1e-3, 'm/s');
      close(spin(ball)[2], -50 / 7, 5e-3, 'rad/s');
      const slides = 10 / (7 * 0.3 * GRAVITY);
      const way = 5 * slides - (0.3 * GRAVITY * slides ** 2) / 2 + (25 / 7) * (1 - slides);
      close(position(ball)[0], way, 1e-3, 'm');
    },
  );

  fact(`at ${accuracy} a bullet never comes behind a thin wall, whatever its shape`, async () => {
    for (const geometry of [sphere(0.01), box(0.02), box(0.1, 0.01, 0.01)]) {
      const w = await world({ accuracy, gravity: [0, 0, 0] });
      addBody(w, { fixed: true, position: [10, 0, 0], geometry: [box(0.02, 4, 4)] });
      const bullet = addBody(w, { mass: 0.01, linearVelocity: [300, 0, 0], geometry: [geometry] });
      for (let i = 0; i < 0.1 / w.timeStep; i++) {
        w.step();
        below(position(bullet)[0], 10, 'm');
      }
      close(position(bullet)[0], 9.97, 0.05, 'm');
    }
  });
}

fact(
  'a bullet leaves a wall with the share of its speed that bounces, at the time it met it',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    addBody(w, { fixed: true, position: [10, 0, 0], geometry: [box(0.02, 4, 4)] });
    w.add('CollisionCollection', { collidables: '*', bounce: 0.5 });
    const bullet = addBody(w, { geometry: [sphere(0.05)], linearVelocity: [300, 0, 0] });
    w.advance(0.05);
    close(velocity(bullet), [-150, 0, 0], 0.01, 'm/s');
    const there = 9.94 / 300;
    close(position(bullet)[0], 9.94 - 150 * (0.05 - there), 1e-3, 'm');
  },
);

fact('a bullet gives its momentum to what it hits', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const plate = addBody(w, { mass: 3, position: [10, 0, 0], geometry: [box(0.02, 4, 4)] });
  const bullet = addBody(w, { geometry: [sphere(0.05)], linearVelocity: [300, 0, 0] });
  w.advance(0.1);
  close([velocity(bullet)[0], velocity(plate)[0]], [75, 75], 0.5, 'm/s');
  below(position(bullet)[0], position(plate)[0], 'm');
});

fact('a bullet flies through what it does not collide with', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const collider = w.add('CollisionCollection', { collidables: [] });
  w.settings.set('collider', collider);
  claim(w, 'not-in-collider');
  addBody(w, { fixed: true, position: [10, 0, 0], geometry: [box(0.02, 4, 4)] });
  const bullet = addBody(w, { geometry: [sphere(0.05)], linearVelocity: [300, 0, 0] });
  w.advance(0.1);
  close(position(bullet)[0], 30, 0.01, 'm');
});

fact(
  'continuous collision is on because of a body that is fast for its size, and only then',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const report = () => w.effects.find(({ name }) => name === 'continuous collision')!;
    const ball = addBody(w, { geometry: [sphere(0.05)], linearVelocity: [5, 0, 0] });
    w.step(2);
    assert.equal(report().active, false);
    ball.set('linearVelocity', [30, 0, 0]);
    w.step(2);
    assert.equal(report().active, true);
    assert.equal(report().because!.reason, 'passes more than half its size in a step');
    ball.set('linearVelocity', [5, 0, 0]);
    w.step(2);
    assert.equal(report().active, false);
  },
);

fact('a fast ball is never seen inside the floor that turns it back', async () => {
  for (const accuracy of levelNames) {
    const { w, ball } = await dropped(accuracy, 0.9, 5);
    for (let i = 0; i < 2 / w.timeStep; i++) {
      w.step();
      above(height(ball), 0.4995, 'm');
    }
  }
});

fact('what a bullet hit by itself is over when it has flown on', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const wall = addBody(w, { fixed: true, geometry: [box(0.02, 4, 4)] });
  const bullet = addBody(w, {
    position: [-2.9, 0, 0],
    geometry: [sphere(0.05)],
    linearVelocity: [300, 0, 0],
  });
  const log: string[] = [];
  wall.on('collisionstart', () => log.push('start'));
  wall.on('collisionend', () => log.push('end'));
  w.advance(0.1);
  below(position(bullet)[0], 0, 'm, before the wall');
  bullet.set('linearVelocity', [-1, 0, 0]);
  w.advance(0.5);
  assert.deepEqual(log, ['start', 'end']);
});

fact('a fast link does not hit the one that it hangs on', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const [one, two] = [0, 0.09].map((x) =>
    addBody(w, { position: [x, 0, 0], geometry: [sphere(0.05)], linearVelocity: [0, 40, 0] }),
  ) as [Body, Body];
  addJoint(w, 'BallJoint', { body1: one, body2: two, anchorPoint: [0.045, 0, 0] });
  for (const body of [one, two]) body.set('angularVelocity', [0, 0, 0]);
  w.advance(0.5);
  for (const [i, body] of [one, two].entries()) close(position(body), [0.09 * i, 20, 0], 1e-3, 'm');
});
