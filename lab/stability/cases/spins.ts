import { atan2, cos, sin } from '../../../physics-core/base/exact/index.js';
import type { World } from '../../../physics-core/inside.js';
import type { StabilityCase } from '../case.js';
import {
  addBody,
  addFloor,
  addHinge,
  addJoint,
  atTheEnd,
  box,
  greatest,
  most,
  position,
  sphere,
  spin,
  velocity,
  type Body,
} from '../scene.js';

// What spins faster than a step can follow in one piece.

const G = 9.8;

/** A wheel on an arm on a ball joint, set off at its steady precession: its weight by its spin, about the vertical. */
const gyroscope = (rate: number): StabilityCase => ({
  id: `gyroscope ${rate}`,
  says: `a wheel of ${rate} rad/s on an arm of 1 m stays level and goes round as its weight turns it`,
  load: { of: 'radians in a second', ratio: rate },
  seconds: 0.5,
  criterion: { what: 'farthest from level, or from its way round', unit: 'm', most: 5e-3 },
  promisedFrom: 'game',
  scene(w) {
    const [mass, radius] = [2, 0.5];
    const precession = (mass * G) / (((mass * radius ** 2) / 2) * rate);
    const wheel = addBody(w, {
      mass,
      position: [1, 0, 0],
      orientation: [0, 0, 1, -Math.PI / 2],
      angularVelocity: [rate, precession, 0],
      linearVelocity: [0, 0, -precession],
      geometry: [{ type: 'Cylinder', radius, height: 0.1 }],
    });
    addJoint(w, 'BallJoint', { body1: wheel, anchorPoint: [0, 0, 0] });
    return greatest(() => {
      const [x, y, z] = position(wheel);
      const angle = precession * w.time;
      return most([Math.abs(y), Math.hypot(x - cos(angle), z + sin(angle))]);
    });
  },
});

const blade = box(1, 0.05, 0.1);

/** Of its spin about y, and of none about the others, as a share. */
const strays = (body: Body, rate: number): number => {
  const [x, y, z] = spin(body);
  return Math.hypot(x, y - rate, z) / rate;
};

/** The angle about y between where it points and where it would. */
function behind(body: Body, angle: number): number {
  const [x, y, z, turned] = body.get('orientation') as [number, number, number, number];
  // Twice about y: half of it is half of that.
  const heading = 2 * atan2(y * sin(turned / 2), cos(turned / 2));
  const off = heading - angle;
  return Math.hypot(x * sin(turned / 2), z * sin(turned / 2)) + Math.abs(atan2(sin(off), cos(off)));
}

const RADIUS = 0.3;

/** A chassis on four wheels that roll along x as fast as it goes. */
function addCar(w: World, speed: number) {
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0.8, 0.8], bounce: 0 });
  const linearVelocity = [speed, 0, 0];
  const chassis = addBody(w, {
    mass: 800,
    position: [0, 0.5, 0],
    linearVelocity,
    geometry: [box(3, 0.4, 1.2)],
  });
  const places = [-1.2, 1.2].flatMap((x) => [-0.75, 0.75].map((z) => [x, RADIUS, z]));
  const wheels = places.map((anchorPoint) => {
    const wheel = addBody(w, {
      mass: 20,
      position: anchorPoint,
      orientation: [1, 0, 0, Math.PI / 2],
      linearVelocity,
      angularVelocity: [0, 0, -speed / RADIUS],
      geometry: [{ type: 'Cylinder', radius: RADIUS, height: 0.2 }],
    });
    addHinge(w, { body1: chassis, body2: wheel, anchorPoint, axis: [0, 0, 1] });
    return wheel;
  });
  return { chassis, wheels };
}

/** A ball whose mass lies a little below its middle, and that spins about the vertical. */
function addTippeTop(w: World, rate: number): Body {
  const [radius, mass] = [0.02, 0.02];
  const across = (131 / 350) * mass * radius ** 2;
  const about = 0.4 * mass * radius ** 2;
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0.3, 0.3], bounce: 0 });
  return addBody(w, {
    mass,
    position: [0, radius, 0],
    orientation: [0, 0, 1, 0.1],
    centerOfMass: [0, -0.003, 0],
    inertia: [across, 0, 0, 0, about, 0, 0, 0, across],
    angularVelocity: [0, rate, 0],
    geometry: [sphere(radius)],
  });
}

