import fc from 'fast-check';
import { levelNames } from '../../physics-core/dynamics/levels.js';
import { number, scale, turn, vector } from './numbers.js';
import type { Act, NodePlan, Plan } from './plan.js';
import type { Ref } from './values.js';

// A tower that touches, a chain that hangs and a raft that does both, at rest: whatever moves has it of the edits.

/** No body of it is edited: what swings thirty metres of ground strikes as fast as it likes. */
const GROUND: NodePlan[] = [
  {
    type: 'CollidableShape',
    fields: { translation: [0, -3, 0], shape: [{ type: 'Box', size: [30, 1, 30] }] },
  },
  { type: 'CollisionCollection', fields: { collidables: '*' } },
];

/** Top of the ground. */
const FLOOR = -2.5;

const solid = fc.constantFrom<NodePlan['fields']>(
  { type: 'Box', size: [0.5, 0.5, 0.5] },
  { type: 'Sphere', radius: 0.25 },
  { type: 'Cylinder', radius: 0.25, height: 0.5 },
);

const body = (position: number[]): fc.Arbitrary<NodePlan> =>
  fc.record({
    type: fc.constant('RigidBody'),
    fields: fc.record({
      position: fc.constant(position),
      mass: scale(0.2, 10),
      geometry: fc.tuple(solid),
    }),
  });

const row = (count: number, at: (i: number) => number[]): fc.Arbitrary<NodePlan[]> =>
  fc.tuple(...Array.from({ length: count }, (_, i) => body(at(i))));

const bodyAt = (ref: number): Ref => ({ ref, of: ['RigidBody'] });

const BODIES = {
  body1: fc.oneof(fc.constant(null), fc.nat(11).map(bodyAt)),
  body2: fc.nat(11).map(bodyAt),
};
const ANCHOR = { ...BODIES, anchorPoint: vector(2) };

const OF_JOINTS: Record<string, Record<string, fc.Arbitrary<unknown>>> = {
  BallJoint: ANCHOR,
  SingleAxisHingeJoint: {
    ...ANCHOR,
    axis: vector(1),
    minAngle: number(-1, 0),
    maxAngle: number(0, 1),
  },
  DoubleAxisHingeJoint: { ...ANCHOR, axis1: vector(1), axis2: vector(1) },
  SliderJoint: {
    ...BODIES,
    axis: vector(1),
    minSeparation: number(-1, 0),
    maxSeparation: number(0, 1),
  },
  UniversalJoint: { ...ANCHOR, axis1: vector(1), axis2: vector(1) },
  MotorJoint: { ...BODIES, motor1Axis: vector(1) },
};

const JOINTS = Object.keys(OF_JOINTS);

const joint = (
  body1: number | undefined,
  body2: number,
  anchorPoint: number[],
): fc.Arbitrary<NodePlan> =>
  fc.constantFrom(...JOINTS).map((type) => ({
    type,
    fields: {
      ...(body1 !== undefined && { body1: bodyAt(body1) }),
      body2: bodyAt(body2),
      ...(type !== 'SliderJoint' && type !== 'MotorJoint' && { anchorPoint }),
    },
  }));

/** Metres between middles: links of a chain do not touch, those of a raft do. */
const LINK = 0.6;
const PLANK = 0.5;

const structures = fc
  .record({
    tower: fc.integer({ min: 0, max: 4 }),
    links: fc.integer({ min: 0, max: 4 }),
    planks: fc.integer({ min: 0, max: 3 }),
  })
  .chain(({ tower, links, planks }) => {
    const [link, plank] = [tower, tower + links];
    return fc
      .tuple(
        row(tower, (i) => [-2, FLOOR + 0.25 + 0.5 * i, 0]),
        row(links, (i) => [LINK * (i + 0.5), 0, 0]),
        row(planks, (i) => [PLANK * i, FLOOR + 0.25, 2]),
        ...Array.from({ length: links }, (_, i) =>
          joint(i > 0 ? link + i - 1 : undefined, link + i, [LINK * i, 0, 0]),
        ),
        ...Array.from({ length: Math.max(0, planks - 1) }, (_, i) =>
          joint(plank + i, plank + i + 1, [PLANK * (i + 0.5), FLOOR + 0.25, 2]),
        ),
      )
      .map((nodes) => nodes.flat());
  });

// ---- edits -----------------------------------------------------------------------------------------------------------

const pick = fc.nat(11);

const diagonal = fc
  .tuple(scale(0.01, 1), scale(0.01, 1), scale(0.01, 1))
  .map(([x, y, z]) => [x, 0, 0, 0, y, 0, 0, 0, z]);

const OF_BODIES: Record<string, fc.Arbitrary<unknown>> = {
  position: vector(2.5),
  orientation: turn,
  linearVelocity: vector(3),
  angularVelocity: vector(5),
  mass: scale(0.01, 100),
  inertia: diagonal,
  centerOfMass: vector(0.5),
  fixed: fc.boolean(),
  enabled: fc.boolean(),
  geometry: fc.tuple(fc.record({ type: fc.constant('Box'), size: vector(0.7) })),
};

const set = (of: string, fields: Record<string, fc.Arbitrary<unknown>>): fc.Arbitrary<Act> =>
  fc
    .constantFrom(...Object.entries(fields))
    .chain(([field, values]) =>
      values.map((value): Act => ({ act: 'set', of, pick: 0, field, value })),
    );

const picked = (acts: fc.Arbitrary<Act>): fc.Arbitrary<Act> =>
  fc.tuple(acts, pick).map(([act, number]) => ({ ...act, pick: number }) as Act);

const act: fc.Arbitrary<Act> = fc.oneof(
  { weight: 6, arbitrary: picked(set('RigidBody', OF_BODIES)) },
  {
    weight: 3,
    arbitrary: fc.constantFrom(...JOINTS).chain((type) => picked(set(type, OF_JOINTS[type]!))),
  },
  {
    weight: 1,
    arbitrary: fc.record({
      act: fc.constant<'remove'>('remove'),
      of: fc.constantFrom('RigidBody', ...JOINTS),
      pick,
    }),
  },
  {
    weight: 1,
    arbitrary: fc
      .tuple(fc.nat(11), fc.nat(11), vector(2))
      .chain(([one, two, at]) => joint(one, two, at))
      .map((node): Act => ({ act: 'add', node })),
  },
  {
    weight: 3,
    arbitrary: fc.constantFrom<Act>({ act: 'snapshot' }, { act: 'restore' }, { act: 'reset' }),
  },
  {
    weight: 1,
    arbitrary: fc.record({
      act: fc.constant<'world'>('world'),
      field: fc.constant('gravity'),
      value: vector(10),
    }),
  },
);

/** Edits of bodies that hang together and touch, while they move: what they do to the motion is judged. */
export const editsPlan: fc.Arbitrary<Plan> = fc.integer({ min: 10, max: 90 }).chain((steps) =>
  fc.record({
    wild: fc.constant(false),
    level: fc.constantFrom(...levelNames),
    gravity: fc.oneof(fc.constant([0, -9.8, 0]), fc.constant([0, 0, 0])),
    nodes: structures.map((nodes) => [...GROUND, ...nodes]),
    steps: fc.constant(steps),
    edits: fc.array(fc.record({ when: fc.record({ step: fc.nat(steps - 1) }), act }), {
      minLength: 1,
      maxLength: 12,
      size: 'max',
    }),
  }),
);
