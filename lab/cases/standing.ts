import type { Case, CaseBody, Shape, Vec3 } from '../case.js';
import { apart, worst } from './judging.js';

// What stands or leans has to stay where it was put.

const GRAVITY: Vec3 = [0, -9.81, 0];
const SECONDS = 10;

/** Its top is at height 0. */
const floor: CaseBody = {
  name: 'floor',
  fixed: true,
  shape: { type: 'Box', size: [40, 1, 40] },
  position: [0, -0.5, 0],
};

interface Standing {
  id: string;
  name: string;
  says: string;
  friction: number;
  bodies: CaseBody[];
  /** Metres that the farthest corner is from the origin. */
  reach: number;
  exception?: string;
}

/** How far any of these bodies was from where it was put, at worst. */
const standing = ({ bodies, friction, reach, ...words }: Standing): Case => ({
  ...words,
  scene: { gravity: GRAVITY, bodies: [floor, ...bodies], contact: { bounce: 0, friction } },
  seconds: SECONDS,
  unit: 'm',
  size: 1,
  // Each place is rounded once, and what lies on it goes by that.
  singlePrecision: 2 ** -23 * reach * bodies.length,
  watch: ({ position }) =>
    worst(() => Math.max(...bodies.map((body) => apart(position(body.name), body.position!)))),
});

/** One on the other, each 1 m high. */
const column = (shape: Shape, masses: readonly number[]): CaseBody[] =>
  masses.map((mass, i) => ({ name: `${i + 1}`, shape, mass, position: [0, i + 0.5, 0] }));

const cube: Shape = { type: 'Box', size: [1, 1, 1] };
const cylinder: Shape = { type: 'Cylinder', radius: 0.5, height: 1 };
const alike = (count: number): number[] => Array<number>(count).fill(1);

const stack = (count: number): Case =>
  standing({
    id: `stack-${count}`,
    name: `Stack of ${count} boxes`,
    says: `${count} boxes of 1 m, one on the other, for ${SECONDS} s; how far any of them gets from where it was put, down or aside.`,
    friction: 0.5,
    bodies: column(cube, alike(count)),
    reach: count,
  });

// ---- a house of cards ------------------------------------------------------------------------------------------------

/** Metres, and radians from the vertical. */
const card = { height: 1, thickness: 0.04, width: 0.6, lean: Math.PI / 9 };
const CARDS_FRICTION = 0.8;

const [up, across] = [Math.cos(card.lean), Math.sin(card.lean)];
/** Of a leaning card: from corner to corner, and from the middle to where it meets the other. */
const storey = card.height * up + card.thickness * across;
const half = (card.thickness * up + card.height * across) / 2;
/** From one pair to the next: they stand apart by as much as a pair is wide and a thickness more. */
const PITCH = 4 * half + card.thickness;

const leaning = (name: string, x: number, y: number, side: 1 | -1): CaseBody => ({
  name,
  shape: { type: 'Box', size: [card.thickness, card.height, card.width] },
  position: [x + side * half, y + storey / 2, 0],
  orientation: [0, 0, 1, side * card.lean],
  mass: 0.1,
});

/** On the points of two pairs, from the middle of one to the middle of the other and beyond. */
const lying = (name: string, x: number, y: number): CaseBody => ({
  name,
  shape: { type: 'Box', size: [card.thickness, 1.5 * PITCH, card.width] },
  position: [x, y + card.thickness / 2, 0],
  orientation: [0, 0, 1, Math.PI / 2],
  mass: 0.15,
});

/** Two pairs, a card across them, and a pair on that. */
const house = (): CaseBody[] => {
  const next = storey + card.thickness;
  return [
    ...[-PITCH / 2, PITCH / 2].flatMap((x, i) => [
      leaning(`left ${i + 1}`, x, 0, -1),
      leaning(`right ${i + 1}`, x, 0, 1),
    ]),
    lying('across', 0, storey),
    leaning('left above', 0, next, -1),
    leaning('right above', 0, next, 1),
  ];
};

export const cases: Case[] = [
  stack(10),
  stack(20),
  standing({
    id: 'stack-100-on-1',
    name: '100 kg on 1 kg',
    says: `A box of 100 kg on one of 1 kg, both of 1 m, for ${SECONDS} s; how far either gets from where it was put.`,
    friction: 0.5,
    bodies: column(cube, [1, 100]),
    reach: 2,
  }),
  standing({
    id: 'stack-cylinders',
    name: 'Five cylinders on end',
    says: `Five cylinders of 1 m, on end, one on the other, for ${SECONDS} s; how far any of them gets from where it was put.`,
    friction: 0.5,
    bodies: column(cylinder, alike(5)),
    reach: 5,
  }),
  standing({
    id: 'house-of-cards',
    name: 'House of cards',
    says: `Two pairs of cards that lean by 20°, a card across them and a pair on that, friction ${CARDS_FRICTION}, for ${SECONDS} s; how far any of them gets from where it was put.`,
    friction: CARDS_FRICTION,
    bodies: house(),
    reach: 3,
  }),
];
