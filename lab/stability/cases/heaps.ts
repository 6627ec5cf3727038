import { cos, sin } from '../../../physics-core/base/exact/index.js';
import type { World } from '../../../physics-core/inside.js';
import { LIMBS, massOfLimb } from '../../ragdoll.js';
import { addWalls } from '../../walls.js';
import type { StabilityCase } from '../case.js';
import { dominoes } from './dominoes.js';
import {
  addBody,
  addFloor,
  addJoint,
  atTheEnd,
  box,
  distance,
  fastest,
  greatest,
  height,
  position,
  random,
  sphere,
  widest,
  type Body,
  type Joint,
  type Vec3,
} from '../scene.js';

// Heaps: much that touches, and what comes out of it.

function ragdoll(w: World, [x, y, z]: Vec3): { limbs: Body[]; joints: Joint[] } {
  const there = (at: Vec3) => [x + at[0], y + at[1], z + at[2]];
  const limbs = LIMBS.map(({ size, at }) =>
    addBody(w, { mass: massOfLimb(size), position: there(at), geometry: [box(...size)] }),
  );
  const joints = LIMBS.flatMap(({ on, joint }, i) =>
    on === undefined || !joint
      ? []
      : [
          addJoint(w, 'BallJoint', {
            body1: limbs[i],
            body2: limbs[on],
            anchorPoint: there(joint),
          }),
        ],
  );
  return { limbs, joints };
}

/** A floor, and four walls about a square of 4 m. */
function pit(w: World): void {
  addFloor(w);
  addWalls(w, 2, 6);
}

/** Bodies in layers over the pit, turned by chance. */
function poured(w: World, count: number, geometryOf: (i: number) => object): Body[] {
  const next = random(7);
  return Array.from({ length: count }, (_, i) =>
    addBody(w, {
      position: [
        ((i % 5) - 2) * 0.6 + 0.05 * next(),
        0.6 + 0.6 * Math.floor(i / 25),
        ((Math.floor(i / 5) % 5) - 2) * 0.6 + 0.05 * next(),
      ],
      orientation: [next() - 0.5, next() - 0.5, next() - 0.5, 3 * next()],
      geometry: [geometryOf(i)],
    }),
  );
}

/** Metres between the two that are nearest to each other. */
const nearest = (places: readonly Vec3[]): number =>
  Math.min(...places.flatMap((a, i) => places.slice(i + 1).map((b) => distance(a, b))));

const SHAPES = [
  sphere(0.2),
  box(0.35, 0.3, 0.4),
  { type: 'Cylinder', radius: 0.2, height: 0.4 },
  { type: 'Cone', bottomRadius: 0.22, height: 0.4 },
];

/**
 * What is round rolls on, since nothing stops it but what it meets: asked is, m/s, what a ball has that rolled down 6 mm. The
 * fastest ball has 0.54 after 2 s, 0.13 after 10, 0.06 after 30.
 */
const ROLLS = 0.3;

/** `most`: m/s after 10 s. */
const rests = (
  id: string,
  says: string,
  count: number,
  most: number,
  geometryOf: (i: number) => object,
): StabilityCase => ({
  id,
  says,
  load: { of: 'bodies', ratio: count },
  seconds: 10,
  finest: 'precise',
  criterion: { what: 'greatest speed in the end', unit: 'm/s', most },
  promisedFrom: 'game',
  scene(w) {
    pit(w);
    const bodies = poured(w, count, geometryOf);
    return atTheEnd(() => (bodies.some((body) => height(body) < 0) ? NaN : fastest(bodies)));
  },
});

