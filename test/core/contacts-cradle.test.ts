import assert from 'node:assert/strict';
import type { World } from '../../physics-core/index.js';
import {
  addBody,
  addJoint,
  close,
  fact,
  position,
  sphere,
  velocity,
  world,
  type Body,
  type Node,
} from './helpers.js';

interface Cradle {
  w: World;
  balls: Body[];
  collection: Node;
}

/** Balls of 0.2 m that hang on strings of 2 m, `gap` metres apart. */
async function cradle(count: number, gap: number): Promise<Cradle> {
  const w = await world({ accuracy: 'precise' });
  const shapes = Array.from({ length: count }, () =>
    w.add('CollidableShape', { shape: [sphere(0.2)] }),
  );
  const balls = shapes.map((shape, i) =>
    addBody(w, { position: [i * (0.4 + gap), 0, 0], geometry: [shape] }),
  );
  for (const ball of balls)
    addJoint(w, 'SingleAxisHingeJoint', {
      body1: ball,
      axis: [0, 0, 1],
      anchorPoint: [position(ball)[0], 2, 0],
    });
  const collection = w.add('CollisionCollection', {
    collidables: shapes,
    frictionCoefficients: [0, 0],
    minBounceSpeed: 0,
  });
  return { w, balls, collection };
}

fact(
  'in a cradle with gaps of 1 mm, bounce 1 set at run time, the far ball takes over the swing',
  async () => {
    const { w, balls, collection } = await cradle(5, 0.001);
    w.advance(0.2);
    collection.set('bounce', 1);
    balls[0]!.event('linearVelocity', [-1, 0, 0]);
    const period = 2 * Math.PI * Math.sqrt(2 / 9.8);
    // Out and back: half a period, then the hit goes through.
    w.advance(period / 2 + 0.1);
    const speeds = balls.map((ball) => velocity(ball)[0]);
    const expected = Math.cos((0.1 / period) * 2 * Math.PI);
    close(speeds.slice(0, 4), [0, 0, 0, 0], 0.05, 'm/s, the first four');
    close(speeds[4]!, expected, 0.05, 'm/s, the last');
  },
);

fact(
  'touching balls part by Newton’s law for all at once: the far ball gets 2/3 of the speed, and no energy is lost',
  async () => {
    const { w, balls, collection } = await cradle(3, 0);
    w.advance(0.2);
    collection.set('bounce', 1);
    balls[0]!.event('linearVelocity', [-1, 0, 0]);
    const period = 2 * Math.PI * Math.sqrt(2 / 9.8);
    w.advance(period / 2 + 0.02);
    close(
      balls.map((ball) => velocity(ball)[0]),
      [-1 / 3, 2 / 3, 2 / 3],
      0.05,
      'm/s after the first hit',
    );
    // The most that the far ball gets in each of ten swings; more than all of the speed would be energy from nothing.
    const shares = Array.from({ length: 10 }, () => {
      let most = 0;
      for (let t = 0; t < period; t += w.timeStep) {
        w.step();
        most = Math.max(most, Math.abs(velocity(balls[2]!)[0]));
      }
      return most;
    });
    if (process.env.SHARES) console.log(shares.map((share) => share.toFixed(2)).join(' '));
    assert.ok(Math.min(...shares) > 0.5 && Math.max(...shares) < 1.02, shares.join(' '));
  },
);
