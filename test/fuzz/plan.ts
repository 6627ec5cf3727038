import fc from 'fast-check';
import { levelNames } from '../../physics-core/dynamics/levels.js';
import { allTypes } from '../../physics-core/all-types.js';
import { nodeTypes } from '../../physics-core/inside.js';
import type { Field } from '../../physics-core/nodes/node/table.js';
import { geometry } from './geometry.js';
import { nastyNumber, scale, turn, vector } from './numbers.js';
import { valueOf } from './values.js';

// What happens in one run, as plain data, so that fast-check can shrink it and print what is left.

type Fields = Record<string, unknown>;

export interface NodePlan {
  type: string;
  fields: Fields;
}

/** Edits pick nodes by number: of those of a type that are there when the edit is made. */
export type Act =
  | { act: 'set' | 'unset'; of: string; pick: number; field: string; value: unknown }
  | { act: 'add'; node: NodePlan }
  | { act: 'remove'; of: string; pick: number }
  | { act: 'world'; field: string; value: unknown }
  | {
      act: 'applyForce' | 'applyTorque' | 'applyImpulse';
      pick: number;
      value: unknown;
      at: unknown;
    }
  | { act: 'teleport'; pick: number; position: unknown; orientation: unknown; velocities: Fields }
  | { act: 'drag'; pick: number; value: unknown }
  | { act: 'wake' | 'sleep'; pick: number }
  | { act: 'snapshot' | 'restore' | 'reset' }
  | { act: 'step' | 'raycast'; value: unknown };

/** After so many steps, or each of the first times that a node hears an event. */
export type When = { step: number } | Heard;

export interface Heard {
  event: string;
  of: string;
  pick: number;
  times: number;
}

export interface Plan {
  /** With values that no author can mean, or with what is soft: energy is not judged. */
  wild: boolean;
  level: string;
  gravity: unknown;
  nodes: NodePlan[];
  steps: number;
  edits: { when: When; act: Act }[];
}

/** Fields whose work nobody can reckon: belts, springs, softness and what flies about. */
const UNRECKONED =
  /^(flow|suspension|surfaceSpeed|set_contacts|slip|softness|constantForceMix|stop\dConstant|pushes)/;

/** Of worlds, not of bodies: edited by their own acts. */
const ELSEWHERE = ['metadata', 'accuracy', 'heapLimit', 'thread', 'timeBudget', 'bodies', 'joints'];

function fieldsOf(type: string, wild: boolean): [string, Field][] {
  return Object.entries(allTypes[type]!.fields).filter(
    ([name, field]) =>
      !ELSEWHERE.includes(name) &&
      (wild || (field.access !== 'outputOnly' && !UNRECKONED.test(name))),
  );
}

const someFields = (type: string, wild: boolean, most: number): fc.Arbitrary<Fields> =>
  fc
    .array(
      fc.oneof(
        ...fieldsOf(type, wild).map(([name, field]) =>
          fc.tuple(fc.constant(name), valueOf(field, wild)),
        ),
      ),
      { maxLength: most },
    )
    .map((entries) => Object.fromEntries(entries) as Fields);

const body = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .tuple(
      fc.record({
        position: vector(3),
        mass: scale(0.05, 50),
        geometry: fc.array(geometry(wild), { minLength: 1, maxLength: 2 }),
        linearVelocity: vector(5),
        angularVelocity: vector(5),
        fixed: fc.option(fc.constant(true), { freq: 4, nil: false }),
      }),
      fc.option(someFields('RigidBody', wild, 4), { freq: 1, nil: {} }),
    )
    .map(([base, more]) => ({ type: 'RigidBody', fields: { ...base, ...more } }));

const JOINTS = Object.keys(nodeTypes).filter((type) => type.endsWith('Joint'));

const bodyRef = fc.record({ ref: fc.nat(9), of: fc.constant(['RigidBody']) });

const joint = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .constantFrom(...JOINTS)
    .chain((type) =>
      fc
        .tuple(
          fc.record({ body1: bodyRef, body2: fc.option(bodyRef, { freq: 4, nil: null }) }),
          someFields(type, wild, 5),
        )
        .map(([bodies, more]) => ({ type, fields: { ...bodies, ...more } })),
    );

