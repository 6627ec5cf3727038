import {
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  fact,
  height,
  spin,
  velocity,
  world,
} from './helpers.js';

// Closed forms across nodes. Cases that break engines stand in the stability matrix (test/stability).

fact('a ball spins on for a million radians without losing its rate', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { angularVelocity: [0, 0, 5] });
  w.step(12_000);
  close(spin(ball), [0, 0, 5], 1e-6, 'rad/s');
  const pose = ball.readPose(new Float64Array(7));
  close(Math.hypot(...Array.from(pose).slice(3)), 1, 1e-6, '|q|');
});

fact('a ladder of bounces: peaks h e²ⁿ', async () => {
  for (const e of [1, 0.8, 0.5]) {
    const w = await world({ accuracy: 'precise' });
    addFloor(w);
    const ball = addBody(w, { position: [0, 2.5, 0] });
    w.add('CollisionCollection', { collidables: '*', bounce: e });
    for (let n = 1; n <= 3; n++) {
      while (velocity(ball)[1] <= 0) w.step();
      while (velocity(ball)[1] > 0) w.step();
      close(height(ball) - 0.5, 2 * e ** (2 * n), 0.03 * n, `m, peak ${n} at ${e}`);
    }
  }
});

fact(
  'a block on a slope sticks below tan θ = μ and slides with g (sin θ - μ cos θ) above',
  async () => {
    for (const theta of [0.35, 0.6]) {
      const w = await world({
        accuracy: 'fine',
        gravity: [9.8 * Math.sin(theta), -9.8 * Math.cos(theta), 0],
      });
      addFloor(w);
      const block = addBody(w, { position: [0, 0.25, 0], geometry: [box(1, 0.5, 1)] });
      w.advance(1);
      // Nobody says otherwise: friction is 0.5, and tan 0.35 = 0.365, tan 0.6 = 0.684.
      const a = theta < 0.5 ? 0 : 9.8 * (Math.sin(theta) - 0.5 * Math.cos(theta));
      close(velocity(block)[0], a, 0.06, `m/s at ${theta}`);
    }
  },
);

fact('a ball rolls down a slope with 5/7 g sin θ and does not slip', async () => {
  const theta = 0.3;
  const w = await world({
    accuracy: 'fine',
    gravity: [9.8 * Math.sin(theta), -9.8 * Math.cos(theta), 0],
  });
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.5, 0] });
  w.advance(1);
  const v = (5 / 7) * 9.8 * Math.sin(theta);
  close(velocity(ball)[0], v, 0.02, 'm/s');
  close(spin(ball)[2], -v / 0.5, 0.05, 'rad/s');
});

fact('a ball thrown without spin rolls from 5/7 of its speed on', async () => {
  const w = await world({ accuracy: 'fine' });
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.5, 0], linearVelocity: [7, 0, 0] });
  // 2 v / (7 μ g) = 0.41 s.
  w.advance(1);
  close(velocity(ball)[0], 5, 0.05, 'm/s');
  close(spin(ball)[2], -10, 0.1, 'rad/s');
});

fact('two balls head on share their momentum as m₁, m₂ and e say', async () => {
  for (const e of [0, 0.5, 1]) {
    const w = await world({ gravity: [0, 0, 0], accuracy: 'fine' });
    const [a, b] = [
      addBody(w, { mass: 1, position: [-1, 0, 0], linearVelocity: [3, 0, 0] }),
      addBody(w, { mass: 2, position: [1, 0, 0], linearVelocity: [-1, 0, 0] }),
    ];
    w.add('CollisionCollection', { collidables: '*', bounce: e });
    w.advance(1);
    const [va, vb] = [velocity(a)[0], velocity(b)[0]];
    close(va + 2 * vb, 1, 1e-5, 'kg·m/s, momentum');
    // Without bounce, Bullet pushes an overlap of up to 5 mm apart by velocity.
    close(va, ((1 - 2 * e) * 3 + (1 + e) * 2 * -1) / 3, e > 0 ? 0.02 : 0.2, 'm/s');
  }
});

fact(
  'an impulse off centre: Δv = J/m and Δω = I⁻¹ (r × J); the centre of percussion stands still',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const rod = addBody(w, { mass: 2, geometry: [box(3, 0.1, 0.1)] });
    w.step();
    rod.applyImpulse([0, 4, 0], [1, 0, 0]);
    const moment = (2 * (9 + 0.01)) / 12;
    close(velocity(rod), [0, 2, 0], 1e-5, 'm/s');
    close(spin(rod), [0, 0, 4 / moment], 1e-4, 'rad/s');
    // At -I / (m r) from the centre.
    const at = -moment / 2;
    close(velocity(rod)[1] + spin(rod)[2] * at, 0, 1e-4, 'm/s there');
  },
);

fact('a rod swings through its lowest place at √(3 g / l) rad/s', async () => {
  const w = await world({ accuracy: 'precise' });
  const rod = addBody(w, { position: [0.5, 0, 0], geometry: [box(1, 0.01, 0.01)] });
  addJoint(w, 'SingleAxisHingeJoint', { body1: rod, axis: [0, 0, 1] });
  let fastest = 0;
  for (let i = 0; i < 480; i++) {
    w.step();
    fastest = Math.max(fastest, Math.abs(spin(rod)[2]));
  }
  close(fastest, Math.sqrt(3 * 9.8), 0.02, 'rad/s');
});
