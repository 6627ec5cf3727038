import { describe } from 'node:test';
import {
  multiply,
  quaternionOf,
  rotate,
  rotationOf,
} from '../../../../../physics-core/base/math.js';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  above,
  below,
  box,
  close,
  distance,
  fact,
  position,
  spin,
  velocity,
  way,
  world,
  type Body,
  type Vec3,
} from '../../../../core/helpers.js';
import { G, stack, standing } from '../../../../core/effects/contact-solve/scenes.js';

// What slides, and what does not: by Coulomb's law, along any direction alike.

const MU = 0.5;
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** All pairs rub at MU, and nothing bounces. */
const rubbing = (w: World, mu = MU): void =>
  void w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [mu, mu] });

interface Slope {
  w: World;
  body: Body;
  /** Unit vector down the slope. */
  down: Vec3;
}

/** A box of 1 m on a slope that leans by `angle`, down a heading about the vertical, in degrees. */
async function onSlope(angle: number, heading = 0, accuracy = 'standard'): Promise<Slope> {
  const w = await world({ accuracy });
  const turned = multiply(
    quaternionOf([0, 1, 0, radians(heading)]),
    quaternionOf([0, 0, 1, -radians(angle)]),
  );
  const orientation = rotationOf(turned);
  const at = (height: number) => rotate(turned, [0, height, 0]);
  addBody(w, { fixed: true, orientation, position: at(-0.5), geometry: [box(60, 1, 60)] });
  const body = addBody(w, { orientation, position: at(0.5), geometry: [box(1)] });
  rubbing(w);
  return { w, body, down: rotate(turned, [1, 0, 0]) as Vec3 };
}

const along = (v: readonly number[], down: Vec3): number =>
  v.reduce((sum, value, i) => sum + value * down[i]!, 0);

describe('a box on a slope', () => {
  for (const heading of [0, 30, 45])
    fact(`of 25° does not creep at a friction of 0.5, down ${heading}°`, async () => {
      const { w, body } = await onSlope(25, heading);
      w.advance(0.5);
      const before = position(body);
      w.advance(10);
      below(distance(position(body), before), 1e-5, 'm');
    });

  for (const [accuracy, headings] of [
    ['game', 5e-4],
    ['standard', 1e-4],
  ] as const)
    fact(
      `of 30° slides at g (sin α − μ cos α), down any heading alike, at ${accuracy}`,
      async () => {
        const found: number[] = [];
        for (const heading of [0, 30, 45]) {
          const { w, body, down } = await onSlope(30, heading, accuracy);
          w.advance(0.5);
          const before = along(velocity(body), down);
          w.advance(1);
          found.push(along(velocity(body), down) - before);
          below(Math.hypot(...spin(body)), 1e-3, 'rad/s');
        }
        const a = G * (Math.sin(radians(30)) - MU * Math.cos(radians(30)));
        for (const value of found) close(value, a, 1e-3 * a, 'm/s in a second');
        close(Math.max(...found), Math.min(...found), headings, 'm/s, headings');
      },
    );
});

/** A box of 2 kg on the floor that is pushed by a share of what friction holds. */
async function pushed(share: number, heading: number) {
  const w = await world();
  addFloor(w);
  const force = share * MU * 2 * G;
  const [x, z] = [Math.cos(radians(heading)), Math.sin(radians(heading))];
  const body = addBody(w, {
    mass: 2,
    position: [0, 0.25, 0],
    geometry: [box(1, 0.5, 1)],
    forces: [[force * x, 0, force * z]],
  });
  rubbing(w);
  w.advance(2);
  return position(body);
}

fact('a push of .999 μ m g moves nothing, along any heading', async () => {
  for (const heading of [0, 30, 45]) {
    const [x, , z] = await pushed(0.999, heading);
    below(Math.hypot(x, z), 1e-5, 'm');
  }
});

fact('a push of 1.01 μ m g moves it by (F − μ m g) t²/2m, along any heading', async () => {
  for (const heading of [0, 30, 45]) {
    const [x, , z] = await pushed(1.01, heading);
    const expected = way(0.01 * MU * G, 2);
    close(
      [x, z],
      [expected * Math.cos(radians(heading)), expected * Math.sin(radians(heading))],
      2e-3,
    );
  }
});

