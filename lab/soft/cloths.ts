import type { Shape, Vec3 } from '../case.js';
import { G, type Judged, type SoftCase } from './case.js';
import { threadsOf, trianglesOf, type SoftRunning, type SoftScene } from './scene.js';
import { goOn, swingOf } from './watch.js';

/** A sheet of squares around the origin, row by row; `across`: where a row lies that is so far from the middle. */
const sheet = (cells: number, size: number, across: (way: number) => [y: number, z: number]) =>
  Array.from({ length: (cells + 1) ** 2 }, (_, n): Vec3 => {
    const at = (i: number): number => (i / cells - 0.5) * size;
    const [y, z] = across(at(Math.floor(n / (cells + 1))));
    return [at(n % (cells + 1)), y, z];
  });

const upright = (way: number): [number, number] => [way, 0];
const level =
  (y: number) =>
  (way: number): [number, number] => [y, way];

// ---- hanging -----------------------------------------------------------------------------------------------------------

/** Of 30 by 30 points. */
const SQUARES = 29;

export const hangingCloth: SoftCase = {
  id: 'hanging-cloth',
  name: 'Cloth of 30 × 30 that hangs',
  scene: {
    gravity: G,
    cells: [SQUARES, SQUARES],
    points: sheet(SQUARES, 1, upright),
    mass: 0.3,
    shear: 10,
    damping: 1,
    fixed: Array.from({ length: SQUARES + 1 }, (_, i) => SQUARES * (SQUARES + 1) + i),
  },
  judged: [{ id: 'length', name: 'length of a hanging cloth', unit: 'm', aim: 2e-3, floor: 1e-7 }],
  run(running) {
    goOn(running, 4);
    const low = running.places().slice(0, SQUARES + 1);
    return { length: Math.max(...low.map(([, y]) => Math.abs(y + 0.5))) };
  },
};

// ---- a net -------------------------------------------------------------------------------------------------------------

/** Squares of a net of one metre, N/m, kg, and how many times as wide it is drawn. */
const [MESH, STIFFNESS, MASS, WIDER] = [20, 50, 0.4, 1.1];

const place = (n: number): [column: number, row: number] => [
  n % (MESH + 1),
  Math.floor(n / (MESH + 1)),
];

const netPoints = sheet(MESH, 1, level(0));

/** How much of the slowest mode is in where its points are. */
const modeOf = (running: SoftRunning): number =>
  running.places().reduce((sum, [, y], n) => {
    const [column, row] = place(n);
    return sum + y * Math.sin((Math.PI * column) / MESH) * Math.sin((Math.PI * row) / MESH);
  }, 0);

/** Seconds: each thread pulls its neighbours by what it is too long. */
function netPeriod(): number {
  const pull = (STIFFNESS / MESH) * (WIDER - 1);
  const lightness = MESH ** 2 / MASS;
  const length = WIDER / MESH;
  const square = ((8 * pull * lightness) / length) * Math.sin(Math.PI / (2 * MESH)) ** 2;
  return (2 * Math.PI) / Math.sqrt(square);
}

/** A little weight brings it out of the level. */
const LITTLE = 0.02;

export const net: SoftCase = {
  id: 'net',
  name: 'Net of 20 × 20 under tension, lowest mode',
  scene: {
    gravity: LITTLE,
    cells: [MESH, MESH],
    points: netPoints,
    mass: MASS,
    stretch: STIFFNESS,
    damping: 4,
    spread: WIDER,
    fixed: [...netPoints.keys()].filter((n) => place(n).some((i) => i === 0 || i === MESH)),
  },
  judged: [
    { id: 'period', name: 'period of a net', unit: 'share', aim: 1e-3, floor: 1e-6 },
    {
      id: 'amplitude',
      name: 'amplitude of a net after 10 swings',
      unit: 'share',
      aim: 2e-2,
      floor: 1e-4,
    },
  ],
  run(running) {
    goOn(running, 6);
    running.free();
    const start = Math.abs(modeOf(running));
    const right = netPeriod();
    const { period, most } = swingOf(running, 10 * right, () => modeOf(running));
    return { period: Math.abs(period / right - 1), amplitude: Math.abs(most / start - 1) };
  },
};

