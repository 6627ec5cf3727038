import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  close,
  distance,
  fact,
  position,
  sphere,
  spin,
  velocity,
  world,
  type Body,
  type Joint,
} from '../../../../core/helpers.js';
import { borne, farthest, G, standing } from '../../../../core/effects/contact-solve/scenes.js';

// Joints of what touches: they hold, and what hangs on them bears and drives as statics and Newton have it.

const QUARTER = Math.PI / 2;
const RADIUS = 0.4;

interface Cart {
  w: World;
  floor: Body;
  chassis: Body;
  wheels: Body[];
}

/** A chassis of 5 kg on four wheels of 1 kg; the rear ones are driven by motors, N m each. */
async function cart(torque = 0, accuracy = 'standard'): Promise<Cart> {
  const w = await world({ accuracy });
  const floor = addFloor(w);
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [1, 1] });
  const chassis = addBody(w, { mass: 5, position: [0, 0.5, 0], geometry: [box(1, 0.4, 2)] });
  const wheels = [
    [-0.6, 0.8],
    [0.6, 0.8],
    [-0.6, -0.8],
    [0.6, -0.8],
  ].map(([x, z]) => {
    const wheel = addBody(w, {
      position: [x, RADIUS, z],
      orientation: [0, 0, 1, -QUARTER],
      geometry: [{ type: 'Cylinder', radius: RADIUS, height: 0.2 }],
    });
    const ends = { body1: wheel, body2: chassis };
    addJoint(w, 'SingleAxisHingeJoint', { ...ends, axis: [1, 0, 0], anchorPoint: [x, RADIUS, z] });
    if (torque > 0 && z! < 0)
      w.add('MotorJoint', { ...ends, motor1Axis: [1, 0, 0], axis1Torque: torque });
    return wheel;
  });
  return { w, floor, chassis, wheels };
}

fact(
  'a cart on four hinged wheels stands where it is, and each wheel bears its share',
  async () => {
    const { w, floor, chassis, wheels } = await cart();
    w.advance(1);
    const before = position(chassis);
    w.advance(20);
    below(distance(position(chassis), before), 1e-3, 'm');
    const loads = wheels.map((wheel) => borne(w, wheel, floor));
    const weight = (5 + 4) * G;
    close(loads.reduce((sum, load) => sum + load) / weight, 1, 1e-3, 'of its weight');
    for (const load of loads) close(load / (weight / 4), 1, 0.05, 'of a quarter');
  },
);

for (const accuracy of ['game', 'standard', 'fine', 'precise', 'reference'])
  fact(`motors drive a cart by a = τ r / (M r² + 4 I) at ${accuracy}`, async () => {
    const { w, chassis, wheels } = await cart(3, accuracy);
    w.advance(0.5);
    const [z, v] = [position(chassis)[2], velocity(chassis)[2]];
    w.advance(1);
    // Wheels of m r²/2; both driven ones together 6 N m.
    const a = (6 * RADIUS) / (9 * RADIUS ** 2 + 4 * (RADIUS ** 2 / 2));
    close(velocity(chassis)[2] - v, a, 1e-3 * a, 'm/s more in a second');
    close(position(chassis)[2] - z, v + a / 2, 0.01 * a, 'm on in a second');
    for (const wheel of wheels)
      close(spin(wheel)[0] * RADIUS, velocity(chassis)[2], 1e-3, 'm/s, rolling');
  });

fact('a chain of ball joints on the ground keeps them whole, and stays', async () => {
  const links = Array.from({ length: 12 }, (_, i) => ({
    position: [0.4 * i, 0.05, 0],
    geometry: [box(0.3, 0.1, 0.1)],
  }));
  const scene = await standing(links);
  const joints: Joint[] = scene.bodies.slice(1).map((body1, i) =>
    addJoint(scene.w, 'BallJoint', {
      body1,
      body2: scene.bodies[i],
      anchorPoint: [0.4 * i + 0.2, 0.05, 0],
    }),
  );
  below(farthest(scene, 10), 1e-3, 'm');
  below(Math.max(...joints.map(({ gap }) => gap)), 1e-4, 'm, gap');
});

fact('a chain dropped on the ground in a heap keeps its joints whole', async () => {
  const links = Array.from({ length: 10 }, (_, i) => ({
    position: [0, 0.5 + 0.4 * i, 0.02 * i],
    geometry: [box(0.1, 0.3, 0.1)],
  }));
  const { w, bodies } = await standing(links);
  const joints: Joint[] = bodies.slice(1).map((body1, i) =>
    addJoint(w, 'BallJoint', {
      body1,
      body2: bodies[i],
      anchorPoint: [0, 0.7 + 0.4 * i, 0.02 * i + 0.01],
    }),
  );
  let gap = 0;
  for (let i = 0; i < 600; i++) {
    w.step();
    gap = Math.max(gap, ...joints.map((joint) => joint.gap));
  }
  below(gap, 2e-4, 'm, gap');
  below(Math.max(...bodies.map((body) => Math.hypot(...velocity(body)))), 1e-4, 'm/s, at last');
});

fact('a board on a hinge leans on a wall with what statics has it push', async () => {
  const [lean, thin] = [0.3, 0.01];
  const [sin, cos] = [Math.sin(lean), Math.cos(lean)];
  const w = await world();
  const board = addBody(w, {
    mass: 2,
    position: [-sin / 2, cos / 2, 0],
    orientation: [0, 0, 1, lean],
    geometry: [box(2 * thin, 1, 0.5)],
  });
  addJoint(w, 'SingleAxisHingeJoint', { body1: board, axis: [0, 0, 1], anchorPoint: [0, 0, 0] });
  const face = -sin - thin * cos;
  const upright = addBody(w, {
    fixed: true,
    position: [face - 0.5, 1, 0],
    geometry: [box(1, 5, 5)],
  });
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0, 0] });
  w.advance(1);
  const before = position(board);
  w.advance(10);
  below(distance(position(board), before), 1e-5, 'm');
  // Moments about the hinge: the weight at half its length, the wall at its upper edge.
  const push = (2 * G * (sin / 2)) / (cos - thin * sin);
  close(borne(w, board, upright) / push, 1, 2e-3, 'of the push');
});

fact('a net that falls over a ball lies on it', async () => {
  const [size, link, radius, knotRadius] = [12, 0.15, 0.5, 0.03];
  const w = await world();
  addBody(w, { fixed: true, position: [0, 0, 0], geometry: [sphere(radius)] });
  const at = (n: number): [number, number, number] => [
    (Math.floor(n / size) - (size - 1) / 2) * link,
    radius + 2 * knotRadius,
    ((n % size) - (size - 1) / 2) * link,
  ];
  const knots = Array.from({ length: size * size }, (_, n) =>
    addBody(w, { mass: 0.1, position: at(n), geometry: [sphere(knotRadius)] }),
  );
  const join = (n: number, other: number): void => {
    const anchorPoint = at(n).map((x, axis) => (x + at(other)[axis]!) / 2);
    addJoint(w, 'BallJoint', { body1: knots[n], body2: knots[other], anchorPoint });
  };
  knots.forEach((_, n) => {
    if (n + size < size * size) join(n, n + size);
    if ((n + 1) % size) join(n, n + 1);
  });
  w.advance(1.5);
  const depths = knots.map((knot) => radius + knotRadius - distance(position(knot), [0, 0, 0]));
  // Where it is left to iterations joints pull it into the ball.
  below(Math.max(...depths), 1e-3, 'm');
});
