import type { World } from '../../../physics-core/inside.js';
import type { StabilityCase } from '../case.js';
import { toldChain } from '../told.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  distance,
  greatest,
  most,
  moved,
  nothingCollides,
  position,
  sphere,
  widest,
  type Body,
  type Joint,
} from '../scene.js';

// Chains and nets: how far their joints gape at the worst moment, as a share of a link.

const GAP = { what: 'widest gap, of a link', unit: '', most: 0.01 };
/** Metres. */
const LINK = 0.5;

/** Rods let go level, each hung on the one before, the first on the world. */
function chain(w: World, masses: number[], link = LINK): Joint[] {
  nothingCollides(w);
  let last: Body | undefined;
  return masses.map((mass, i) => {
    const rod = addBody(w, {
      mass,
      position: [(i + 0.5) * link, 0, 0],
      geometry: [box(0.9 * link, 0.1 * link, 0.1 * link)],
    });
    const ends = { body1: rod, ...(last && { body2: last }) };
    last = rod;
    return addJoint(w, 'BallJoint', { ...ends, anchorPoint: [i * link, 0, 0] });
  });
}

const massesOf = (ratio: number): number[] => [...Array<number>(7).fill(0.1), 0.1 * ratio];

const weighted = (
  id: string,
  ratio: number,
  promisedFrom: StabilityCase['promisedFrom'],
): StabilityCase => ({
  id,
  says: `a chain of seven rods with ${ratio} times their mass at its end keeps its joints`,
  load: { of: 'masses', ratio },
  seconds: 5,
  criterion: GAP,
  promisedFrom,
  lowest: -8 * LINK,
  mayTell: ['mass-ratio'],
  told: () => toldChain(massesOf(ratio), LINK),
  scene(w) {
    const joints = chain(w, massesOf(ratio));
    return greatest(() => widest(joints) / LINK);
  },
});

/** Knots in the level, each joined to its neighbours half-way. */
function net(w: World, size: number, link: number) {
  const middle = (size - 1) / 2;
  const at = (n: number) => [
    (Math.floor(n / size) - middle) * link,
    2,
    ((n % size) - middle) * link,
  ];
  const knots = Array.from({ length: size * size }, (_, n) =>
    addBody(w, { position: at(n), mass: 0.1, geometry: [sphere(0.03)] }),
  );
  const join = (n: number, other: number): Joint =>
    addJoint(w, 'BallJoint', {
      body1: knots[n],
      body2: knots[other],
      anchorPoint: at(n).map((x, axis) => (x + at(other)[axis]!) / 2),
    });
  const joints = knots.flatMap((_, n) => [
    ...(n + size < size * size ? [join(n, n + size)] : []),
    ...((n + 1) % size ? [join(n, n + 1)] : []),
  ]);
  return { knots, joints };
}

/** A net above a fixed ball. */
function netOverBall(w: World) {
  addBody(w, { fixed: true, position: [0, 1, 0], geometry: [sphere(0.8)] });
  return net(w, 20, 0.2);
}

/** Planks between two posts, as many as fill six metres, each on two ropes; some carry boxes ten times as heavy. */
function bridge(w: World, planks: number, boxes: number) {
  const length = 6 / planks;
  const post = (x: number): Body =>
    addBody(w, { fixed: true, position: [x, 3, 0], geometry: [box(1, 0.2, 2)] });
  const joints: Joint[] = [];
  const tie = (body1: Body, body2: Body, x: number): void => {
    for (const z of [-0.9, 0.9])
      joints.push(addJoint(w, 'BallJoint', { body1, body2, anchorPoint: [x, 3, z] }));
  };
  const bodies: Body[] = [];
  let last = post(-3.5);
  for (let i = 0; i < planks; i++) {
    const x = -3 + i * length;
    const plank = addBody(w, {
      mass: 2,
      position: [x + length / 2, 3, 0],
      geometry: [box(0.9 * length, 0.1, 2)],
    });
    tie(plank, last, x);
    bodies.push(plank);
    last = plank;
  }
  tie(last, post(3.5), 3);
  for (let i = 0; i < boxes; i++)
    addBody(w, {
      mass: 20,
      position: [-2.4 + (4.8 * i) / Math.max(1, boxes - 1), 3.31, 0],
      geometry: [box(0.5)],
    });
  return { bodies, joints, length };
}

