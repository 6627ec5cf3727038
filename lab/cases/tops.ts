import { steadyTop } from '../../references/steady-top.js';
import type { Case } from '../case.js';
import { rounding } from './judging.js';
import { offPaths } from './paths.js';

// A top whose tip is a little ball that rolls on the floor: it leans, goes round steadily, and its tip with it.

const G = 9.81;

/** Metres: of the tip, and from the tip's middle to the centre of mass. */
const TIP = 0.05;
const ARM = 0.3;
/** Of a disc of 1 kg, 0.6 m wide and 5 cm thick: across its axis and about it, kg m². */
const ACROSS = (3 * 0.3 ** 2 + 0.05 ** 2) / 12;
const ABOUT = 0.3 ** 2 / 2;
/** Radians from the vertical, and how fast it goes round, rad/s. */
const LEAN = 0.4;
const ROUND = 2;

const { orientation, spin, velocity, path } = steadyTop({
  tip: TIP,
  arm: ARM,
  across: ACROSS,
  about: ABOUT,
  lean: LEAN,
  round: ROUND,
  gravity: G,
});

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
          orientation,
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
  },
];
