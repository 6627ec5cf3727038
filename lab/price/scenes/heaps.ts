import type { CaseBody, CaseScene, Vec3 } from '../../case.js';
import { wallsOf } from '../../walls.js';
import { ball, box, floor, layers, random, touching, type PriceScene } from '../scene.js';

// Boxes that fall on each other.

type Next = () => number;

/** As chance has it, edges of 0.4 to 0.7 m. */
function someBox(name: string, position: Vec3, next: Next): CaseBody {
  const edge = () => 0.4 + 0.3 * next();
  const size: Vec3 = [edge(), edge(), edge()];
  return { name, position, mass: size[0] * size[1] * size[2], shape: box(...size) };
}

/** Metres from box to box, so that turned ones don't begin in each other. */
const PITCH = 1.25;

const someTurn = (next: Next): [number, number, number, number] => [
  next() - 0.5,
  next() - 0.5,
  next() - 0.5,
  3 * next(),
];

/** Half the width of a pit that is about as wide as what is poured into it is high. */
const rowOf = (count: number): number => Math.max(2, Math.round(Math.cbrt(count)));
const halfOf = (count: number): number => (PITCH * rowOf(count)) / 2;

function poured(count: number): CaseScene {
  const [row, half] = [rowOf(count), halfOf(count)];
  const next = random();
  const boxes = layers(count, row, PITCH, 0.7).map((position, i) => ({
    ...someBox(`${i}`, position, next),
    orientation: someTurn(next),
  }));
  const height = 4 + PITCH * Math.ceil(count / row ** 2);
  return touching([floor(2 * half + 2), ...wallsOf(half, height), ...boxes]);
}

// ---- what is stirred -------------------------------------------------------------------------------------------------

/** Metres between the ends of the paddle and the wall: more than a box from corner to corner, so that none is jammed. */
const CLEARANCE = 1.4;
/** Radians per second. */
const STIR = 1;

function stirred(count: number): CaseScene {
  const { bodies } = poured(count);
  const paddle: CaseBody = {
    name: 'paddle',
    fixed: true,
    position: [0, 0.4, 0],
    turn: (time) => [0, 1, 0, STIR * time],
    shape: box(Math.max(0.4, 2 * (halfOf(count) - CLEARANCE)), 0.76, 0.2),
  };
  return touching([...bodies, paddle]);
}

/** Metres from box to box in a drum, and radians per second of it about z. */
const [PACKED, TUMBLE] = [0.75, 1.5];

/** One of four walls of a drum that turns, `half` metres from its middle. */
function drumWall(side: number, half: number): CaseBody {
  const angle = (time: number): number => (side * Math.PI) / 2 + TUMBLE * time;
  const out = half + 0.5;
  const path = (time: number): Vec3 => [
    out * Math.sin(angle(time)),
    -out * Math.cos(angle(time)),
    0,
  ];
  return {
    name: `side ${side}`,
    fixed: true,
    position: path(0),
    orientation: [0, 0, 1, angle(0)],
    path,
    turn: (time) => [0, 0, 1, angle(time)],
    shape: box(2 * half + 2, 1, 2 * half),
  };
}

/** Boxes that never lie still: in a square drum that turns between two plates. */
function tumbling(count: number): CaseScene {
  const row = Math.ceil(Math.cbrt(count));
  const half = (PACKED * row) / 2 + 0.05;
  const next = random();
  const boxes = layers(count, row, PACKED, PACKED / 2 - half + 0.05).map((position, i) =>
    someBox(`${i}`, position, next),
  );
  const plates = [-1, 1].map((side): CaseBody => ({
    name: side < 0 ? 'back' : 'front',
    fixed: true,
    position: [0, 0, side * (half + 0.5)],
    shape: box(6 * half, 6 * half, 1),
  }));
  return touching([...plates, ...[0, 1, 2, 3].map((side) => drumWall(side, half)), ...boxes]);
}

const drum = (size: number): PriceScene => ({
  id: `tumbling-${size}`,
  name: `${size} boxes tumbling in a drum`,
  size,
  small: 5,
  judged: 'overlap',
  driven: 'the drum',
  build: tumbling,
});

const pouring = (size: number, finest?: string): PriceScene => ({
  id: `poured-${size}`,
  name: `${size} boxes poured into a pit`,
  size,
  small: 8,
  judged: 'overlap',
  ...(finest && { finest }),
  build: poured,
});

/** Metres, and bricks of a row for each row. */
const BRICK: Vec3 = [0.4, 0.2, 0.2];
const SHAPE = 0.8;

function wall(count: number): CaseScene {
  const row = Math.round(Math.sqrt(SHAPE * count));
  const [length, height] = BRICK;
  const bricks = Array.from({ length: count }, (_, i): CaseBody => {
    const level = Math.floor(i / row);
    const shift = level % 2 ? 0 : 0.5;
    const position: Vec3 = [((i % row) - row / 2 + shift) * length, (level + 0.5) * height, 0];
    return { name: `${i}`, position, shape: box(...BRICK) };
  });
  const thrown: CaseBody = {
    name: 'ball',
    mass: 50,
    position: [0.1, 0.25 * count ** 0.5 * height, 8],
    linearVelocity: [0, 2, -20],
    shape: ball(0.4),
  };
  return touching([floor(100), ...bricks, thrown]);
}

export const heaps: PriceScene[] = [
  ...[10, 20, 30, 100].map(drum),
  ...[100, 300].map((size) => pouring(size)),
  pouring(1000, 'precise'),
  pouring(2000, 'fine'),
  pouring(5000, 'standard'),
  {
    id: 'paddle-500',
    name: 'paddle among 500 boxes',
    size: 500,
    small: 8,
    judged: 'overlap',
    driven: 'the paddle',
    finest: 'precise',
    build: stirred,
  },
  {
    id: 'wall-500',
    name: 'wall of 500 bricks and a ball',
    size: 500,
    small: 12,
    judged: 'overlap',
    finest: 'precise',
    build: wall,
  },
];