const OTHERS = [
  ...['CollidableShape', 'CollidableOffset', 'CollisionCollection', 'CollisionSpace'],
  ...['CollisionSensor', 'Contact', 'RigidBodyCollection'],
];

const other = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .constantFrom(...OTHERS)
    .chain((type) => someFields(type, wild, 5).map((fields) => ({ type, fields })));

const node = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc.oneof(
    { weight: 5, arbitrary: body(wild) },
    { weight: 3, arbitrary: joint(wild) },
    { weight: 3, arbitrary: other(wild) },
  );

// ---- particles ------------------------------------------------------------------------------------------------------

const { emitter, physics } = allTypes.ParticleSystem!.fields;
const EMITTERS = emitter!.nodes!;

/** An emitter or a model as plain data. */
const part = (types: readonly string[], wild: boolean): fc.Arbitrary<Fields> =>
  fc
    .constantFrom(...types)
    .chain((type) => someFields(type, wild, 4).map((fields) => ({ ...fields, type })));

const particles = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .tuple(
      fc.record({
        emitter: part(EMITTERS, wild),
        physics: fc.array(part(physics!.nodes!, wild), { maxLength: 2 }),
        collides: fc.boolean(),
        // What winds and particles give to bodies nobody reckons.
        pushes: wild ? fc.boolean() : fc.constant(false),
        maxParticles: fc.integer({ min: 0, max: 60 }),
      }),
      fc.option(someFields('ParticleSystem', wild, 4), { freq: 1, nil: {} }),
    )
    .map(([base, more]) => ({ type: 'ParticleSystem', fields: { ...base, ...more } }));

/** Edits of them, and of what stands in them. */
const particleEdit = (steps: number, wild: boolean) =>
  fc.record({
    when: fc.record({ step: fc.nat(steps) }),
    act: setOf(fc.constantFrom('ParticleSystem', ...EMITTERS, ...physics!.nodes!), wild),
  });

// ---- water ----------------------------------------------------------------------------------------------------------

const water = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .tuple(
      fc.record({
        position: vector(4),
        size: fc.tuple(scale(0.5, 40), scale(0.5, 20), scale(0.5, 40)),
        density: scale(10, 20_000),
      }),
      fc.option(someFields('WaterVolume', wild, 4), { freq: 1, nil: {} }),
    )
    .map(([base, more]) => ({ type: 'WaterVolume', fields: { ...base, ...more } }));

const waterEdit = (steps: number, wild: boolean) =>
  fc.record({
    when: fc.record({ step: fc.nat(steps) }),
    act: setOf(fc.constant('WaterVolume'), wild),
  });

// ---- ropes, cloths, soft bodies -------------------------------------------------------------------------------------

const rope = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .tuple(
      fc.record({
        points: fc.array(vector(3), { minLength: 2, maxLength: 6 }),
        mass: scale(0.05, 20),
        radius: fc.constantFrom(0, 0.02, 0.1),
        fixedIndex: fc.constantFrom([], [0], [1]),
      }),
      fc.option(someFields('Rope', wild, 4), { freq: 1, nil: {} }),
    )
    .map(([base, more]) => ({ type: 'Rope', fields: { ...base, ...more } }));

/** Up to so many cells along each side. */
const CELLS = 8;

const cells = fc.integer({ min: 1, max: CELLS });

const cloth = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .tuple(
      fc.record({
        size: fc.tuple(scale(0.2, 3), scale(0.2, 3)),
        subdivision: fc.tuple(cells, cells),
        mass: scale(0.05, 20),
        thickness: fc.constantFrom(0, 0.02, 0.1),
        fixedIndex: fc.constantFrom([], [0], [0, 1]),
      }),
      fc.option(someFields('Cloth', wild, 4), { freq: 1, nil: {} }),
    )
    .map(([base, more]) => ({ type: 'Cloth', fields: { ...base, ...more } }));

const softBody = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .tuple(
      fc.record({
        geometry: geometry(wild, ['Box', 'Sphere', 'IndexedFaceSet']),
        mass: scale(0.05, 20),
        youngsModulus: scale(100, 1e6),
        pressure: fc.constantFrom(0, 0, 100, 1e4),
      }),
      fc.option(someFields('SoftBody', wild, 4), { freq: 1, nil: {} }),
    )
    .map(([base, more]) => ({ type: 'SoftBody', fields: { ...base, ...more } }));

