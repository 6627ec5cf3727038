import { describe } from 'node:test';
import { add, scale } from '../../../../../physics-core/base/math.js';
import type { World } from '../../../../../physics-core/inside.js';
import { axesOf, kineticEnergy } from '../../../../../references/kinetic-energy.js';
import { below, fact, world, type Body, type Vec3 } from '../../../../core/helpers.js';
import { G, addRod, hinge, quiet, addFourBar } from '../../../../core/effects/joints/linkages.js';

const height = (body: Body): number => body.centerOfMassWorld()[1];

/** Those of the middle of the last step, as the joint solve has them. */
const velocity = (body: Body): Vec3 => body.velocityAtOrigin().linear;
const spin = (body: Body): Vec3 => body.velocityAtOrigin().angular;

/**
 * Highest and lowest energy on the way, less that of the start, over `range`. The velocity of jointed bodies belongs to
 * the middle of the step: at a pose it is the mean of the steps before and after.
 */
function energyBand(w: World, bodies: Body[], seconds: number, range: number): [number, number] {
  w.flush();
  const before = bodies.map((body) => ({ y: height(body), v: velocity(body), spin: spin(body) }));
  const total = (): number =>
    bodies.reduce((sum, body, i) => {
      const { y, v, spin: turning } = before[i]!;
      const mean = (a: Vec3, b: Vec3) => scale(add(a, b), 0.5);
      const moving = kineticEnergy(
        body,
        mean(v, velocity(body)),
        mean(turning, spin(body)),
        axesOf(body),
      );
      before[i] = { y: height(body), v: velocity(body), spin: spin(body) };
      return sum + body.mass.mass * G * y + moving;
    }, 0);
  const start = bodies.reduce((sum, body) => sum + body.mass.mass * G * height(body), 0);
  let [most, least] = [start, start];
  w.step();
  total();
  for (let i = 1; i < seconds / w.timeStep; i++) {
    w.step();
    const now = total();
    most = Math.max(most, now);
    least = Math.min(least, now);
  }
  return [(most - start) / range, (start - least) / range];
}

/** Frictionless systems that start from rest, and the energy (J) that falling to the lowest pose sets free. */
const systems: Record<string, (w: World) => { bodies: Body[]; range: number }> = {
  pendulum(w) {
    const rod = addRod(w, [0, 0, 0], [1, 0, 0]);
    hinge(w, [0, 0, 0], rod);
    return { bodies: [rod], range: G / 2 };
  },
  'double pendulum'(w) {
    const [one, two] = [addRod(w, [0, 0, 0], [1, 0, 0]), addRod(w, [1, 0, 0], [2, 0, 0])];
    hinge(w, [0, 0, 0], one);
    hinge(w, [1, 0, 0], two, one);
    return { bodies: [one, two], range: 2 * G };
  },
  'four-bar'(w) {
    const { bars } = addFourBar(w);
    // From straight up at the crank to straight down.
    return { bodies: bars, range: G };
  },
};

describe('energy without friction', () => {
  for (const [accuracy, seconds] of [
    ['game', 20],
    ['standard', 20],
    ['fine', 20],
    ['precise', 60],
  ] as const) {
    for (const [name, build] of Object.entries(systems)) {
      fact(
        `${name}: never above its start by 1 %, nor below by 5 %, in ${seconds} s at ${accuracy}`,
        async () => {
          const w = await world({ accuracy });
          quiet(w);
          const { bodies, range } = build(w);
          const [most, least] = energyBand(w, bodies, seconds, range);
          below(most, 0.01, 'of the energy gained');
          below(least, 0.05, 'of the energy lost');
        },
      );
    }
  }
});
