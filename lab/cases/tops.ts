import { add, cross, quaternionOf, rotate, scale } from '../../physics-core/base/math.js';
import type { Case, Vec3 } from '../case.js';
import { rounding } from './judging.js';
import { offPaths, type Path } from './paths.js';

// A top whose tip is a little ball that rolls on the floor: it leans, goes round steadily, and its tip with it.

const G = 9.81;
const UP: Vec3 = [0, 1, 0];
/** Metres: of the tip, and from the tip's middle to the centre of mass. */
const TIP = 0.05;
const ARM = 0.3;
/** Of a disc of 1 kg, 0.6 m wide and 5 cm thick: across its axis and about it, kg m². */
const ACROSS = (3 * 0.3 ** 2 + 0.05 ** 2) / 12;
const ABOUT = 0.3 ** 2 / 2;
/** Radians from the vertical, and how fast it goes round, rad/s. */
const LEAN = 0.4;
const ROUND = 2;

/**
 * How fast it turns about its axis besides, rad/s: what gravity and the floor turn it by is what its angular momentum,
 * going round, needs. Where the tip touches nothing slips.
 */
const lever = TIP + ARM * Math.cos(LEAN);
const spins =
  (G * ARM + ROUND ** 2 * (ARM * lever + Math.cos(LEAN) * (ACROSS - ABOUT))) /
  (ROUND * (ABOUT + TIP * lever));

const tilt = quaternionOf([0, 0, 1, -LEAN]);
const axis = rotate(tilt, UP);
const spin = add(scale(UP, ROUND), scale(axis, spins));
const velocity = add(scale(cross(axis, UP), spins * TIP), scale(cross(UP, axis), ROUND * ARM));
/** Of the circle that its centre of mass goes, on the side to which it leans where positive. */
const wide = (ARM - (spins * TIP) / ROUND) * Math.sin(LEAN);
const height = TIP + ARM * Math.cos(LEAN);

const path: Path = (time) => [
  wide * Math.cos(ROUND * time),
  height,
  -wide * Math.sin(ROUND * time),
];

const seconds = 3;

export const cases: Case[] = [
  {
    id: 'spin-top-on-floor',
    name: 'Top that stands on the floor',
    says: `A disc on a stick, its tip a ball of ${TIP} m on a floor, leans by ${LEAN} rad and goes round steadily at ${ROUND} rad/s, its tip rolling, friction 0.5; its place against that circle.`,
    scene: {
      gravity: [0, -G, 0],
      bodies: [
        {
          name: 'floor',
          fixed: true,
          shape: { type: 'Box', size: [10, 1, 10] },
          position: [0, -0.5, 0],
        },
        {
          name: 'top',
          shape: { type: 'Sphere', radius: TIP },
          offset: [0, -ARM, 0],
          inertia: [ACROSS, ABOUT, ACROSS],
          position: path(0),
          orientation: [0, 0, 1, -LEAN],
          linearVelocity: velocity,
          angularVelocity: spin,
        },
      ],
      contact: { bounce: 0, friction: 0.5 },
    },
    seconds,
    unit: 'm',
    size: ARM,
    singlePrecision: rounding(0.4, 0.3, seconds),
    watch: offPaths({ top: path }),
    exception:
      'what contacts change of its spin in a step is added to the spin of the orientation to which it would have come without them: at coarse steps such errors turn it this way or that, and a finer one need not be nearer yet.',
    behind:
      'what contacts change of its spin in a step is added to the spin of the orientation to which it would have come without them, and a top that leans loses by that; others add it before they turn the body.',
  },
];