export const chains: StabilityCase[] = [
  weighted('S1', 20, 'game'),
  weighted('S2 1:1000', 1000, 'game'),
  weighted('S2 1:10000', 10_000, 'game'),
  {
    id: 'S3',
    says: 'a chain of a hundred links let go level keeps its length',
    load: { of: 'links', ratio: 100 },
    seconds: 5,
    criterion: { what: 'all gaps together, of its length', unit: '', most: 0.01 },
    promisedFrom: 'game',
    lowest: -10,
    scene(w) {
      const joints = chain(w, Array<number>(100).fill(0.1), 0.1);
      return greatest(() => joints.reduce((sum, { gap }) => sum + gap, 0) / 10);
    },
  },
  {
    id: 'net',
    says: 'a net of 20 × 20 knots falls over a ball and does not gape',
    load: { of: 'joints', ratio: 760 },
    seconds: 1.2,
    finest: 'fine',
    slow: true,
    criterion: GAP,
    promisedFrom: 'game',
    mayTell: ['sunk'],
    scene(w) {
      const { joints } = netOverBall(w);
      return greatest(() => widest(joints) / 0.2);
    },
  },
  {
    id: 'net on a ball',
    says: 'a net of 20 × 20 knots that falls over a ball does not sink into it',
    load: { of: 'joints', ratio: 760 },
    seconds: 1.2,
    finest: 'fine',
    criterion: { what: 'deepest knot', unit: 'm', most: 0.03 },
    // Its last knots meet the ball at 12 m/s: 10 cm in a step of `standard`. At `game` they come in so deep that it is lost.
    promisedFrom: 'fine',
    mayTell: ['sunk'],
    scene(w) {
      const { knots } = netOverBall(w);
      return greatest(() => most(knots.map((knot) => 0.83 - distance(position(knot), [0, 1, 0]))));
    },
  },
  {
    id: 'taut bridge',
    says: 'a bridge of forty planks on two ropes, as long as the way between its posts, does not gape',
    load: { of: 'joints', ratio: 82 },
    seconds: 4,
    criterion: GAP,
    promisedFrom: 'game',
    scene(w) {
      nothingCollides(w);
      const { joints, length } = bridge(w, 40, 0);
      return greatest(() => widest(joints) / length);
    },
  },
  {
    id: 'taut bridge stands',
    says: 'the planks of such a bridge stay where they are',
    load: { of: 'joints', ratio: 82 },
    seconds: 4,
    criterion: { what: 'farthest from its place', unit: 'm', most: 0.03 },
    promisedFrom: 'game',
    scene(w) {
      nothingCollides(w);
      return greatest(moved(bridge(w, 40, 0).bodies));
    },
  },
  {
    id: 'loaded bridge',
    says: 'a taut bridge of forty planks carries six boxes, each ten times as heavy as a plank',
    load: { of: 'masses', ratio: 10 },
    seconds: 3,
    criterion: GAP,
    promisedFrom: 'game',
    scene(w) {
      const { joints, length } = bridge(w, 40, 6);
      return greatest(() => widest(joints) / length);
    },
  },
  {
    id: 'edge',
    says: 'a chain that slides over the edge of a table does not gape',
    load: { of: 'links', ratio: 20 },
    seconds: 3,
    criterion: GAP,
    promisedFrom: 'game',
    lowest: -6,
    scene(w) {
      w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0.2, 0.2] });
      addFloor(w, 0, { position: [-5, -0.5, 0], geometry: [box(10, 1, 4)] });
      let last: Body | undefined;
      const joints: Joint[] = [];
      for (let i = 0; i < 20; i++) {
        const link = addBody(w, {
          mass: 0.1,
          position: [-2.05 + 0.2 * i, 0.025, 0],
          geometry: [box(0.18, 0.05, 0.1)],
        });
        const anchorPoint = [-2.15 + 0.2 * i, 0.025, 0];
        if (last) joints.push(addJoint(w, 'BallJoint', { body1: link, body2: last, anchorPoint }));
        last = link;
      }
      return greatest(() => widest(joints) / 0.2);
    },
  },
  {
    id: 'rope ladder',
    says: 'a rope ladder of twelve rungs swings and does not gape',
    load: { of: 'loops', ratio: 12 },
    seconds: 4,
    criterion: GAP,
    promisedFrom: 'game',
    lowest: -6,
    scene(w) {
      nothingCollides(w);
      const joints: Joint[] = [];
      let above: Body[] = [];
      for (let i = 0; i < 12; i++) {
        const x = 0.4 * (i + 1);
        const rung = addBody(w, { position: [x, 0, 0], geometry: [box(0.04, 0.04, 0.5)] });
        above = [-0.2, 0.2].map((z, side) => {
          const rope = addBody(w, {
            mass: 0.1,
            position: [x - 0.2, 0, z],
            geometry: [box(0.38, 0.03, 0.03)],
          });
          const up = above[side];
          const ends = { body1: rope, ...(up && { body2: up }) };
          joints.push(
            addJoint(w, 'BallJoint', { ...ends, anchorPoint: [x - 0.4, 0, z] }),
            addJoint(w, 'BallJoint', { body1: rung, body2: rope, anchorPoint: [x, 0, z] }),
          );
          return rope;
        });
      }
      return greatest(() => widest(joints) / 0.4);
    },
  },
];
