import { add, rotate } from '../../physics-core/base/math.js';
import { move, type Mechanism } from '../../references/mechanism.js';
import type { Case, CaseBody, Vec3 } from '../case.js';
import { apart, frameOf, round, rounding, worst } from './judging.js';

// Plane machines whose bars close a loop, driven by a flywheel.

const WEIGHTLESS: Vec3 = [0, 0, 0];

/** A bar between two points: its middle and its angle. */
type Bar = [x: number, y: number, angle: number];

const bar = ([ax, ay]: readonly number[], [bx, by]: readonly number[]): Bar => [
  (ax! + bx!) / 2,
  (ay! + by!) / 2,
  Math.atan2(by! - ay!, bx! - ax!),
];

/** Bars that a crank moves, and how. */
interface Machine {
  bars: Record<string, { mass: number; moment: number; at(crank: number): Bar }>;
  crank: number;
  speed: number;
}

/** Angles without jumps: a bar that swings is nearest to where it was at the start. */
function nearest(angle: number, to: number): number {
  return angle + 2 * Math.PI * Math.round((to - angle) / (2 * Math.PI));
}

function mechanismOf({ bars, crank }: Machine): Mechanism {
  const all = Object.values(bars);
  return {
    places: (at) => [
      at,
      ...all.flatMap((each) => {
        const [x, y, angle] = each.at(at);
        return [x, y, nearest(angle, each.at(0)[2])];
      }),
    ],
    inertias: [crank, ...all.flatMap(({ mass, moment }) => [mass, mass, moment])],
  };
}

/** Each where it is at first, moving as the crank says. */
function bodiesOf({ bars, crank, speed }: Machine): CaseBody[] {
  const little = 1e-5;
  const rate = (at: (crank: number) => Bar, i: number): number =>
    (speed * (at(little)[i]! - at(-little)[i]!)) / (2 * little);
  return [
    { name: 'crank', mass: 5, inertia: round(crank), angularVelocity: [0, 0, speed] },
    ...Object.entries(bars).map(([name, { mass, moment, at }]): CaseBody => {
      const [x, y, angle] = at(0);
      return {
        name,
        mass,
        inertia: round(moment),
        position: [x, y, 0],
        orientation: [0, 0, 1, angle],
        linearVelocity: [rate(at, 0), rate(at, 1), 0],
        angularVelocity: [0, 0, rate(at, 2)],
      };
    }),
  ];
}

const hinge = (body1: string, body2: string | undefined, [x, y]: readonly number[]) => ({
  type: 'SingleAxisHingeJoint' as const,
  body1,
  ...(body2 && { body2 }),
  axis: [0, 0, 1],
  anchorPoint: [x!, y!, 0],
});

const spoke = (radius: number, angle: number): [number, number] => [
  radius * Math.cos(angle),
  radius * Math.sin(angle),
];

/** Where two circles meet, to the left of the way from the first centre to the second. */
function meeting(a: readonly number[], ra: number, b: readonly number[], rb: number): number[] {
  const [dx, dy] = [b[0]! - a[0]!, b[1]! - a[1]!];
  const d = Math.hypot(dx, dy);
  const along = (d * d + ra * ra - rb * rb) / (2 * d);
  const aside = Math.sqrt(ra * ra - along * along);
  return [a[0]! + (along * dx - aside * dy) / d, a[1]! + (along * dy + aside * dx) / d];
}

const four = { crank: 0.3, coupler: 1, rocker: 0.8, ground: [1, 0] };
const knee = (angle: number): number[] =>
  meeting(spoke(four.crank, angle), four.coupler, four.ground, four.rocker);
const fourBar: Machine = {
  crank: 0.5,
  speed: 4,
  bars: {
    coupler: { mass: 1, moment: 0.1, at: (c) => bar(spoke(four.crank, c), knee(c)) },
    rocker: { mass: 1, moment: 0.06, at: (c) => bar(four.ground, knee(c)) },
  },
};
const fourBarTurns = move(mechanismOf(fourBar), 0, fourBar.speed);

const slide = { crank: 0.3, rod: 1 };
const pin = (angle: number): number[] => {
  const [x, y] = spoke(slide.crank, angle);
  return [x + Math.sqrt(slide.rod ** 2 - y * y), 0];
};
const sliderCrank: Machine = {
  crank: 0.5,
  speed: 4,
  bars: {
    rod: { mass: 1, moment: 0.1, at: (c) => bar(spoke(slide.crank, c), pin(c)) },
    piston: { mass: 1, moment: 0.1, at: (c) => [pin(c)[0]!, 0, 0] },
  },
};
const sliderCrankTurns = move(mechanismOf(sliderCrank), 0, sliderCrank.speed);

export const cases: Case[] = [
  {
    id: 'linkage-four-bar',
    name: 'Four-bar linkage',
    says: 'A flywheel drives a coupler and a rocker: the knee between them, against the loop equation and the energy that all share.',
    scene: {
      gravity: WEIGHTLESS,
      bodies: bodiesOf(fourBar),
      joints: [
        hinge('crank', undefined, [0, 0]),
        hinge('crank', 'coupler', spoke(four.crank, 0)),
        hinge('coupler', 'rocker', knee(0)),
        hinge('rocker', undefined, four.ground),
      ],
    },
    seconds: 4,
    unit: 'm',
    size: 1,
    singlePrecision: rounding(1, 1.5, 4),
    watch: ({ position, orientation }) =>
      worst((t) => {
        const half = rotate(orientation('rocker'), [four.rocker / 2, 0, 0]);
        const [x, y] = knee(fourBarTurns(frameOf(t)).at);
        return apart(add(position('rocker'), half), [x!, y!, 0]);
      }),
  },
  {
    id: 'linkage-slider-crank',
    name: 'Slider-crank',
    says: 'A flywheel drives a piston through a rod: where the piston is, against x = r cos θ + √(l² - r² sin² θ) and the energy that all share.',
    scene: {
      gravity: WEIGHTLESS,
      bodies: bodiesOf(sliderCrank),
      joints: [
        hinge('crank', undefined, [0, 0]),
        hinge('crank', 'rod', spoke(slide.crank, 0)),
        hinge('rod', 'piston', pin(0)),
        {
          type: 'SliderJoint',
          body1: 'piston',
          axis: [1, 0, 0],
          minSeparation: 1,
          maxSeparation: 0,
        },
      ],
    },
    seconds: 4,
    unit: 'm',
    size: 0.6,
    singlePrecision: rounding(1.3, 1.5, 4),
    watch: ({ position }) =>
      worst((t) => apart(position('piston'), [pin(sliderCrankTurns(frameOf(t)).at)[0]!, 0, 0])),
  },
];
