import { cos, sin } from '../../../physics-core/base/exact/index.js';
import { arch, cards, hullCube, pyramid, stack, wall } from '../../../references/structures.js';
import type { StabilityCase } from '../case.js';
import { toldStanding } from '../told.js';
import { addBody, addFloor, box, greatest, moved, type Fields } from '../scene.js';

// What stands upon each other stands where it was put.

const cylinder = { type: 'Cylinder', radius: 0.5, height: 1 };

interface Standing extends Pick<
  StabilityCase,
  'id' | 'says' | 'promisedFrom' | 'load' | 'finest' | 'slow' | 'alsoTested' | 'mayTell'
> {
  seconds?: number;
  /** Metres; a millimetre by default. */
  most?: number;
}

const standing = (
  { seconds = 60, most = 1e-3, ...words }: Standing,
  all: () => Fields[],
): StabilityCase => ({
  ...(words.promisedFrom === 'game' && { alsoTested: ['standard'] }),
  ...words,
  seconds,
  criterion: { what: 'farthest from its place', unit: 'm', most },
  told: () => toldStanding(all()),
  scene(w) {
    addFloor(w);
    return greatest(moved(all().map((one) => addBody(w, one))));
  },
});

/** Two cards that lean on each other. */
const house = (): Fields[] => {
  const [long, thick, lean] = [1, 0.04, 0.35];
  const half = (long * sin(lean) + thick * cos(lean)) / 2;
  const tall = long * cos(lean) + thick * sin(lean);
  return [-1, 1].map((side) => ({
    position: [side * half, tall / 2, 0],
    orientation: [0, 0, 1, side * lean],
    mass: 0.1,
    geometry: [box(thick, long, 0.7)],
  }));
};

/** Five boxes of 1 kg under one of so many. */
const heavy = (ratio: number, promisedFrom: Standing['promisedFrom']): StabilityCase =>
  standing(
    {
      id: `S8 1:${ratio}`,
      says: `${ratio} kg stand on five boxes of 1 kg`,
      load: { of: 'masses', ratio },
      promisedFrom,
      seconds: ratio === 100 ? 60 : 10,
      // At levels that do not promise it.
      ...(ratio > 1000 && { mayTell: ['mass-ratio'] }),
    },
    () => stack(6, 1, (i) => ({ mass: i < 5 ? 1 : ratio })),
  );

/** Large ones take minutes at `reference`. */
const large = (count: number) => (count > 20 ? ({ finest: 'precise' } as const) : {});

const tower = (count: number, id: string, seconds = 60): StabilityCase =>
  standing(
    {
      id,
      says: `a tower of ${count} boxes stands`,
      load: { of: 'boxes', ratio: count },
      promisedFrom: 'game',
      seconds,
      ...large(count),
    },
    () => stack(count),
  );

export const towers: StabilityCase[] = [
  tower(5, 'tower of 5'),
  tower(10, 'tower of 10'),
  tower(20, 'S4'),
  tower(30, 'tower of 30'),
  tower(50, 'S5', 10),
  standing(
    {
      id: 'small boxes',
      says: 'a tower of thirty boxes of 5 cm stands',
      load: { of: 'boxes', ratio: 30 },
      most: 5e-4,
      finest: 'precise',
      promisedFrom: 'game',
    },
    () => stack(30, 0.05),
  ),
  standing(
    {
      id: 'cylinders',
      says: 'ten cylinders stand on end upon each other',
      load: { of: 'cylinders', ratio: 10 },
      promisedFrom: 'game',
    },
    () => stack(10, 1, () => ({ geometry: [cylinder] })),
  ),
  standing(
    {
      id: 'hulls',
      says: 'a tower of ten cubes that are made of faces stands',
      load: { of: 'cubes', ratio: 10 },
      promisedFrom: 'game',
    },
    () => stack(10, 1, () => ({ geometry: [hullCube] })),
  ),
];

export const loads: StabilityCase[] = [
  heavy(10, 'game'),
  heavy(100, 'game'),
  heavy(300, 'game'),
  heavy(1000, 'game'),
  heavy(10_000, 'fine'),

  standing(
    {
      id: '1 on 1:1000',
      says: '1000 kg stand on 1 kg',
      load: { of: 'masses', ratio: 1000 },
      promisedFrom: 'game',
    },
    () => stack(2, 1, (i) => ({ mass: 1000 ** i })),
  ),
  standing(
    {
      id: 'doubled',
      says: 'ten boxes stand, each twice as heavy as the one below',
      load: { of: 'masses', ratio: 512 },
      promisedFrom: 'game',
    },
    () => stack(10, 1, (i) => ({ mass: 2 ** i })),
  ),
];

export const structures: StabilityCase[] = [
  standing(
    {
      id: 'S6',
      says: 'a pyramid of ten rows stands',
      load: { of: 'rows', ratio: 10 },
      finest: 'precise',
      promisedFrom: 'game',
    },
    () => pyramid(10),
  ),
  standing(
    { id: 'S7', says: 'two cards that lean on each other stand', promisedFrom: 'standard' },
    house,
  ),
  standing(
    {
      id: 'card house',
      says: 'a card house of three storeys stands',
      load: { of: 'storeys', ratio: 3 },
      promisedFrom: 'game',
      alsoTested: ['standard', 'fine'],
    },
    cards,
  ),
  standing(
    {
      id: 'wall',
      says: 'a wall of ten rows of bricks stands',
      load: { of: 'rows', ratio: 10 },
      finest: 'precise',
      slow: true,
      promisedFrom: 'game',
    },
    () => wall(10, 10, 0),
  ),
  standing(
    {
      id: 'wall with joints',
      says: 'a wall of ten rows of bricks 1 mm apart stands',
      load: { of: 'rows', ratio: 10 },
      finest: 'precise',
      slow: true,
      promisedFrom: 'game',
    },
    () => wall(10, 10, 1e-3),
  ),
  standing(
    {
      id: 'arch',
      says: 'an arch of 13 wedges stands',
      load: { of: 'wedges', ratio: 13 },
      promisedFrom: 'game',
      alsoTested: ['standard', 'fine'],
    },
    () => arch(13),
  ),
];
