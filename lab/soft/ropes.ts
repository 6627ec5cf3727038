import { chainMasses, chainSag, slowestSwing, swungChain } from '../../references/hanging-chain.js';
import type { Vec3 } from '../case.js';
import { G, type SoftCase } from './case.js';
import { goOn, swingOf } from './watch.js';

/** Links and metres of the ropes here. */
const [LINKS, LENGTH] = [40, 2];

/** A straight rope from the origin, so many radians off the vertical. */
const straight = (links: number, length: number, angle: number): Vec3[] =>
  Array.from({ length: links + 1 }, (_, i): Vec3 => {
    const way = (length * i) / links;
    return [way * Math.sin(angle), -way * Math.cos(angle), 0];
  });

const distance = (a: Vec3, b: Vec3): number => Math.hypot(...a.map((x, k) => x - b[k]!));

// ---- between two ends --------------------------------------------------------------------------------------------------

/** Metres from end to end, and how deep it is laid. */
const [SPAN, LAID] = [1.2, 0.8];

export const catenary: SoftCase = {
  id: 'catenary',
  name: 'Rope between two points',
  scene: {
    gravity: G,
    mass: 1,
    damping: 2,
    fixed: [0, LINKS],
    points: Array.from({ length: LINKS + 1 }, (_, i): Vec3 => [
      (SPAN * i) / LINKS,
      -LAID * (1 - Math.abs((2 * i) / LINKS - 1)),
      0,
    ]),
  },
  judged: [{ id: 'sag', name: 'sag of a catenary', unit: 'm', aim: 5e-5, floor: 1e-7 }],
  run(running) {
    goOn(running, 16);
    return { sag: Math.abs(running.places()[LINKS / 2]![1] + chainSag(LINKS, LENGTH, SPAN)) };
  },
};

// ---- what swings -------------------------------------------------------------------------------------------------------

/** Metres to either side: its swing is that of small ones. */
const WIDE = 0.01;

export const swing: SoftCase = {
  id: 'swing',
  name: 'Hanging rope, lowest mode',
  scene: { gravity: G, mass: 1, fixed: [0], points: swungChain(LINKS, LENGTH, WIDE) },
  judged: [
    { id: 'period', name: 'period of a hanging rope', unit: 'share', aim: 2e-4, floor: 1e-6 },
    {
      id: 'amplitude',
      name: 'amplitude of a hanging rope after 10 s',
      unit: 'share',
      aim: 1e-2,
      floor: 1e-4,
    },
  ],
  run(running) {
    const { period, most } = swingOf(running, 10, () => running.places()[LINKS]![0]);
    const right = (2 * Math.PI) / Math.sqrt(slowestSwing(LINKS, LENGTH, G).square);
    return { period: Math.abs(period / right - 1), amplitude: Math.abs(most / WIDE - 1) };
  },
};

const ANGLE = Math.PI / 6;

/** As far as this share of where it began its end comes on the other side. */
const REACHES = 0.9;

/** J, by the places of the last three steps. */
function energyOf([before, now, after]: readonly Vec3[][], dt: number): number {
  const masses = chainMasses(LINKS, 1);
  return now!.reduce((sum, [, y], i) => {
    const speed = distance(before![i]!, after![i]!) / (2 * dt);
    return sum + masses[i]! * (speed ** 2 / 2 + G * y);
  }, 0);
}

export const energy: SoftCase = {
  id: 'energy',
  name: 'Rope that swings from 30°',
  scene: { gravity: G, mass: 1, fixed: [0], points: straight(LINKS, LENGTH, ANGLE) },
  judged: [
    { id: 'energy', name: 'energy of a swinging rope', unit: 'share', aim: 5e-3, floor: 1e-5 },
  ],
  run(running) {
    let last = [running.places()];
    let [most, widest] = [0, 0];
    goOn(running, 10, () => {
      last = [...last.slice(-2), running.places()];
      widest = Math.max(widest, -last.at(-1)![LINKS]![0]);
      if (last.length < 3) return;
      const now = energyOf(last, running.timeStep);
      most = Math.max(most, Math.abs(now + (G * LENGTH * Math.cos(ANGLE)) / 2));
    });
    // What does not swing keeps its energy, too.
    if (widest < REACHES * LENGTH * Math.sin(ANGLE)) return { energy: NaN };
    // Of what it has at its lowest.
    return { energy: most / ((G * LENGTH * (1 - Math.cos(ANGLE))) / 2) };
  },
};

// ---- what bears --------------------------------------------------------------------------------------------------------

/** 20,000 times a link of a rope of 1 kg. */
const HEAVY = 500;

export const heavyEnd: SoftCase = {
  id: 'heavy-end',
  name: '500 kg on a rope of 1 kg',
  scene: {
    gravity: G,
    mass: 1,
    fixed: [0],
    points: straight(LINKS, LENGTH, 0),
    load: { point: LINKS, mass: HEAVY },
  },
  judged: [{ id: 'stretch', name: '500 kg on a rope of 1 kg', unit: 'm', aim: 1e-5, floor: 1e-7 }],
  run(running) {
    goOn(running, 3);
    return { stretch: distance(running.places()[LINKS]!, [0, -LENGTH, 0]) };
  },
};

const [MANY, LONG] = [1000, 10];

export const longRope: SoftCase = {
  id: 'long-rope',
  name: 'Rope of 1000 links that swings',
  scene: { gravity: G, mass: 1, fixed: [0], points: straight(MANY, LONG, ANGLE) },
  judged: [
    {
      id: 'length',
      name: 'length of 1000 links that swing',
      unit: 'share',
      aim: 1e-3,
      floor: 1e-6,
    },
  ],
  run(running) {
    let most = 0;
    goOn(running, 1, () => {
      const at = running.places();
      const length = at.slice(1).reduce((sum, place, i) => sum + distance(place, at[i]!), 0);
      most = Math.max(most, Math.abs(length / LONG - 1));
    });
    return { length: most };
  },
};
