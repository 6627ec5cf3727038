import { describe } from 'node:test';
import { add, cross, dot, scale } from '../../../../../physics-core/base/math.js';
import {
  addBody,
  addFloor,
  below,
  box,
  close,
  fact,
  height,
  position,
  sphere,
  spin,
  velocity,
  WEIGHTLESS,
  world,
  type Body,
  type Vec3,
} from '../../../../core/helpers.js';
import { G, stack, standing } from '../../../../core/effects/contact-solve/scenes.js';

// What contacts keep, and that they give no energy.

/** Of cubes of 1 m. */
const momentOf = (body: Body): number => body.mass.mass / 6;

function momenta(bodies: readonly Body[]): { linear: Vec3; angular: Vec3; energy: number } {
  let [linear, angular, energy]: [Vec3, Vec3, number] = [[0, 0, 0], [0, 0, 0], 0];
  for (const body of bodies) {
    const m = body.mass.mass;
    const [v, w] = [velocity(body), spin(body)];
    linear = add(linear, scale(v, m));
    angular = add(angular, add(cross(position(body), scale(v, m)), scale(w, momentOf(body))));
    energy += (m * dot(v, v) + momentOf(body) * dot(w, w)) / 2;
  }
  return { linear, angular, energy };
}

describe('two cubes that hit each other far from anything else', () => {
  for (const [says, bounce] of [
    ['and do not bounce', 0],
    ['and bounce', 0.6],
  ] as const)
    for (const accuracy of ['game', 'standard'])
      fact(`${says} keep their momenta, and gain no energy, at ${accuracy}`, async () => {
        const w = await world({ accuracy, ...WEIGHTLESS });
        w.add('CollisionCollection', {
          collidables: '*',
          bounce,
          frictionCoefficients: [0.5, 0.5],
        });
        const bodies = [
          addBody(w, {
            position: [-1, 0.3, 0.2],
            orientation: [1, 2, 3, 0.7],
            mass: 2,
            geometry: [box(1)],
            linearVelocity: [1, 0.2, 0],
            angularVelocity: [0.5, -1, 2],
          }),
          addBody(w, { position: [1, 0, 0], geometry: [box(1)], linearVelocity: [-1.5, 0, 0.1] }),
        ];
        w.step();
        const before = momenta(bodies);
        let { energy } = before;
        for (let i = 0; i < 240; i++) {
          w.step();
          const now = momenta(bodies);
          close(now.linear, before.linear, 1e-6, 'N s');
          // Overlaps are taken out by place, which turns some of it.
          close(now.angular, before.angular, 1e-2, 'N m s');
          below(now.energy, energy + 1e-6, 'J');
          ({ energy } = now);
        }
        below(energy, 0.95 * before.energy, 'J, of a hit');
      });
});

/** Of dominoes and the like: kinetic energy and that of height, J. */
function energyOf(bodies: readonly Body[], size: Vec3): number {
  let sum = 0;
  for (const body of bodies) {
    const m = body.mass.mass;
    const [v, w] = [velocity(body), spin(body)];
    // All turn about z.
    const moment = (m * (size[0] ** 2 + size[1] ** 2)) / 12;
    sum += (m * dot(v, v) + moment * dot(w, w)) / 2 + m * G * height(body);
  }
  return sum;
}

fact('dominoes pass on their fall and gain no energy', async () => {
  const size: Vec3 = [0.1, 1, 0.5];
  const { w, bodies } = await standing(
    Array.from({ length: 12 }, (_, i) => ({
      position: [0.4 * i, 0.5, 0],
      geometry: [box(...size)],
    })),
  );
  w.advance(0.1);
  bodies[0]!.event('angularVelocity', [0, 0, -1.2]);
  bodies[0]!.event('linearVelocity', [0.6, 0, 0]);
  let energy = energyOf(bodies, size);
  const all = energy;
  for (let i = 0; i < 600; i++) {
    w.step();
    const now = energyOf(bodies, size);
    below(now, energy + 1e-4 * all, 'J');
    energy = now;
  }
  for (const body of bodies) below(height(body), 0.4, 'm, fallen');
});

/** How high a ball of a bounce of .8 comes back that falls by 1 m onto so many cubes, metres. */
async function back(mass: number, count: number): Promise<number> {
  const w = await world();
  addFloor(w);
  stack(count).forEach((one) => addBody(w, one));
  const body = addBody(w, { mass, position: [0, count + 1.2, 0], geometry: [sphere(0.2)] });
  w.add('CollisionCollection', { collidables: '*', bounce: 0.8 });
  let [most, hit] = [0, false];
  for (let i = 0; i < 120; i++) {
    w.step();
    hit ||= velocity(body)[1] > 0;
    if (hit) most = Math.max(most, height(body) - count - 0.2);
  }
  return most;
}

fact(
  'a ball comes back from a cube by the law of two bodies, however many that lies upon',
  async () => {
    close(await back(0.1, 0), 0.64, 1e-3, 'm, from the floor');
    // (m − e M) / (m + M) of its speed.
    const expected = ((0.1 - 0.8) / 1.1) ** 2;
    for (const count of [1, 2, 5])
      close(await back(0.1, count), expected, 1e-3, `m, from ${count} cubes`);
    const heavy = await back(1, 1);
    for (const count of [2, 5]) close(await back(1, count), heavy, 1e-3, `m, from ${count} cubes`);
  },
);
