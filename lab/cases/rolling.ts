import { scale } from '../../physics-core/base/math.js';
import type { Case, CaseBody, Vec3 } from '../case.js';
import { offPathsOnFloor, roundingOf, type Path } from './paths.js';

const GRAVITY = 9.81;
const RADIUS = 0.5;

const floor: CaseBody = {
  name: 'floor',
  fixed: true,
  shape: { type: 'Box', size: [40, 1, 40] },
  position: [0, -0.5, 0],
};

const ball = (fields: Partial<CaseBody> = {}): CaseBody => ({
  name: 'ball',
  shape: { type: 'Sphere', radius: RADIUS },
  position: [0, RADIUS, 0],
  ...fields,
});

function down(id: string, friction: number): Case {
  const [angle, seconds] = [Math.PI / 9, 1];
  const along = GRAVITY * Math.sin(angle);
  const across = GRAVITY * Math.cos(angle);
  const rolls = friction >= (2 / 7) * Math.tan(angle);
  const acceleration = rolls ? (5 / 7) * along : along - friction * across;
  const gravity: Vec3 = [along, -across, 0];
  return {
    id,
    name: rolls ? 'Ball rolls down an incline' : 'Ball slips down an incline',
    says: rolls
      ? `A ball on a slope of 20°, friction ${friction}; its place against (5/7) g sin θ t²/2.`
      : `A ball on a slope of 20°, friction ${friction}, too little to roll; its place against g (sin θ - μ cos θ) t²/2.`,
    scene: {
      gravity,
      bodies: [floor, ball()],
      contact: { bounce: 0, friction },
    },
    seconds,
    unit: 'm',
    size: acceleration / 2,
    singlePrecision: roundingOf(1, seconds),
    watch: offPathsOnFloor({ ball: (time) => [(acceleration * time ** 2) / 2, RADIUS, 0] }),
  };
}

function launched(): Case {
  const [speed, friction, seconds] = [5, 0.3, 1];
  const brake = friction * GRAVITY;
  const slides = (2 * speed) / (7 * brake);
  const path: Path = (time) => {
    const t = Math.min(time, slides);
    const way = speed * t - (brake * t ** 2) / 2 + (5 / 7) * speed * (time - t);
    return [way, RADIUS, 0];
  };
  return {
    id: 'slide-into-roll',
    name: 'Ball launched sliding',
    says: `A ball without spin on a floor at ${speed} m/s, friction ${friction}: it slides for 2 v/(7 μ g), then rolls at 5/7 of its speed; its place against that.`,
    scene: {
      gravity: [0, -GRAVITY, 0],
      bodies: [floor, ball({ linearVelocity: [speed, 0, 0] })],
      contact: { bounce: 0, friction },
    },
    seconds,
    unit: 'm',
    size: path(seconds)[0],
    singlePrecision: roundingOf(4, seconds),
    watch: offPathsOnFloor({ ball: path }),
  };
}

/** Heading along the floor, radians, and where it starts across it. */
interface Course {
  name: string;
  heading: number;
  z: number;
}

function cylinders(): Case {
  const [speed, seconds] = [2, 3];
  const courses: Course[] = [0, 30, 77].map((degrees, i) => ({
    name: `at ${degrees}°`,
    heading: (degrees * Math.PI) / 180,
    z: 1.5 * i - 4.5,
  }));
  const path =
    ({ heading, z }: Course): Path =>
    (time) => [speed * time * Math.cos(heading) - 3, RADIUS, z + speed * time * Math.sin(heading)];
  const cylinder = (course: Course): CaseBody => {
    const along: Vec3 = [Math.cos(course.heading), 0, Math.sin(course.heading)];
    return {
      name: course.name,
      shape: { type: 'Cylinder', radius: RADIUS, height: 0.4 },
      position: path(course)(0),
      orientation: [...along, Math.PI / 2],
      linearVelocity: scale(along, speed),
      angularVelocity: scale([along[2], 0, -along[0]], speed / RADIUS),
    };
  };
  return {
    id: 'roll-cylinders',
    name: 'Rolling cylinders',
    says: `Cylinders roll over a floor at ${speed} m/s, in three directions, friction 0.5; their places against v t.`,
    scene: {
      gravity: [0, -GRAVITY, 0],
      bodies: [floor, ...courses.map(cylinder)],
      contact: { bounce: 0, friction: 0.5 },
    },
    seconds,
    unit: 'm',
    size: speed * seconds,
    singlePrecision: roundingOf(4, seconds),
    watch: offPathsOnFloor(
      Object.fromEntries(courses.map((course) => [course.name, path(course)])),
    ),
  };
}

export const cases: Case[] = [
  down('slope-ball-rolls', 0.5),
  down('slope-ball-slips', 0.05),
  launched(),
  cylinders(),
];
