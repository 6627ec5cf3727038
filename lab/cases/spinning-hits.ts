import {
  add,
  cross,
  dot,
  length,
  multiply,
  quaternionOf,
  rotate,
  scale,
  subtract,
} from '../../physics-core/base/math.js';
import type { Case, CaseBody, Quaternion, Sight, Vec3 } from '../case.js';
import { apart, worst } from './judging.js';
import { roundingOf } from './paths.js';

// A rough ball that spins meets another: friction turns both, and throws them out of the plane in which they came.

const RADIUS = 0.5;
const BOUNCE = 0.6;
const FRICTION = 0.2;

/** m/s and rad/s. */
interface Motion {
  speed: Vec3;
  spin: Vec3;
}

interface Ball {
  name: string;
  mass: number;
  start: Vec3;
  before: Motion;
}

const a: Ball = {
  name: 'a',
  mass: 2,
  start: [-1.87, 0.4, 0],
  before: { speed: [5, 0, 0], spin: [4, 9, -6] },
};
const b: Ball = {
  name: 'b',
  mass: 1,
  start: [0, 0, 0],
  before: { speed: [0, 0, 0], spin: [0, 0, 3] },
};

/** Seconds until they touch: b stands until then. */
const hit = (-a.start[0] - Math.sqrt(4 * RADIUS ** 2 - a.start[1] ** 2)) / a.before.speed[0];
/** From a to b. */
const normal = scale(subtract(b.start, add(a.start, scale(a.before.speed, hit))), 0.5 / RADIUS);

const surface = ({ speed, spin }: Motion, arm: Vec3): Vec3 => add(speed, cross(spin, arm));

/** What a takes from b, N s: Newton's law of bounce along the normal, Coulomb's across it. */
function kick(): Vec3 {
  const meets = subtract(
    surface(a.before, scale(normal, RADIUS)),
    surface(b.before, scale(normal, -RADIUS)),
  );
  const gives = 1 / a.mass + 1 / b.mass;
  const into = dot(meets, normal);
  const push = ((1 + BOUNCE) * into) / gives;
  const along = subtract(meets, scale(normal, into));
  // Of a solid ball 1 + m r² / I = 7/2 gives way along the surface.
  const rub = Math.min(FRICTION * push, length(along) / (3.5 * gives));
  return scale(add(scale(normal, push), scale(along, rub / length(along))), -1);
}

/** After the push of `sign` times the kick, where the other ball touches it. */
function after({ mass, before }: Ball, sign: number): Motion {
  const push = scale(kick(), sign);
  const arm = scale(normal, sign * RADIUS);
  return {
    speed: add(before.speed, scale(push, 1 / mass)),
    spin: add(before.spin, scale(cross(arm, push), 1 / (0.4 * mass * RADIUS ** 2))),
  };
}

const turn = (spin: Vec3, time: number): Quaternion => quaternionOf([...spin, length(spin) * time]);

/** A mark on its skin. */
const MARK: Vec3 = scale([1, 1, 1], RADIUS / Math.sqrt(3));

/** Where the centre and the mark of a ball are after so many seconds. */
function placesOf(ball: Ball, sign: number): (time: number) => [centre: Vec3, mark: Vec3] {
  const later = after(ball, sign);
  return (time) => {
    const [t, since] = [Math.min(time, hit), Math.max(0, time - hit)];
    const centre = add(ball.start, add(scale(ball.before.speed, t), scale(later.speed, since)));
    const turned = multiply(turn(later.spin, since), turn(ball.before.spin, t));
    return [centre, add(centre, rotate(turned, MARK))];
  };
}

const bodyOf = ({ name, mass, start, before }: Ball): CaseBody => ({
  name,
  mass,
  shape: { type: 'Sphere', radius: RADIUS },
  position: start,
  linearVelocity: before.speed,
  angularVelocity: before.spin,
});

const off = ({ position, orientation }: Sight, { name }: Ball, [centre, mark]: [Vec3, Vec3]) => {
  const now = position(name);
  return Math.max(apart(now, centre), apart(add(now, rotate(orientation(name), MARK)), mark));
};

const seconds = 1;

export const cases: Case[] = [
  {
    id: 'hit-oblique-spins',
    name: 'Spinning ball hits another',
    says: `A ball of 2 kg that spins at 11.5 rad/s meets one of 1 kg at 5 m/s, 0.4 m aside of its middle, bounce ${BOUNCE}, friction ${FRICTION}, without weight; the places of both and of a mark on each against what momentum, bounce and Coulomb's law leave.`,
    scene: {
      gravity: [0, 0, 0],
      bodies: [bodyOf(a), bodyOf(b)],
      contact: { bounce: BOUNCE, friction: FRICTION },
    },
    seconds,
    unit: 'm',
    size: 4,
    singlePrecision: roundingOf(4, seconds),
    watch: (sight) => {
      const [first, second] = [placesOf(a, 1), placesOf(b, -1)];
      return worst((time) => Math.max(off(sight, a, first(time)), off(sight, b, second(time))));
    },
  },
];
