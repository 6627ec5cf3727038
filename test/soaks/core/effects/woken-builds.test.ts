import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  below,
  box,
  fact,
  position,
  random,
  sphere,
  world,
  type Body,
} from '../../../core/helpers.js';
import type { JointNode } from '../../../../physics-core/nodes/joints/joint.js';

// Random builds fall asleep, and something of them, or of what they lie on, becomes another: what wakes moves as the same
// build that never slept.

/** Of each way, so many. */
const BUILDS = 15;
const ASLEEP_AFTER = 6;
/** Steps that both are watched for: 0.4 s. */
const WATCHED = 48;
/** Metres: what the contract lets rest cost. */
const REST = 1e-3;

type Random = () => number;

interface Build {
  made: World;
  floor: Body;
  bodies: Body[];
  joints: JointNode[];
}

/** Boxes on each other, each a little aside. */
function stack(made: World, next: Random): Body[] {
  return Array.from({ length: 3 + Math.floor(5 * next()) }, (_, i) =>
    addBody(made, {
      mass: 0.5 + 3 * next(),
      position: [0.1 * next(), 0.25 + 0.5 * i, 0.1 * next()],
      geometry: [box(0.6 + 0.4 * next(), 0.5, 0.6 + 0.4 * next())],
    }),
  );
}

/** Rows of bricks, one fewer in each. */
function pyramid(made: World, next: Random): Body[] {
  return [0, 1, 2, 3].flatMap((row) =>
    Array.from({ length: 4 - row }, (_, i) =>
      addBody(made, {
        mass: 0.5 + next(),
        position: [1.05 * i + 0.525 * row, 0.25 + 0.5 * row, 0],
        geometry: [box(1, 0.5, 0.8)],
      }),
    ),
  );
}

/** A beam on two posts, and what stands on it. */
function table(made: World, next: Random): Body[] {
  const post = (x: number): Body =>
    addBody(made, { mass: 3, position: [x, 0.95, 0], geometry: [box(0.4, 1.9, 0.4)] });
  const load = (x: number): Body =>
    addBody(made, { mass: 0.5 + next(), position: [x, 2.25, 0], geometry: [box(0.3, 0.3, 0.3)] });
  const beam = addBody(made, { mass: 2, position: [0, 2, 0], geometry: [box(3, 0.2, 0.5)] });
  return [beam, post(-1.2), post(1.2), load(-1), load(0), load(1)];
}

/** Balls below each other on ball joints. */
function hanging(made: World, next: Random): Body[] {
  let above = addBody(made, { fixed: true, position: [0, 4, 0], geometry: [box(0.2, 0.2, 0.2)] });
  return [0, 1, 2, 3].map((i) => {
    const ball = addBody(made, {
      mass: 0.5 + next(),
      position: [0, 3.5 - 0.5 * i, 0],
      geometry: [sphere(0.1)],
    });
    made.add('BallJoint', { body1: ball, body2: above, anchorPoint: [0, 3.75 - 0.5 * i, 0] });
    return (above = ball);
  });
}

const KINDS = [stack, pyramid, table, hanging];

async function build(number: number, rest: 'auto' | 'never'): Promise<Build> {
  const made = await world({ gravity: [0, -9.8, 0], rest });
  const next = random(7919 * number + 17);
  next();
  const floor = addBody(made, { fixed: true, position: [0, -0.5, 0], geometry: [box(20, 1, 20)] });
  const bodies = KINDS[number % KINDS.length]!(made, next);
  const joints = [...made.nodes].filter(({ type }) => type.name === 'BallJoint') as JointNode[];
  return { made, floor, bodies, joints };
}

const WAYS: Record<string, (build: Build, body: Body, next: Random) => void> = {
  'the floor is removed': ({ floor }) => floor.remove(),
  'the floor is disabled': ({ floor }) => floor.set('enabled', false),
  'the floor is moved far away': ({ floor }) => floor.set('position', [0, -50, 0]),
  'the floor is lowered a little': ({ floor }) => floor.set('position', [0, -0.7, 0]),
  'the floor is fixed no more': ({ floor }) => floor.set('fixed', false),
  'the floor is thinner': ({ floor }) => floor.set('geometry', [box(20, 0.8, 20)]),
  'nothing collides any more': ({ made }) =>
    void made.add('CollisionCollection', { collidables: '*', enabled: false }),
  'one of them is removed': (_, body) => body.remove(),
  'one of them is disabled': (_, body) => body.set('enabled', false),
  'one of them is teleported': (_, body) => body.teleport([8, 3, 0]),
  'one of them shrinks': (_, body) => body.set('geometry', [box(0.2, 0.3, 0.2)]),
  'one of them is heavier': (_, body) => body.set('mass', 20),
  'one of them is fixed': (_, body) => body.set('fixed', true),
  'one of them is kicked': (_, body) => body.applyImpulse([3, 1, 0]),
  'one of them is pushed': (_, body) => body.set('forces', [[10, 0, 5]]),
  'one of them is given a velocity': (_, body) => body.set('linearVelocity', [2, 0, 0]),
  'one of them weighs nothing': (_, body) => body.set('useGlobalGravity', false),
  'gravity leans': ({ made }) => void made.set('gravity', [6, -9.8, 0]),
  'gravity points up': ({ made }) => void made.set('gravity', [0, 3, 0]),
  'a joint goes, where there is one': ({ joints }, body, next) =>
    joints.length > 0 ? joints[Math.floor(next() * joints.length)]!.remove() : body.wake(),
  'one of them is woken': (_, body) => body.wake(),
};

/** Where all are after each of some steps, with what is done to them before. */
async function runOf(number: number, rest: 'auto' | 'never', way: string): Promise<number[][]> {
  const made = await build(number, rest);
  const { bodies } = made;
  made.made.advance(ASLEEP_AFTER);
  if (rest === 'auto') assert.ok(bodies.every(({ sleeping }) => sleeping));
  const next = random(number + 99);
  next();
  WAYS[way]!(made, bodies[Math.floor(next() * bodies.length)]!, next);
  return Array.from({ length: WATCHED }, () => {
    made.made.step();
    return bodies.flatMap((body) => (body.built ? position(body) : []));
  });
}

for (const way of Object.keys(WAYS))
  fact(`builds that sleep move as if they never had when ${way}`, async () => {
    for (let number = 0; number < BUILDS; number++) {
      const [woken, awake] = [await runOf(number, 'auto', way), await runOf(number, 'never', way)];
      woken.forEach((places, step) =>
        places.forEach((place, i) =>
          below(Math.abs(place - awake[step]![i]!), REST, `m, build ${number}, step ${step}`),
        ),
      );
    }
  });
