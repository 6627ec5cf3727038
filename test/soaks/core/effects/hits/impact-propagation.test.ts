import assert from 'node:assert/strict';
import {
  cradle,
  energyOf,
  firstHit,
  sharesOf,
  turning,
} from '../../../../core/effects/hits/cradles.js';
import {
  addBody,
  addFloor,
  box,
  close,
  fact,
  sphere,
  velocity,
  world,
} from '../../../../core/helpers.js';

const SMOOTH = { frictionCoefficients: [0, 0] };

for (const gap of [0, 0.001])
  fact(
    `in a cradle with gaps of ${gap * 1000} mm, bounce 1 set at run time, the far ball takes over the swing, ten times over`,
    async () => {
      const scene = await cradle({ gap, fields: SMOOTH });
      scene.w.advance(0.2);
      scene.collection.set('bounce', 1);
      const before = energyOf(scene.balls);
      const hit = firstHit(scene);
      scene.w.step(3);
      close(scene.balls.map(turning), [0, 0, 0, 0, hit], 0.03 * hit, 'rad/s after the first hit');
      const shares = sharesOf(scene, hit, 10);
      assert.ok(Math.min(...shares) > 0.97 && Math.max(...shares) < 1.03, shares.join(' '));
      // A lone pendulum with Bullet's steps keeps its energy within 0.6 % (measured).
      assert.ok(energyOf(scene.balls) < 1.01 * before, 'no energy from nothing');
    },
  );

fact('rubbing balls lose what Coulomb’s law takes from each hit', async () => {
  const scene = await cradle({ accuracy: 'precise', fields: { bounce: 1 } });
  const hit = firstHit(scene);
  scene.w.step(3);
  // The balls turn about their hinges, 4 m up, and slide on each other 0.5 m beside them: with friction 0.5 an impulse N
  // pushes with 4 N, and brakes both balls with 0.5 · 0.5 N. So 15/16 go on with each of four hits.
  const on = 15 / 16;
  const back = on - 1;
  close(
    scene.balls.map((ball) => turning(ball) / hit),
    [back, on * back, on ** 2 * back, on ** 3 * back, on ** 4],
    0.01,
    'of the speed',
  );
});

fact('where two balls strike, two leave', async () => {
  const { w, balls } = await cradle({ raised: 2, angle: 0.7, fields: { bounce: 1, ...SMOOTH } });
  w.advance(1.2);
  const speed = turning(balls[4]!);
  assert.ok(speed > 0.9, `${speed} rad/s`);
  close(balls.map(turning), [0, 0, 0, speed, speed], 0.03, 'rad/s');
});

fact('a small ball on a great one that falls with it leaves faster than both came', async () => {
  const w = await world({ accuracy: 'precise' });
  addFloor(w);
  const great = addBody(w, { mass: 3, position: [0, 1.5, 0] });
  const small = addBody(w, { mass: 1, position: [0, 2.25, 0], geometry: [sphere(0.25)] });
  w.add('CollisionCollection', { collidables: '*', bounce: 1, ...SMOOTH });
  const v = Math.sqrt(2 * 9.8);
  w.advance(v / 9.8 + 0.01);
  // The floor turns the great one round; then 3 kg at v meet 1 kg at -v: 0 and 2 v.
  const gravity = 9.8 * 0.01;
  close(velocity(great)[1], 0, 0.15, 'm/s');
  close(velocity(small)[1], 2 * v - gravity, 0.15, 'm/s');
});

fact('boxes of a touching row part all at once, as Bullet has them', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const boxes = [-1.1, 0, 1].map((x, i) =>
    addBody(w, {
      position: [x, 0, 0],
      geometry: [box(1)],
      linearVelocity: [i === 0 ? 1 : 0, 0, 0],
    }),
  );
  w.add('CollisionCollection', { collidables: '*', bounce: 1, ...SMOOTH });
  w.advance(0.5);
  close(
    boxes.map((each) => velocity(each)[0]),
    [-1 / 3, 2 / 3, 2 / 3],
    0.02,
    'm/s',
  );
});

fact('impact propagation are looked for only while something bounces', async () => {
  const w = await world();
  const chains = () => w.effects.find(({ name }) => name === 'impact propagation')!.active;
  addFloor(w);
  addBody(w, { position: [0, 1, 0] });
  const collection = w.add('CollisionCollection', { collidables: '*', bounce: 0 });
  w.advance(0.1);
  assert.equal(chains(), false);
  collection.set('bounce', 0.5);
  w.advance(0.1);
  assert.equal(chains(), true);
  collection.set('bounce', 0);
  w.advance(0.1);
  assert.equal(chains(), false);
});