/** Radians between its own axis and the vertical. */
function leanOf(body: Body): number {
  const { q } = body.pose();
  return 2 * atan2(Math.hypot(q[0], q[2]), Math.hypot(q[1], q[3]));
}

export const spins: StabilityCase[] = [
  ...[60, 300, 1000].map(gyroscope),
  {
    id: 'free blade',
    says: 'a blade of 300 rad/s on a free hinge keeps its spin and its axis',
    load: { of: 'radians in a second', ratio: 300 },
    seconds: 2,
    criterion: { what: 'off, of its spin', unit: '', most: 1e-4 },
    promisedFrom: 'game',
    scene(w) {
      const body = addBody(w, { angularVelocity: [0, 300, 0], geometry: [blade] });
      addHinge(w, { body1: body, axis: [0, 1, 0] });
      return greatest(() => strays(body, 300));
    },
  },
  {
    id: 'driven blade',
    says: 'a blade that a motor drives to 300 rad/s turns about its hinge alone',
    load: { of: 'radians in a second', ratio: 300 },
    seconds: 2,
    criterion: { what: 'off, of its spin', unit: '', most: 2e-3 },
    promisedFrom: 'game',
    work: 'a motor drives it',
    scene(w) {
      const body = addBody(w, { geometry: [blade] });
      addHinge(w, { body1: body, axis: [0, 1, 0] });
      const motor = addJoint(w, 'MotorJoint', {
        body1: body,
        motor1Axis: [0, 1, 0],
        axis1Torque: 0,
      });
      return atTheEnd(() => strays(body, 300), {
        before: () => {
          // Enough to stop within a frame, but no more.
          const wanted = 2 * (300 - spin(body)[1]);
          motor.set('axis1Torque', Math.max(-50, Math.min(50, wanted)));
        },
      });
    },
  },
  {
    id: 'free slab',
    says: 'a slab and a cube of 300 rad/s turn as far as they spin',
    load: { of: 'radians in a second', ratio: 300 },
    seconds: 0.5,
    criterion: { what: 'farthest from where it would point', unit: 'rad', most: 2e-3 },
    promisedFrom: 'game',
    world: { gravity: [0, 0, 0] },
    scene(w) {
      const bodies = [box(1, 0.2, 0.5), box(1)].map((geometry, i) =>
        addBody(w, { position: [3 * i, 0, 0], angularVelocity: [0, 300, 0], geometry: [geometry] }),
      );
      return greatest(() => most(bodies.map((body) => behind(body, 300 * w.time))));
    },
  },
  {
    id: 'free ball',
    says: 'a ball of 1000 rad/s turns as far as it spins',
    load: { of: 'radians in a second', ratio: 1000 },
    seconds: 0.5,
    criterion: { what: 'farthest from where it would point', unit: 'rad', most: 2e-3 },
    promisedFrom: 'game',
    world: { gravity: [0, 0, 0] },
    scene(w) {
      const ball = addBody(w, { angularVelocity: [0, 1000, 0] });
      return greatest(() => behind(ball, 1000 * w.time));
    },
  },
  {
    id: 'car',
    says: 'a car that goes 60 m/s along a floor loses nothing, and its wheels roll on',
    load: { of: 'radians in a second', ratio: 200 },
    seconds: 1,
    criterion: { what: 'speed lost or gained, of its speed', unit: '', most: 1e-3 },
    promisedFrom: 'game',
    scene(w) {
      addFloor(w, 0, { geometry: [box(400, 1, 20)] });
      const { chassis, wheels } = addCar(w, 60);
      return greatest(() => {
        const rims = wheels.map((wheel) => -spin(wheel)[2] * RADIUS);
        return most([velocity(chassis)[0], ...rims].map((speed) => Math.abs(speed / 60 - 1)));
      });
    },
  },
  {
    id: 'tippe top',
    says: 'a tippe top of 90 rad/s is too slow to stand up',
    load: { of: 'radians in a second', ratio: 90 },
    seconds: 3,
    // It begins at 0.1; a fourth-order Runge-Kutta with Coulomb's friction has up to 9 degrees after seven seconds.
    criterion: { what: 'greatest lean', unit: 'rad', most: 0.14 },
    promisedFrom: 'game',
    scene(w) {
      addFloor(w);
      const top = addTippeTop(w, 90);
      return greatest(() => leanOf(top));
    },
  },
];
