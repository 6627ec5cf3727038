import { scale } from '../../physics-core/base/math.js';
import type { Case, CaseBody, Shape, Vec3 } from '../case.js';
import { round } from './judging.js';
import { offPathsOnFloor, roundingOf, type Path } from './paths.js';

// What is round and set down on a floor with another spin than it would roll with: it slips, steadily braked, until it rolls.

const GRAVITY = 9.81;
const RADIUS = 0.5;
const FRICTION = 0.3;

interface Launch {
  /** m/s along its heading. */
  speed: number;
  /** m/s of its rim as if it rolled; backspin is negative. */
  rim: number;
  /** I / (m r²): 1/2 of a cylinder, 1 of a hoop. */
  share: number;
  /** Radians from x. */
  heading: number;
}

/** Metres along its heading: it slips until it rolls at (v + k r ω) / (1 + k). */
function wayOf({ speed, rim, share }: Launch): (time: number) => number {
  const brake = FRICTION * GRAVITY;
  const rolls = (speed + share * rim) / (1 + share);
  const slips = (speed - rolls) / brake;
  return (time) => {
    const t = Math.min(time, slips);
    return speed * t - (brake * t ** 2) / 2 + rolls * (time - t);
  };
}

const floor: CaseBody = {
  name: 'floor',
  fixed: true,
  shape: { type: 'Box', size: [40, 1, 40] },
  position: [0, -0.5, 0],
};

/** Of 1 kg; the axis of what has one lies across its way. */
function launched({ speed, rim, heading }: Launch, shape: Shape, inertia?: Vec3): CaseBody {
  const along: Vec3 = [Math.cos(heading), 0, -Math.sin(heading)];
  return {
    name: 'wheel',
    shape,
    position: [0, RADIUS, 0],
    orientation: [...along, Math.PI / 2],
    linearVelocity: scale(along, speed),
    angularVelocity: scale([along[2], 0, -along[0]], rim / RADIUS),
    ...(inertia && { inertia }),
  };
}

function pathOf(launch: Launch): Path {
  const way = wayOf(launch);
  const { heading } = launch;
  return (time) => [way(time) * Math.cos(heading), RADIUS, -way(time) * Math.sin(heading)];
}

interface Wheel extends Pick<Case, 'id' | 'name' | 'says' | 'seconds' | 'size'> {
  launch: Launch;
  shape: Shape;
  inertia?: Vec3;
}

const wheel = ({ launch, shape, inertia, ...words }: Wheel): Case => ({
  ...words,
  scene: {
    gravity: [0, -GRAVITY, 0],
    bodies: [floor, launched(launch, shape, inertia)],
    contact: { bounce: 0, friction: FRICTION },
  },
  unit: 'm',
  singlePrecision: roundingOf(4, words.seconds),
  watch: offPathsOnFloor({ wheel: pathOf(launch) }),
});

const WIDTH = 0.4;
const cylinder: Shape = { type: 'Cylinder', radius: RADIUS, height: WIDTH };
const rolls: Launch = { speed: 4, rim: 0, share: 1 / 2, heading: Math.PI / 6 };
const hoop: Launch = { ...rolls, share: 1, heading: 0 };
/** Of a thin hoop across its axis, kg m². */
const hoopAcross = RADIUS ** 2 / 2 + WIDTH ** 2 / 12;
const hollow: Launch = { speed: 3, rim: -6, share: 2 / 3, heading: Math.PI / 3 };

export const cases: Case[] = [
  wheel({
    id: 'slide-into-roll-cylinder',
    name: 'Cylinder launched sliding',
    says: 'A cylinder without spin on a floor at 4 m/s, 30° from the axis, friction 0.3: it slides for v/(3 μ g), then rolls at 2/3 of its speed; its place against that.',
    seconds: 1,
    size: wayOf(rolls)(1),
    launch: rolls,
    shape: cylinder,
  }),
  wheel({
    id: 'slide-into-roll-hoop',
    name: 'Hoop launched sliding',
    says: 'A thin hoop without spin on a floor at 4 m/s, friction 0.3: it slides for v/(2 μ g), then rolls at half of its speed; its place against that.',
    seconds: 1,
    size: wayOf(hoop)(1),
    launch: hoop,
    shape: cylinder,
    inertia: [hoopAcross, RADIUS ** 2, hoopAcross],
  }),
  wheel({
    id: 'slide-into-roll-back',
    name: 'Hollow ball thrown with backspin',
    says: 'A thin hollow ball thrown at 3 m/s, 60° from the axis, with a backspin of 12 rad/s, friction 0.3: it slips for 2 (v + r ω)/(5 μ g), then rolls back at (2 r ω - 3 v)/5; its place against that.',
    seconds: 2,
    size: hollow.speed ** 2 / (2 * FRICTION * GRAVITY),
    launch: hollow,
    shape: { type: 'Sphere', radius: RADIUS },
    inertia: round((2 / 3) * RADIUS ** 2),
  }),
];