fact('a box that slides stops after v²/2μg, where it came to, along any heading', async () => {
  const v = 2;
  for (const heading of [0, 30, 45]) {
    const { w, bodies } = await standing([{ position: [0, 0.25, 0], geometry: [box(1, 0.5, 1)] }]);
    rubbing(w);
    w.advance(0.5);
    const [x, z] = [Math.cos(radians(heading)), Math.sin(radians(heading))];
    bodies[0]!.event('linearVelocity', [v * x, 0, v * z]);
    let most = v;
    for (let i = 0; i < 60; i++) {
      w.step();
      const now = Math.hypot(...velocity(bodies[0]!));
      below(now, most + 1e-5, 'm/s, friction gives none');
      most = now;
    }
    const stopped = position(bodies[0]!);
    const expected = (v * v) / (2 * MU * G);
    close([stopped[0], stopped[2]], [expected * x, expected * z], 0.01, 'm');
    w.advance(2);
    below(distance(position(bodies[0]!), stopped), 1e-5, 'm, when it stands');
  }
});

/** A ladder of 2 m, 2 cm thick, on a rough floor, against a smooth wall: how far it slips in a second, metres. */
async function slipped(degrees: number, accuracy: string): Promise<number> {
  const w = await world({ accuracy });
  const shape = (geometry: object) => w.add('CollidableShape', { shape: [geometry] });
  const [floor, upright, rung] = [box(20, 1, 20), box(1, 20, 20), box(0.02, 2, 0.5)].map(shape);
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [floor] });
  addBody(w, { fixed: true, position: [-0.5, 5, 0], geometry: [upright] });
  const angle = radians(degrees);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const ladder = addBody(w, {
    position: [cos + 0.01 * sin, sin + 0.01 * cos, 0],
    orientation: [0, 0, 1, Math.PI / 2 - angle],
    geometry: [rung],
  });
  w.add('CollisionCollection', { collidables: [floor, rung], frictionCoefficients: [MU, MU] });
  w.add('CollisionCollection', { collidables: [upright, rung], frictionCoefficients: [0, 0] });
  w.advance(0.2);
  const before = position(ladder);
  w.advance(1);
  return distance(position(ladder), before);
}

fact(
  'a ladder against a smooth wall slips to a tenth of a degree where statics has it',
  async () => {
    // It touches with the edges of one side: cot θ = 2μ + thickness / length, which is 1 / tan θ = 2μ for a thin one.
    const limit = (Math.atan(1 / (2 * MU + 0.01)) * 180) / Math.PI;
    for (const accuracy of ['game', 'standard']) {
      below(await slipped(limit + 0.1, accuracy), 2e-5, 'm, steeper');
      above(await slipped(limit - 0.1, accuracy), 2e-3, 'm, flatter');
    }
  },
);

fact('a box on a belt rides at its speed, and so does what stands upon it', async () => {
  const w = await world();
  const floor = w.add('CollidableShape', { shape: [box(200, 1, 200)] });
  const low = w.add('CollidableShape', { shape: [box(1)] });
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [floor] });
  const bodies = stack(3).map((one, i) => addBody(w, i > 0 ? one : { ...one, geometry: [low] }));
  w.add('CollisionCollection', {
    collidables: [floor, low],
    frictionCoefficients: [1, 1],
    surfaceSpeed: [0.5, 0.25],
    appliedParameters: ['SPEED-1', 'SPEED-2'],
  });
  w.advance(2);
  const before = bodies.map(position);
  w.advance(4);
  bodies.forEach((body, i) => {
    close(velocity(body), [0.5, 0, 0.25], 1e-4, 'm/s');
    close(distance(position(body), before[i]!), 4 * Math.hypot(0.5, 0.25), 1e-3, 'm');
  });
});

fact('a cube that spins where it stands stops, and drifts nowhere', async () => {
  const w = await world();
  addFloor(w);
  const body = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  rubbing(w);
  w.advance(0.5);
  body.event('angularVelocity', [0, 6, 0]);
  w.advance(3);
  close(spin(body), [0, 0, 0], 1e-5, 'rad/s');
  const [x, , z] = position(body);
  below(Math.hypot(x, z), 1e-3, 'm');
});
