import { add, cross, dot, length, scale, subtract } from '../../../../physics-core/base/math.js';
import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import {
  addBody,
  box,
  close,
  fact,
  position,
  world,
  WEIGHTLESS,
  type Vec3,
} from '../../helpers.js';
import { GRAVITY } from './scenes.js';

const RADIUS = 0.5;

/** What single precision leaves of some metres of way after a thousand steps, metres; it was 7 to 760 mm. */
const TOLERANCE = 2.5e-4;

interface Ball {
  place: Vec3;
  velocity: Vec3;
  spin: Vec3;
}

/** Places after `seconds` of two balls of 1 kg that meet without weight, by momentum, bounce 1 and Coulomb's law. */
function afterHit(a: Ball, b: Ball, friction: number, seconds: number): [Vec3, Vec3] {
  const way = subtract(a.place, b.place);
  const speed = subtract(a.velocity, b.velocity);
  const [square, half] = [dot(speed, speed), dot(way, speed)];
  const time = -(half + Math.sqrt(half ** 2 - square * (dot(way, way) - 4 * RADIUS ** 2))) / square;
  const normal = scale(add(way, scale(speed, time)), 1 / (2 * RADIUS));
  // Equal masses swap what they have along the normal.
  const push = -dot(speed, normal);
  const turning = cross(add(a.spin, b.spin), scale(normal, -RADIUS));
  const sliding = add(add(speed, scale(normal, push)), turning);
  // Of each ball 1 + r² / I = 1 + 5 / 2 gives way along the surface, 1/kg.
  const rub = Math.min(friction * push, length(sliding) / 7);
  const kick = add(scale(normal, push), scale(sliding, -rub / length(sliding)));
  const after = ({ place, velocity }: Ball, sign: number): Vec3 =>
    add(add(place, scale(velocity, seconds)), scale(kick, sign * (seconds - time)));
  return [after(a, 1), after(b, -1)];
}

const MOVING: Ball = { place: [-2.03, 0.5, 0.1], velocity: [5, 0, 0], spin: [0, 0, 0] };
const RESTING: Ball = { place: [0, 0, 0], velocity: [0, 0, 0], spin: [0, 0, 0] };

const HITS: [string, Ball, Ball, number][] = [
  ['smooth', MOVING, RESTING, 0],
  ['nearly passing', { ...MOVING, place: [-2.03, 0.8, 0.1] }, RESTING, 0],
  ['rough', MOVING, RESTING, 0.3],
  ['rough and spinning', { ...MOVING, spin: [1, 4, -3] }, { ...RESTING, spin: [0, 2, 1] }, 0.2],
];

for (const accuracy of levelNames) {
  for (const [how, a, b, friction] of HITS)
    fact(`at ${accuracy} two balls, ${how}, part as at the very time they met`, async () => {
      const w = await world({ accuracy, ...WEIGHTLESS });
      const [first, second] = [a, b].map(({ place, velocity, spin }) =>
        addBody(w, { position: place, linearVelocity: velocity, angularVelocity: spin }),
      );
      w.add('CollisionCollection', {
        collidables: '*',
        bounce: 1,
        minBounceSpeed: 0,
        frictionCoefficients: [friction, friction],
      });
      w.advance(1.2);
      const [placeA, placeB] = afterHit(a, b, friction, w.time);
      close(position(first!), placeA, TOLERANCE, 'm');
      close(position(second!), placeB, TOLERANCE, 'm');
    });

  fact(`at ${accuracy} a falling ball leaves an edge as at the very time it met it`, async () => {
    const w = await world({ accuracy, gravity: [0, -GRAVITY, 0] });
    addBody(w, { fixed: true, geometry: [box(1)] });
    // It meets the edge at x = y = 0.5 at 45°, having fallen h, and leaves to the side as fast as it came down.
    const out = 0.5 + RADIUS / Math.SQRT2;
    const h = 1.3;
    const ball = addBody(w, { position: [out, out + h, 0] });
    w.add('CollisionCollection', {
      collidables: '*',
      bounce: 1,
      minBounceSpeed: 0,
      frictionCoefficients: [0, 0],
    });
    w.advance(1);
    const fall = Math.sqrt((2 * h) / GRAVITY);
    const rest = w.time - fall;
    const place: Vec3 = [out + GRAVITY * fall * rest, out - (GRAVITY * rest ** 2) / 2, 0];
    close(position(ball), place, TOLERANCE, 'm');
  });
}