const SOFT = ['Rope', 'Cloth', 'SoftBody'];

const attachment = (wild: boolean): fc.Arbitrary<NodePlan> =>
  fc
    .tuple(
      fc.record({
        softBody: fc.record({ ref: fc.nat(9), of: fc.constant(SOFT) }),
        index: fc.nat(8),
        body: fc.option(bodyRef, { freq: 4, nil: null }),
        position: vector(1),
      }),
      fc.option(someFields('SoftBodyAttachment', wild, 2), { freq: 1, nil: {} }),
    )
    .map(([base, more]) => ({ type: 'SoftBodyAttachment', fields: { ...base, ...more } }));

/** Soft things, and what ties them to bodies. */
const softs = (wild: boolean): fc.Arbitrary<NodePlan[]> =>
  fc
    .tuple(
      fc.array(fc.oneof(rope(wild), cloth(wild), softBody(wild)), { maxLength: 3 }),
      fc.array(attachment(wild), { maxLength: 3 }),
    )
    .map(([all, ties]) => (all.length > 0 ? [...all, ...ties] : []));

/** Edits of them; a size that is edited keeps its few cells. */
const softEdit = (steps: number, wild: boolean) =>
  fc.record({
    when: fc.record({ step: fc.nat(steps) }),
    act: fc.oneof(
      { weight: 5, arbitrary: setOf(fc.constantFrom(...SOFT, 'SoftBodyAttachment'), wild) },
      {
        weight: 1,
        arbitrary: fc.record({
          act: word('remove'),
          of: fc.constantFrom(...SOFT, 'SoftBodyAttachment'),
          pick,
        }),
      },
      {
        weight: 1,
        arbitrary: fc
          .oneof(cloth(wild), rope(wild), attachment(wild))
          .map((node): Act => ({ act: 'add', node })),
      },
    ),
  });

// ---- edits -----------------------------------------------------------------------------------------------------------

const EDITED = Object.keys(nodeTypes);
const pick = fc.nat(9);

const set = (wild: boolean): fc.Arbitrary<Act> =>
  setOf(
    fc.oneof(
      { weight: 2, arbitrary: fc.constant('RigidBody') },
      { weight: 2, arbitrary: fc.constantFrom(...EDITED) },
    ),
    wild,
  );

const setOf = (types: fc.Arbitrary<string>, wild: boolean): fc.Arbitrary<Act> =>
  types.chain((of) =>
    fc.constantFrom(...fieldsOf(of, wild)).chain(([field, table]) =>
      fc.record({
        act: fc.constantFrom<('set' | 'unset')[]>('set', 'set', 'set', 'unset'),
        of: fc.constant(of),
        pick,
        field: fc.constant(field),
        value: valueOf(table, wild),
      }),
    ),
  );

/** A vector, and in wild runs what is none. */
const arrow = (most: number, wild: boolean): fc.Arbitrary<unknown> =>
  wild
    ? fc.oneof(vector(most), fc.array(nastyNumber, { maxLength: 4 }), fc.constant(undefined))
    : vector(most);

const word = <T extends Act['act']>(...acts: T[]): fc.Arbitrary<T> => fc.constantFrom(...acts);

const act = (wild: boolean): fc.Arbitrary<Act> =>
  fc.oneof(
    { weight: 8, arbitrary: set(wild) },
    { weight: 2, arbitrary: fc.record({ act: word('add'), node: node(wild) }) },
    {
      weight: 2,
      arbitrary: fc.record({ act: word('remove'), of: fc.constantFrom(...EDITED), pick }),
    },
    {
      weight: 1,
      arbitrary: fc.record({
        act: word('world'),
        field: fc.constant('gravity'),
        value: arrow(20, wild),
      }),
    },
    {
      weight: 1,
      arbitrary: fc.record({
        act: word('world'),
        field: fc.constant('accuracy'),
        value: fc.constantFrom(...levelNames),
      }),
    },
    {
      weight: 2,
      arbitrary: fc.record({
        act: word('applyForce', 'applyTorque', 'applyImpulse'),
        pick,
        value: arrow(20, wild),
        at: fc.option(arrow(3, wild)).map((at) => at ?? undefined),
      }),
    },
    {
      weight: 2,
      arbitrary: fc.record({
        act: word('teleport'),
        pick,
        position: arrow(3, wild),
        orientation: fc.option(turn).map((value) => value ?? undefined),
        velocities: fc.record(
          { linearVelocity: arrow(5, wild), angularVelocity: arrow(5, wild) },
          { requiredKeys: [] },
        ),
      }),
    },
    { weight: 1, arbitrary: fc.record({ act: word('wake', 'sleep'), pick }) },
    { weight: 2, arbitrary: fc.record({ act: word('snapshot', 'restore', 'reset') }) },
    ...(wild
      ? [
          { weight: 1, arbitrary: fc.record({ act: word('drag'), pick, value: arrow(3, true) }) },
          {
            weight: 1,
            arbitrary: fc.record({ act: word('step', 'raycast'), value: fc.oneof(nastyStep) }),
          },
        ]
      : []),
  );