export const heaps: StabilityCase[] = [
  {
    id: 'S12',
    says: 'twenty boxes at one place part slower than 10 m/s',
    load: { of: 'bodies', ratio: 20 },
    seconds: 2,
    criterion: { what: 'greatest speed', unit: 'm/s', most: 10 },
    promisedFrom: 'game',
    world: { gravity: [0, 0, 0] },
    tells: ['initial-overlap'],
    work: 'they begin in each other',
    scene(w) {
      const boxes = Array.from({ length: 20 }, () => addBody(w, { geometry: [box(1)] }));
      const { after, measured } = greatest(() => fastest(boxes));
      // Overlaps are taken out by place, up to 1.8 m in the first step, and give no velocity (maxCorrectionSpeed).
      return { after, measured: () => (nearest(boxes.map(position)) > 0.95 ? measured() : NaN) };
    },
  },
  {
    ...rests(
      'heap of boxes',
      'a hundred boxes poured into a pit come to rest in it',
      100,
      1e-3,
      () => box(0.35, 0.3, 0.4),
    ),
    // One box still rocks there, at 7 mm/s.
    refutedAt: ['fine'],
  },
  rests(
    'heap of balls',
    'forty balls poured into a pit settle in it, and roll about slowly',
    40,
    ROLLS,
    () => sphere(0.2),
  ),
  rests(
    'mixed heap',
    'forty balls, boxes, cylinders and cones poured into a pit settle in it, and roll about slowly',
    40,
    ROLLS,
    (i) => SHAPES[i % 4]!,
  ),
  {
    id: 'ragdolls',
    says: 'twenty ragdolls fall in a heap and hold together',
    load: { of: 'bodies', ratio: 200 },
    seconds: 4,
    finest: 'precise',
    criterion: { what: 'widest gap', unit: 'm', most: 0.01 },
    promisedFrom: 'game',
    // Where contacts are taken for deep that hardly touch, one lands there so that it is torn by 8.5 m in a step.
    alsoTested: ['fine'],
    mayTell: ['mass-ratio'],
    scene(w) {
      pit(w);
      const dolls = Array.from({ length: 20 }, (_, i) =>
        ragdoll(w, [((i % 2) - 0.5) * 1.6, 1.2 + 1.5 * Math.floor(i / 4), ((i >> 1) % 2) - 0.5]),
      );
      const joints = dolls.flatMap((doll) => doll.joints);
      return greatest(() => widest(joints));
    },
  },
  {
    id: 'funnel',
    says: 'a conveyor carries thirty boxes into a funnel, which all of them leave below',
    load: { of: 'bodies', ratio: 30 },
    seconds: 14,
    finest: 'precise',
    criterion: { what: 'left behind', unit: 'boxes', most: 0 },
    promisedFrom: 'game',
    work: 'the belt drives them',
    scene(w) {
      const belt = w.add('CollidableShape', { shape: [box(12, 0.2, 1)] });
      addBody(w, { fixed: true, position: [-6, 3.9, 0], geometry: [belt] });
      addFloor(w);
      // Four plates that lean inwards, over a hole of 1.2 m.
      for (let side = 0; side < 4; side++) {
        const turn = (side * Math.PI) / 2;
        const lean = 0.9;
        const out = 0.6 + sin(lean);
        addBody(w, {
          fixed: true,
          position: [1.4 + out * cos(turn), 1.6 + cos(lean), -out * sin(turn)],
          geometry: [
            {
              type: 'CollidableOffset',
              rotation: [0, 1, 0, turn],
              collidable: {
                type: 'CollidableOffset',
                rotation: [0, 0, 1, -lean],
                collidable: box(0.1, 2, 4),
              },
            },
          ],
        });
      }
      const boxes = Array.from({ length: 30 }, (_, i) => {
        const shape = w.add('CollidableShape', { shape: [box(0.25)] });
        return {
          shape,
          body: addBody(w, { position: [-0.4 - 0.36 * i, 4.126, 0], geometry: [shape] }),
        };
      });
      w.add('CollisionCollection', {
        collidables: [belt, ...boxes.map(({ shape }) => shape)],
        appliedParameters: ['BOUNCE', 'FRICTION_COEFFICIENT-2', 'SPEED-1'],
        frictionCoefficients: [0.5, 0.5],
        surfaceSpeed: [1, 0],
      });
      return atTheEnd(() => boxes.filter(({ body }) => height(body) > 1.2).length);
    },
  },
  dominoes,
];
