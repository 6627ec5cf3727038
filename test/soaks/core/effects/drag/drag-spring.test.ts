import { levels } from '../../../../../physics-core/inside.js';
import { chain } from '../../../../core/effects/drag/scenes.js';
import {
  above,
  addBody,
  below,
  box,
  close,
  distance,
  fact,
  position,
  spin,
  velocity,
  world,
  WEIGHTLESS,
} from '../../../../core/helpers.js';

/** rad/s of the spring, m/s of the hand, m/s² that it gives a body on its own. */
const SWIFTNESS = 30;
const TOP_SPEED = 8;
const STRENGTH = 100;

for (const { name, timeStep } of levels)
  for (const mass of [0.001, 1, 1000])
    fact(`a spring takes ${mass} kg back as a critically damped one does: ${name}`, async () => {
      const w = await world({ ...WEIGHTLESS, accuracy: name });
      const body = addBody(w, { mass });
      body.drag([0, 0, 0]);
      body.applyImpulse([mass, 0, 0]);
      const h = SWIFTNESS * timeStep;
      for (let n = 1; n * timeStep < 0.5; n++) {
        w.step();
        // Implicit Euler of x'' + 2 ω x' + ω² x = 0 from x = 0 at 1 m/s.
        close(position(body)[0], (n * timeStep) / (1 + h) ** (n + 1), 1e-6, `step ${n}`);
      }
      close(position(body), [0, 0, 0], 1e-4, 'settled at');
    });

for (const { name, timeStep } of levels)
  fact(
    `a body follows a leap of 1 m within half a second, overshooting by less than 0.5 %: ${name}`,
    async () => {
      const w = await world({ ...WEIGHTLESS, accuracy: name });
      const body = addBody(w, { mass: 3 });
      const drag = body.drag([0, 0, 0])!;
      drag.move([1, 0, 0]);
      let farthest = 0;
      let fastest = 0;
      let steepest = 0;
      for (let i = 0; i * timeStep < 0.5; i++) {
        const before = velocity(body)[0];
        w.step();
        farthest = Math.max(farthest, position(body)[0]);
        fastest = Math.max(fastest, velocity(body)[0]);
        steepest = Math.max(steepest, Math.abs(velocity(body)[0] - before) / timeStep);
      }
      close(position(body), [1, 0, 0], 0.01, 'after half a second');
      below(farthest, 1.005, 'farthest');
      below(fastest, 1.1 * TOP_SPEED, 'fastest');
      below(steepest, 1.6 * STRENGTH, 'acceleration');
    },
  );

for (const mass of [0.001, 1, 1000])
  fact(`a hand far away draws and lets go of ${mass} kg at its top speed`, async () => {
    const w = await world(WEIGHTLESS);
    const body = addBody(w, { mass });
    const drag = body.drag([0, 0, 0])!;
    drag.move([1000, 0, 0]);
    for (let i = 0; i < 120; i++) {
      w.step();
      below(velocity(body)[0], 1.1 * TOP_SPEED, 'speed');
    }
    drag.end();
    w.step();
    close(velocity(body), [TOP_SPEED, 0, 0], 0.01, 'thrown at');
  });

fact('a body on its way is caught', async () => {
  const w = await world(WEIGHTLESS);
  const body = addBody(w, { linearVelocity: [6, 0, 0] });
  w.step(0);
  const drag = body.drag(position(body))!;
  w.step(240);
  close(position(body), drag.target, 0.001, 'back at');
});

fact('a block in the way is pressed by a bounded force, and not passed', async () => {
  const w = await world(WEIGHTLESS);
  const mass = 1000;
  const block = addBody(w, { mass, position: [1.2, 0, 0], geometry: [box(1, 4, 4)] });
  const ball = addBody(w);
  ball.drag([0, 0, 0])!.move([10, 0, 0]);
  w.step(60);
  const before = velocity(block)[0];
  w.step(120);
  const force = mass * (velocity(block)[0] - before);
  above(force, 0.9 * STRENGTH, 'force');
  below(force, 1.6 * STRENGTH, 'force');
  below(position(ball)[0] - position(block)[0], -0.99, 'before it');
});

fact(
  'a corner is held where it was grabbed, while the body swings about it and comes to rest',
  async () => {
    const w = await world();
    const crate = addBody(w, { mass: 3, geometry: [box(1)], position: [0, 5, 0] });
    const drag = crate.drag([0.5, 5.5, 0.5])!;
    drag.move([1.5, 6, 0.5]);
    w.advance(2);
    for (let i = 0; i < 60; i++) {
      w.step();
      below(distance(drag.point, [1.5, 6 - 9.8 / 900, 0.5]), 0.03, 'off the hand');
    }
    w.advance(10);
    below(Math.hypot(...spin(crate)), 0.05, 'spin');
    close(position(crate)[1], 6 - Math.sqrt(3) / 2, 0.03, 'hangs from its corner');
  },
);

for (const last of [0.1, 2])
  for (const link of [3, 7])
    fact(
      `a chain is yanked about at link ${link} without opening, its end ${last} kg`,
      async () => {
        const { w, links, gap } = await chain(last);
        const body = links[link]!;
        const drag = body.drag(position(body))!;
        const [x, y, z] = position(body);
        let worst = 0;
        for (let i = 0; i < 240; i++) {
          const a = i / 12;
          drag.move([
            x + 3 * Math.sin(a),
            y + 2 + 2 * Math.cos(1.3 * a),
            z + 3 * Math.sin(0.7 * a),
          ]);
          w.step();
          worst = Math.max(worst, gap());
        }
        // Out of reach, and taut.
        drag.move([30, 30, 0]);
        for (let i = 0; i < 240; i++) {
          w.step();
          worst = Math.max(worst, gap());
          for (const each of links) below(Math.hypot(...velocity(each)), 25, 'speed');
        }
        // 1 % of a link.
        below(worst, 0.01, 'widest gap');
      },
    );

fact('a light link lifts all that hangs on it', async () => {
  const { w, links } = await chain(2);
  const body = links[3]!;
  const drag = body.drag(position(body))!;
  drag.move([1, -2.5, 0]);
  w.advance(4);
  below(distance(drag.point, [1, -2.5, 0]), 0.03, 'off the hand');
});

fact('two hands hold one body', async () => {
  const w = await world();
  const plank = addBody(w, { geometry: [box(4, 0.2, 0.2)] });
  plank.drag([-1.9, 0, 0])!.move([-1.9, 2, 0]);
  plank.drag([1.9, 0, 0])!.move([1.9, 2, 0]);
  w.advance(2);
  close(position(plank), [0, 2, 0], 0.02, 'held level');
});

fact(
  'who is held goes on following the hand when a joint, the first of the world, comes',
  async () => {
    const w = await world();
    const bob = addBody(w, { position: [1, 0, 0] });
    const drag = bob.drag([1, 0, 0])!;
    w.step();
    w.add('BallJoint', { body1: bob, anchorPoint: [0, 0, 0] });
    drag.move([0, 1, 0]);
    w.advance(3);
    close(position(bob), [0, 1, 0], 0.03, 'm');
  },
);

fact('a body that is held by a point far away from it keeps its numbers', async () => {
  for (const far of [1e5, 1e7, 1e10, 1e12]) {
    const w = await world();
    const body = addBody(w, { geometry: [box(1)] });
    body.drag([0, far, far]);
    w.step(10);
    below(distance(position(body), [0, 0, 0]), 0.1, 'm');
    below(distance(spin(body), [0, 0, 0]), 0.1, 'rad/s');
  }
});