// ---- lying -------------------------------------------------------------------------------------------------------------

/** Squares of a cloth of one metre and 1024 points. */
const FINE = 31;

/** Parts of a side of a triangle between which it is looked at. */
const PARTS = 4;

/** How deep the deepest place of its triangles lies in what it lies on, m. */
function deepest(running: SoftRunning, scene: SoftScene, out: (at: Vec3) => number): number {
  const points = running.places();
  const index = trianglesOf(scene);
  let most = 0;
  for (let f = 0; f < index.length; f += 3)
    for (let a = 0; a <= PARTS; a++)
      for (let b = 0; a + b <= PARTS; b++) {
        const shares = [a, b, PARTS - a - b].map((part) => part / PARTS);
        const at = [0, 1, 2].map((k) =>
          shares.reduce((sum, share, m) => sum + share * points[index[f + m]!]![k]!, 0),
        ) as Vec3;
        most = Math.max(most, -out(at));
      }
  return most;
}

/** By how much the thread that is most off is not as long as it is. */
function stretch(running: SoftRunning, scene: SoftScene): number {
  const points = running.places();
  const off = threadsOf(scene).map(({ ends: [a, b], length }) =>
    Math.abs(Math.hypot(...points[a]!.map((x, k) => x - points[b]![k]!)) / length - 1),
  );
  return Math.max(...off);
}

const judgedOn = (on: string): Judged[] => [
  { id: 'inside', name: `deepest in a ${on}`, unit: 'm', aim: 1e-5, floor: 1e-6 },
  { id: 'creep', name: `creep on a ${on} in ${WATCHED} s`, unit: 'm', aim: 1e-3, floor: 1e-6 },
  { id: 'stretch', name: `longest thread on a ${on}`, unit: 'share', floor: 1e-5 },
];

/** Metres from the origin: no point of what lies there is as far. */
const AWAY = 1.2;

const isThere = (running: SoftRunning): boolean =>
  running.places().every((at) => Math.hypot(...at) < AWAY);

/** Seconds until it lies, and for which it is looked at. */
const [LIES, WATCHED] = [8, 2];

function drape(on: string, ground: Shape, finest: string, out: (at: Vec3) => number): SoftCase {
  const scene: SoftScene = {
    gravity: G,
    cells: [FINE, FINE],
    points: sheet(FINE, 1, level(0.32)),
    mass: 0.3,
    shear: 10,
    radius: 0.01,
    friction: 0.5,
    damping: 2,
    fixed: [],
    ground,
  };
  return {
    id: `on-${on}`,
    name: `Cloth of 1024 points on a ${on}`,
    scene,
    // Three milliseconds of a step, ten seconds of the scene.
    finest,
    judged: judgedOn(on),
    run(running) {
      goOn(running, LIES);
      const before = running.places();
      let most = deepest(running, scene, out);
      for (let i = 0; i < WATCHED; i++) {
        goOn(running, 1);
        most = Math.max(most, deepest(running, scene, out));
      }
      // What flew away is in nothing.
      if (!isThere(running)) return { inside: NaN, creep: NaN, stretch: NaN };
      const after = running.places();
      const moved = before.map((at, n) => Math.hypot(...at.map((x, k) => x - after[n]![k]!)));
      return { inside: most, creep: Math.max(...moved), stretch: stretch(running, scene) };
    },
  };
}

/** Of a ball, and half of a cube, metres. */
const [ROUND, HALF] = [0.3, 0.2];

export const drapes: readonly SoftCase[] = [
  drape('ball', { type: 'Sphere', radius: ROUND }, 'fine', (at) => Math.hypot(...at) - ROUND),
  drape(
    'box',
    { type: 'Box', size: [2 * HALF, 2 * HALF, 2 * HALF] },
    'precise',
    (at) => Math.max(...at.map(Math.abs)) - HALF,
  ),
];
