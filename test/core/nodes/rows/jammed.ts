import {
  addBody,
  addJoint,
  below,
  box,
  claim,
  velocity,
  world,
  WEIGHTLESS,
  type Vec3,
} from '../../helpers.js';
import type { Row } from './row.js';

// Guards of what is jammed. The scenes were found by chance, among thousands of blocks put inside each other.

type Geometry = ReturnType<typeof box> | Record<string, unknown>;

const block = (position: Vec3, orientation: number[], shape: Geometry) => ({
  position,
  orientation,
  geometry: [shape],
});

const moved = (
  position: Vec3,
  mass: number,
  linearVelocity: Vec3,
  angularVelocity: Vec3,
  shape: Geometry,
) => ({ position, mass, linearVelocity, angularVelocity, geometry: [shape] });

interface Jam {
  bounce: number;
  blocks: ReturnType<typeof block>[];
  bodies: ReturnType<typeof moved>[];
  /** Of hinges from each body to the next. */
  anchors?: Vec3[];
  /** m/s */
  most: number;
}

/** Bodies begin inside fixed ones, and are pushed out without being thrown. */
async function jammed({ bounce, blocks, bodies, anchors = [], most }: Jam): Promise<void> {
  const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
  claim(w, 'initial-overlap');
  w.add('CollisionCollection', { collidables: '*', bounce });
  for (const each of blocks) addBody(w, { fixed: true, ...each });
  const jam = bodies.map((body) => addBody(w, body));
  anchors.forEach((anchorPoint, i) =>
    addJoint(w, 'SingleAxisHingeJoint', { body1: jam[i], body2: jam[i + 1], anchorPoint }),
  );
  let fastest = 0;
  for (let i = 0; i < 40; i++) {
    w.step();
    for (const body of jam) fastest = Math.max(fastest, Math.hypot(...velocity(body)));
  }
  below(fastest, most, 'm/s');
}

export const jamRows: Row[] = [
  {
    guard: 'energyOfBounce',
    fact: 'a stick that bounces and is jammed between two blocks is not shot out',
    run: () =>
      jammed({
        bounce: 0.7,
        blocks: [
          block([-0.8, -0.5, -0.7], [-0.6, 0.6, 1, -0.6], box(2.1, 1.9, 1.7)),
          block([-0.2, 1, 0.2], [0.3, -0.9, 1, -0.8], box(2.8, 0.8, 1.8)),
        ],
        bodies: [moved([0, 0, 0], 1, [2.4, 0.5, -0.3], [2.2, 0.9, 0.5], box(0.2, 0.2, 1.8))],
        // Measured 2.4 m/s; else 40.
        most: 4,
      }),
  },
  {
    guard: 'explained',
    fact: 'a solution of contacts that runs away is not taken',
    run: () =>
      jammed({
        bounce: 0.9,
        blocks: [
          block([-0.7, 0, -0.1], [0.4, 0.7, 1, -0.8], box(0.9, 0.4, 2.8)),
          block([-0.9, 0.9, -0.3], [-0.4, -0.6, 1, 0.2], box(1.6, 1.7, 3)),
        ],
        bodies: [moved([0, 0, 0], 1, [-1.6, -1.8, 1.3], [-0.5, 1.4, -2.4], box(0.8, 0.5, 1.3))],
        // Measured 1.6 m/s; else 95.
        most: 4,
      }),
  },
  {
    guard: 'energyOfJoints',
    fact: 'a chain that is jammed between two blocks is not shot out',
    run: () =>
      jammed({
        bounce: 0.9,
        blocks: [
          block([-0.5, -0.8, 0.2], [0.5, 0.2, 1, 0.6], box(0.8, 0.5, 1)),
          block([0.9, 0.7, -0.9], [-0.5, -0.3, 1, 0.8], box(1.6, 0.3, 1.3)),
        ],
        bodies: [
          moved([-0.6, 0, 0], 1.3, [-1.4, 0, 0.7], [-1.2, -2.9, -2.8], box(1.4, 0.3, 1.7)),
          moved([0, 0, 0], 1.1, [-1, -1, 1.3], [1.3, -2.2, -1.4], {
            type: 'Cone',
            bottomRadius: 0.4,
            height: 0.5,
          }),
          moved([0.6, 0, 0], 1, [1.9, 0.1, -1.8], [-1.2, -1, 0.2], {
            type: 'Cylinder',
            radius: 0.6,
            height: 1.1,
          }),
        ],
        anchors: [
          [-0.3, 0, 0],
          [0.3, 0, 0],
        ],
        // Measured 1.2 m/s; else 46.
        most: 4,
      }),
  },
];
