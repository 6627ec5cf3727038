// What pages have no words for comes with it.
import '../../../physics-core/index.js';
import type { StabilityCase } from '../case.js';
import {
  addBody,
  addFloor,
  atTheEnd,
  box,
  greatest,
  height,
  most,
  position,
  sphere,
  type Vec3,
} from '../scene.js';

const HANGS = 'what hangs or lies on it is pulled back';

/** Where points of a Rope or a Cloth are. */
const points = (node: { get(field: string): unknown }): Vec3[] => node.get('positions') as Vec3[];

const heavyEnd: StabilityCase = {
  id: 'heavy on a rope',
  says: 'five hundred kilograms swing on a rope of one, and it is no longer for it',
  load: { of: 'masses', ratio: 500 * 40 },
  seconds: 10,
  criterion: { what: 'longer than it is, of its length', unit: '', most: 1e-3 },
  promisedFrom: 'game',
  mayTell: ['mass-ratio'],
  work: HANGS,
  scene(w) {
    const softBody = w.add('Rope', { points: [0, 0, 0, 2, 0, 0], segments: 40, fixedIndex: [0] });
    const body = addBody(w, { mass: 500, position: [2, 0, 0], geometry: [sphere(0.2)] });
    w.add('SoftBodyAttachment', { softBody, index: 40, body });
    return greatest(() => Math.max(0, Math.hypot(...position(body)) / 2 - 1));
  },
};

const clothOnBox: StabilityCase = {
  id: 'cloth on a box',
  says: 'a cloth falls on a box, hangs down over its edges, and stays there',
  load: { of: 'points', ratio: 289 },
  seconds: 10,
  criterion: {
    what: 'how deep a point is in the box or below the ground, m',
    unit: 'm',
    most: 0.02,
  },
  promisedFrom: 'game',
  mayTell: ['soft-too-stiff'],
  work: HANGS,
  scene(w) {
    addFloor(w);
    addBody(w, { fixed: true, position: [0, 0.5, 0], geometry: [box(1)] });
    const geometry = {
      type: 'ElevationGrid',
      xDimension: 17,
      zDimension: 17,
      xSpacing: 0.1,
      zSpacing: 0.1,
      height: Array<number>(289).fill(0),
      translation: [-0.8, 1.2, -0.8],
    };
    const cloth = w.add('Cloth', { geometry, thickness: 0.02, damping: 1 });
    const depth = ([x, y, z]: Vec3): number =>
      Math.max(-y, Math.min(0.5 - Math.abs(x), 1 - y, 0.5 - Math.abs(z)));
    const slid = (): boolean => !points(cloth).some(([, y]) => y > 0.95);
    return atTheEnd(() => (slid() ? Infinity : Math.max(0, most(points(cloth).map(depth)))));
  },
};

const ballOnCloth: StabilityCase = {
  id: 'ball on a cloth',
  says: 'a ball of a hundred kilograms lies in a cloth of one that is held by its corners',
  load: { of: 'masses', ratio: 100 },
  seconds: 5,
  criterion: { what: 'lower than a cloth that does not stretch hangs, m', unit: 'm', most: 0.1 },
  promisedFrom: 'standard',
  mayTell: ['soft-too-stiff', 'mass-ratio'],
  work: HANGS,
  scene(w) {
    const side = 16;
    const corners = [0, side, side * (side + 1), (side + 1) ** 2 - 1];
    const geometry = {
      type: 'ElevationGrid',
      xDimension: side + 1,
      zDimension: side + 1,
      xSpacing: 1 / side,
      zSpacing: 1 / side,
      height: Array<number>((side + 1) ** 2).fill(0),
      translation: [-0.5, 0, -0.5],
    };
    w.add('Cloth', { geometry, thickness: 0.02, fixedIndex: corners, damping: 1 });
    const ball = addBody(w, { mass: 100, position: [0, 0.26, 0], geometry: [sphere(0.25)] });
    // Threads along both sides do not stretch, squares become slanted: to the middle of the lowest it is half of both at most.
    const lowest = -Math.sqrt(1 - 0.5);
    return greatest(() => Math.max(0, lowest - (height(ball) - 0.25)));
  },
};

/** How near points of it come to each other that are so many links apart and more, metres. */
function nearest(at: readonly Vec3[], apart: number): number {
  let least = Infinity;
  for (let i = 0; i < at.length; i++)
    for (let j = i + apart; j < at.length; j++)
      least = Math.min(least, Math.hypot(...at[i]!.map((x, k) => x - at[j]![k]!)));
  return least;
}

const coiled: StabilityCase = {
  id: 'rope in a coil',
  says: 'a rope falls on the ground in a coil of four turns, and lies on itself',
  load: { of: 'points', ratio: 97 },
  seconds: 3,
  criterion: { what: 'how much nearer to itself it is than thick', unit: '', most: 0.15 },
  promisedFrom: 'game',
  work: HANGS,
  scene(w) {
    addFloor(w);
    const radius = 0.015;
    const turn = 24;
    const coil = Array.from({ length: 4 * turn + 1 }, (_, i) => {
      const angle = (2 * Math.PI * i) / turn;
      const height = radius + 0.05 + (2.1 * radius * i) / turn;
      return [0.12 * Math.cos(angle), height, 0.12 * Math.sin(angle)];
    });
    const fields = { mass: 0.5, damping: 0.5, selfCollision: true };
    const rope = w.add('Rope', { points: coil.flat(), radius, ...fields });
    return greatest(() => Math.max(0, 1 - nearest(points(rope), 4) / (2 * radius)));
  },
};

export const soft: readonly StabilityCase[] = [heavyEnd, clothOnBox, ballOnCloth, coiled];