const nastyStep = fc.constantFrom<unknown>(-1, 0, 0.5, NaN, -Infinity, Infinity, 'x', undefined);

const EVENTS: Record<string, readonly string[]> = {
  RigidBodyCollection: ['beforestep', 'afterstep', 'problem', 'reset', 'restore', 'accuracy'],
  RigidBody: ['collisionstart', 'collisionend', 'sleep', 'wake'],
  CollidableShape: ['collisionstart', 'collisionend'],
  CollisionSensor: ['contacts', 'intersections'],
  SingleAxisHingeJoint: ['jointlimit'],
  DoubleAxisHingeJoint: ['jointlimit'],
  SliderJoint: ['jointlimit'],
};

const heard: fc.Arbitrary<Heard> = fc.constantFrom(...Object.keys(EVENTS)).chain((of) =>
  fc.record({
    event: fc.constantFrom(...EVENTS[of]!),
    of: fc.constant(of),
    pick,
    times: fc.integer({ min: 1, max: 3 }),
  }),
);

const when = (steps: number): fc.Arbitrary<When> =>
  fc.oneof(fc.record({ step: fc.nat(steps) }), heard);

const MANY = { minLength: 1, maxLength: 24, size: 'max' } as const;

/** Most scenes have one. */
const GROUND: NodePlan = {
  type: 'RigidBody',
  fields: { fixed: true, position: [0, -3, 0], geometry: [{ type: 'Box', size: [30, 1, 30] }] },
};

const planOf = (wild: boolean): fc.Arbitrary<Plan> =>
  fc.integer({ min: 1, max: 120 }).chain((steps) =>
    fc
      .record({
        wild: fc.constant(wild),
        level: fc.constantFrom(...levelNames),
        gravity: fc.oneof(
          { weight: 3, arbitrary: fc.constant<unknown>([0, -9.8, 0]) },
          { weight: 1, arbitrary: arrow(20, wild) },
        ),
        nodes: fc
          .tuple(fc.option(fc.constant(GROUND)), fc.array(node(wild), MANY))
          .map(([ground, nodes]) => (ground ? [ground, ...nodes] : nodes)),
        steps: fc.constant(steps),
        edits: fc.array(fc.record({ when: when(steps), act: act(wild) }), MANY),
        particles: fc.array(particles(wild), { maxLength: 2 }),
        particleEdits: fc.array(particleEdit(steps, wild), { maxLength: 4 }),
        waters: fc.array(water(wild), { maxLength: 2 }),
        waterEdits: fc.array(waterEdit(steps, wild), { maxLength: 4 }),
        soft: fc.oneof(fc.constant<NodePlan[]>([]), softs(wild)),
        softEdits: fc.array(softEdit(steps, wild), { maxLength: 4 }),
      })
      .map(
        ({
          particles: systems,
          particleEdits,
          waters,
          waterEdits,
          soft,
          softEdits,
          nodes,
          edits,
          ...rest
        }) => ({
          ...rest,
          // What is tied where it does not hang pulls as it likes.
          wild: rest.wild || soft.length > 0,
          nodes: [...nodes, ...systems, ...waters, ...soft],
          edits: [
            ...edits,
            ...(systems.length > 0 ? particleEdits : []),
            ...(waters.length > 0 ? waterEdits : []),
            ...(soft.length > 0 ? softEdits : []),
          ],
        }),
      ),
  );

export const plan: fc.Arbitrary<Plan> = fc.oneof(planOf(false), planOf(true));
