import type { CaseBody, CaseJoint, CaseScene, Vec3 } from '../../case.js';
import { links } from '../../page/scene.js';
import { LIMBS, massOfLimb } from '../../ragdoll.js';
import { wallsOf } from '../../walls.js';
import { ball, box, floor, layers, touching, type PriceScene } from '../scene.js';

// What hangs together and touches.

const plus = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const between = (a: Vec3, b: Vec3): Vec3 => [
  (a[0] + b[0]) / 2,
  (a[1] + b[1]) / 2,
  (a[2] + b[2]) / 2,
];

const joined = (body1: string, body2: string, anchorPoint: Vec3): CaseJoint => ({
  type: 'BallJoint',
  body1,
  body2,
  anchorPoint,
});

function ragdoll(name: string, place: Vec3): { bodies: CaseBody[]; joints: CaseJoint[] } {
  const limb = (i: number): string => `${name} ${i}`;
  return {
    bodies: LIMBS.map(({ size, at }, i) => ({
      name: limb(i),
      mass: massOfLimb(size),
      position: plus(place, at),
      shape: box(...size),
    })),
    joints: LIMBS.flatMap(({ on, joint }, i) =>
      on === undefined || !joint ? [] : [joined(limb(i), limb(on), plus(place, joint))],
    ),
  };
}

/** In layers over a pit, four times as high as it is wide where they start. */
function ragdolls(count: number): CaseScene {
  const row = Math.max(2, Math.round(Math.sqrt(count / 5)));
  const [apart, half] = [2, row];
  const dolls = layers(count, row, apart, 1.2).map((place, i) => ragdoll(`doll ${i}`, place));
  return touching(
    [floor(2 * half + 2), ...wallsOf(half, 20), ...dolls.flatMap(({ bodies }) => bodies)],
    dolls.flatMap(({ joints }) => joints),
  );
}

/** Metres from knot to knot. */
const MESH = 0.2;

/** Knots in the level above a ball, each joined to its neighbours half-way. */
function net(size: number): CaseScene {
  const middle = (size - 1) / 2;
  const at = (n: number): Vec3 => [
    (Math.floor(n / size) - middle) * MESH,
    2,
    ((n % size) - middle) * MESH,
  ];
  const knots = Array.from({ length: size ** 2 }, (_, n): CaseBody => ({
    name: `${n}`,
    mass: 0.1,
    position: at(n),
    shape: ball(0.03),
  }));
  const tie = (n: number, other: number) => joined(`${n}`, `${other}`, between(at(n), at(other)));
  const ties = knots.flatMap((_, n) => [
    ...(n + size < size ** 2 ? [tie(n, n + size)] : []),
    ...((n + 1) % size ? [tie(n, n + 1)] : []),
  ]);
  const under: CaseBody = { name: 'ball', fixed: true, position: [0, 1, 0], shape: ball(0.8) };
  return touching([under, ...knots], ties);
}

/** Metres of a link; how steep a chain is let go, and where its lower end is. */
const [LINK, SLOPE, LOW] = [0.2, 0.1, 0.1];

/** Let go aslant, so that one link after the other meets the ground. */
function chain(count: number): CaseScene {
  const [across, up] = [Math.cos(SLOPE), Math.sin(SLOPE)];
  const at = (way: number): Vec3 => [way * LINK * across, LOW + way * LINK * up, 0];
  const bodies = Array.from({ length: count }, (_, i): CaseBody => ({
    name: `${i}`,
    mass: 0.2,
    position: at(i + 0.5),
    orientation: [0, 0, 1, SLOPE],
    shape: box(0.9 * LINK, 0.06, 0.06),
  }));
  const joints = bodies.slice(1).map((_, i) => joined(`${i + 1}`, `${i}`, at(i + 1)));
  return touching([floor(100), ...bodies], joints);
}

/** Scene 4 of the paper. */
function spiral(count: number): CaseScene {
  const { things, hinges } = links(count);
  return touching(
    things.map(({ name, shape, position, turn = 0, mass }) => ({
      name,
      position: [...position],
      orientation: [0, 1, 0, turn],
      shape: typeof shape === 'number' ? ball(shape) : box(...shape),
      ...(mass > 0 ? { mass } : { fixed: true }),
    })),
    hinges.map(({ bodies: [one, other], anchor }) => ({
      type: 'SingleAxisHingeJoint',
      body1: one.name,
      body2: other.name,
      axis: [0, 1, 0],
      anchorPoint: [...anchor],
    })),
  );
}

const dolls = (size: number, finest: string): PriceScene => ({
  id: `ragdolls-${size}`,
  name: `${size} ragdolls in a pit`,
  size,
  small: 1,
  judged: 'gap',
  finest,
  build: ragdolls,
});

export const jointed: PriceScene[] = [
  dolls(20, 'precise'),
  dolls(100, 'fine'),
  {
    id: 'net-20',
    name: 'net of 20 × 20 knots on a ball',
    size: 20,
    small: 4,
    judged: 'gap',
    finest: 'fine',
    bound: 4,
    build: net,
  },
  {
    id: 'chain-100',
    name: 'chain of 100 on the ground',
    size: 100,
    small: 5,
    judged: 'gap',
    finest: 'precise',
    build: chain,
  },
  {
    id: 'spiral-200',
    name: 'spiral of 200 hinged boxes',
    size: 200,
    small: 5,
    judged: 'gap',
    finest: 'precise',
    build: spiral,
  },
];
