import { move } from '../../references/mechanism.js';
import type { Case, CaseBody, Vec3 } from '../case.js';
import { frameOf } from './judging.js';
import { offPaths, roundingOf, type Path } from './paths.js';

// Tall boxes on an incline of tan θ = 1/2, which lies flat while gravity leans: those narrower than h tan θ tip over their
// lower edge where friction holds them, and where it does not, a box stands as long as it is wider than h μ.

const G = 9.81;
const SLOPE = Math.atan(0.5);
const HEIGHT = 1;
const [along, across] = [G * Math.sin(SLOPE), G * Math.cos(SLOPE)];
const GRAVITY: Vec3 = [along, -across, 0];

const floor: CaseBody = {
  name: 'floor',
  fixed: true,
  shape: { type: 'Box', size: [20, 1, 20] },
  position: [0, -0.5, 0],
};

const box = (name: string, width: number, z = 0): CaseBody => ({
  name,
  shape: { type: 'Box', size: [width, HEIGHT, 0.6] },
  position: [0, HEIGHT / 2, z],
});

/** Over its lower edge, on which it stands as a pendulum on its head. */
function tips(width: number, z = 0): Path {
  const [lean, arm] = [Math.atan2(width, HEIGHT), Math.hypot(width, HEIGHT) / 2];
  const at = (tipped: number): [x: number, y: number] => [
    width / 2 - arm * Math.sin(lean - tipped),
    arm * Math.cos(lean - tipped),
  ];
  const tipped = move(
    {
      places: (angle) => [angle, ...at(angle)],
      inertias: [(width ** 2 + HEIGHT ** 2) / 12, 1, 1],
      pulls: [0, along, -across],
    },
    0,
    0,
  );
  return (time) => [...at(tipped(frameOf(time)).at), z];
}

const stays =
  (z: number): Path =>
  () => [0, HEIGHT / 2, z];

/** Widths of what stands, and of what does not, against h tan θ. */
const WIDTHS = { stands: 1.02 * HEIGHT * 0.5, tips: 0.98 * HEIGHT * 0.5 };

/** What a box that tips is off by grows as e^(rate t). */
const grows = (seconds: number): number => Math.exp(Math.sqrt((3 * G) / (2 * HEIGHT)) * seconds);

const [over, threshold] = [0.75, 1.35].map((time) => Math.round(60 * time) / 60) as [
  number,
  number,
];
const NARROW = 0.4;

const SLIPS = { friction: 0.45, width: 1.02 * HEIGHT * 0.45, seconds: 1 };
const slides = G * (Math.sin(SLOPE) - SLIPS.friction * Math.cos(SLOPE));

export const cases: Case[] = [
  {
    id: 'tip-over',
    name: 'Box tips over on an incline',
    says: 'A box 0.4 m wide and 1 m high on a slope of 26.6°, friction 1; its place against a physical pendulum on its head about the lower edge, in double precision.',
    scene: {
      gravity: GRAVITY,
      bodies: [floor, box('box', NARROW)],
      contact: { bounce: 0, friction: 1 },
    },
    seconds: over,
    unit: 'm',
    size: 0.5,
    singlePrecision: roundingOf(1, over),
    watch: offPaths({ box: tips(NARROW) }),
  },
  {
    id: 'tip-threshold',
    name: 'Threshold of tipping',
    says: 'Two boxes on a slope of 26.6°, friction 1, wider and narrower by 2 % than what just stands, w / h = tan θ; the first stays, the second tips as a physical pendulum on its head.',
    scene: {
      gravity: GRAVITY,
      bodies: [floor, box('stands', WIDTHS.stands, -1), box('tips', WIDTHS.tips, 1)],
      contact: { bounce: 0, friction: 1 },
    },
    seconds: threshold,
    unit: 'm',
    size: 0.5,
    // What is off by the last digit of a half at first is off by e^(3.8 t) times that in the end.
    singlePrecision: 2 ** -25 * grows(threshold),
    watch: offPaths({ stands: stays(-1), tips: tips(WIDTHS.tips, 1) }),
  },
  {
    id: 'tip-or-slide',
    name: 'Box slides instead of tipping',
    says: 'A box on a slope of 26.6°, friction 0.45, wider by 2 % than what just stands while it slides, w / h = μ; its place against g (sin θ - μ cos θ) t²/2, upright.',
    scene: {
      gravity: GRAVITY,
      bodies: [floor, box('box', SLIPS.width)],
      contact: { bounce: 0, friction: SLIPS.friction },
    },
    seconds: SLIPS.seconds,
    unit: 'm',
    size: slides / 2,
    singlePrecision: roundingOf(1, SLIPS.seconds),
    watch: offPaths({ box: (time) => [(slides * time ** 2) / 2, HEIGHT / 2, 0] }),
  },
];
