import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { particleTypes } from '../../../../physics-core/nodes/particles/index.js';
import { fact } from '../../helpers.js';

/** ISO/IEC 19775-1:2023, as it writes an interface: type, access, name, default. */
type Line = [type: string, access: keyof typeof ACCESS, name: string, value?: unknown];

const ACCESS = {
  'in, out': 'inputOutput',
  '': 'initializeOnly',
  in: 'inputOnly',
  out: 'outputOnly',
} as const;

const NODE: Line[] = [['SFNode', 'in, out', 'metadata', null]];

const EMITTER: Line[] = [
  ...NODE,
  ['SFFloat', 'in, out', 'mass', 0],
  ['SFBool', 'in, out', 'on', true],
  ['SFFloat', 'in, out', 'speed', 0],
  ['SFFloat', 'in, out', 'surfaceArea', 0],
  ['SFFloat', 'in, out', 'variation', 0.25],
];

const POSITION: Line[] = [['SFVec3f', 'in, out', 'position', [0, 0, 0]]];
const DIRECTION: Line[] = [['SFVec3f', 'in, out', 'direction', [0, 1, 0]]];

/** Its coordIndex is [], and set_coordIndex is there for events: one field here, that takes them. */
const COORD: Line[] = [
  ['SFNode', 'in, out', 'coord', null],
  ['MFInt32', 'in, out', 'coordIndex', [-1]],
];

const MODEL: Line[] = [...NODE, ['SFBool', 'in, out', 'enabled', true]];

const STANDARD: Record<string, { clause: string; containerField: string; fields: Line[] }> = {
  BoundedPhysicsModel: {
    clause: '40.4.1',
    containerField: 'physics',
    fields: [...MODEL, ['SFNode', 'in, out', 'geometry', null]],
  },
  ConeEmitter: {
    clause: '40.4.2',
    containerField: 'emitter',
    fields: [...EMITTER, ...POSITION, ...DIRECTION, ['SFFloat', 'in, out', 'angle', Math.PI / 4]],
  },
  ExplosionEmitter: {
    clause: '40.4.3',
    containerField: 'emitter',
    fields: [...EMITTER, ...POSITION],
  },
  ForcePhysicsModel: {
    clause: '40.4.4',
    containerField: 'physics',
    fields: [...MODEL, ['SFVec3f', 'in, out', 'force', [0, -9.8, 0]]],
  },
  ParticleSystem: {
    clause: '40.4.5',
    containerField: 'children',
    fields: [
      ...NODE,
      ['SFNode', 'in, out', 'appearance', null],
      ['SFBool', 'in, out', 'bboxDisplay', false],
      ['SFBool', 'in, out', 'castShadow', true],
      ['SFBool', 'in, out', 'createParticles', true],
      ['SFBool', 'in, out', 'enabled', true],
      ['SFNode', 'in, out', 'geometry', null],
      ['SFFloat', 'in, out', 'lifetimeVariation', 0.25],
      ['SFInt32', 'in, out', 'maxParticles', 200],
      ['SFFloat', 'in, out', 'particleLifetime', 5],
      ['SFVec2f', 'in, out', 'particleSize', [0.02, 0.02]],
      ['SFBool', 'in, out', 'visible', true],
      ['SFBool', 'out', 'isActive', false],
      ['SFVec3f', '', 'bboxCenter', [0, 0, 0]],
      ['SFVec3f', '', 'bboxSize', [-1, -1, -1]],
      ['SFNode', '', 'color', null],
      ['MFFloat', '', 'colorKey', []],
      ['SFNode', '', 'emitter', null],
      ['SFString', '', 'geometryType', 'QUAD'],
      ['MFNode', '', 'physics', []],
      ['SFNode', '', 'texCoord', null],
      ['MFFloat', '', 'texCoordKey', []],
    ],
  },
  PointEmitter: {
    clause: '40.4.6',
    containerField: 'emitter',
    fields: [...EMITTER, ...POSITION, ...DIRECTION],
  },
  PolylineEmitter: {
    clause: '40.4.7',
    containerField: 'emitter',
    fields: [...EMITTER, ...DIRECTION, ...COORD],
  },
  SurfaceEmitter: {
    clause: '40.4.8',
    containerField: 'emitter',
    fields: [...EMITTER, ['SFNode', '', 'surface', null]],
  },
  VolumeEmitter: {
    clause: '40.4.9',
    containerField: 'emitter',
    fields: [...EMITTER, ...DIRECTION, ...COORD, ['SFBool', '', 'internal', true]],
  },
  WindPhysicsModel: {
    clause: '40.4.10',
    containerField: 'physics',
    fields: [
      ...MODEL,
      ['SFVec3f', 'in, out', 'direction', [1, 0, 0]],
      ['SFFloat', 'in, out', 'gustiness', 0.1],
      ['SFFloat', 'in, out', 'speed', 0.1],
      ['SFFloat', 'in, out', 'turbulence', 0],
    ],
  },
};

/** Additions of ours. */
const OWN: Line[] = [
  ['SFBool', 'in, out', 'collides', false],
  ['SFBool', 'in, out', 'pushes', false],
  ['SFFloat', 'in, out', 'bounce', 0],
  ['SFFloat', 'in, out', 'friction', 0.5],
  ['SFInt32', 'in, out', 'seed', 0],
  ['SFFloat', 'in, out', 'damping', 0],
  ['SFNode', 'in, out', 'body', null],
  ['MFVec3f', 'out', 'positions', []],
  ['SFInt32', 'out', 'count', 0],
];

const UP = [0, Infinity];
const SHARE = [0, 1];

const RANGES: Record<string, Record<string, readonly number[]>> = {
  ParticleSystem: {
    colorKey: UP,
    lifetimeVariation: SHARE,
    maxParticles: UP,
    particleLifetime: UP,
    particleSize: UP,
    texCoordKey: UP,
    bounce: SHARE,
    friction: UP,
    damping: UP,
  },
  ConeEmitter: { angle: [0, Math.PI] },
  PolylineEmitter: { coordIndex: [-1, Infinity] },
  VolumeEmitter: { coordIndex: [-1, Infinity] },
  WindPhysicsModel: { gustiness: UP, speed: UP, turbulence: SHARE },
};

const EMITTER_RANGES = { mass: UP, speed: UP, surfaceArea: UP, variation: UP };

const UNITS: Record<string, object> = {
  angle: { angle: 1 },
  bboxCenter: { length: 1 },
  bboxSize: { length: 1 },
  force: { force: 1 },
  mass: { mass: 1 },
  particleSize: { length: 1 },
  position: { length: 1 },
  positions: { length: 1 },
  speed: { length: 1 },
  surfaceArea: { length: 2 },
};

const types = Object.entries(particleTypes);
const fields = types.flatMap(([type, node]) =>
  Object.entries(node.fields).map(([name, field]) => ({ type, name, field })),
);

describe("the tables of X3D's particle component", () => {
  fact('have every node of the standard, where it stands there', () => {
    const said = types.map(([name, { clause, containerField }]) => [name, clause, containerField]);
    const wanted = Object.entries(STANDARD);
    assert.deepEqual(
      said.sort(),
      wanted.map(([name, { clause, containerField }]) => [name, clause, containerField]),
    );
    for (const [name, type] of types) assert.equal(type.name, name);
  });

  fact('have every field of the standard with its type, access and default, and no others', () => {
    for (const [type, node] of types) {
      const own = type === 'ParticleSystem' ? OWN : [];
      const lines = [...STANDARD[type]!.fields, ...own];
      const said = Object.entries(node.fields).map(([name, field]) => [
        name,
        field.type,
        field.access,
        field.default,
        field.own === true,
      ]);
      const wanted = lines.map((line) => {
        const [fieldType, access, name, value] = line;
        return [name, fieldType, ACCESS[access], value, own.includes(line)];
      });
      const byName = (a: unknown[], b: unknown[]): number => (String(a[0]) < String(b[0]) ? -1 : 1);
      assert.deepEqual(said.sort(byName), wanted.sort(byName), type);
    }
  });

  fact('have the ranges of the standard', () => {
    for (const [type, node] of types) {
      const emits = node.containerField === 'emitter';
      const wanted = { ...RANGES[type], ...(emits && EMITTER_RANGES) };
      const said = Object.fromEntries(
        Object.entries(node.fields).flatMap(([name, { range }]) => (range ? [[name, range]] : [])),
      );
      assert.deepEqual(said, wanted, type);
    }
    assert.equal(particleTypes['ParticleSystem']!.fields['maxParticles']!.most, 100_000);
  });

  fact('have the units of what has some', () => {
    for (const { type, name, field } of fields)
      assert.deepEqual(field.dimension, UNITS[name], `${type}.${name}`);
  });

  fact('know what a field was called, and which default it had, in X3D 3', () => {
    const named = fields.flatMap(({ name, field }) =>
      (field.aliases ?? []).map((alias) => [alias, name]),
    );
    assert.deepEqual(named, [
      ['colorRamp', 'color'],
      ['texCoordRamp', 'texCoord'],
    ]);
    const other = fields.filter(({ field }) => field.default3 !== undefined);
    assert.deepEqual(
      other.map(({ type, name, field }) => [type, name, field.default3]),
      [['WindPhysicsModel', 'direction', [0, 0, 0]]],
    );
  });

  fact(
    'take nodes that there are, and make what is asked for first before what asks for it',
    () => {
      const system = particleTypes['ParticleSystem']!;
      const parts = types.filter(([name]) => name !== 'ParticleSystem');
      for (const field of ['emitter', 'physics'])
        assert.deepEqual(
          [...system.fields[field]!.nodes!].sort(),
          parts
            .filter(([, type]) => type.containerField === field)
            .map(([name]) => name)
            .sort(),
        );
      for (const [name, type] of parts) assert.ok(type.rank < system.rank, name);
    },
  );

  fact('say in a sentence what each node and field is', () => {
    const docs = [
      ...types.map(([type, { doc }]) => [type, doc]),
      ...fields.map(({ type, name, field }) => [`${type}.${name}`, field.doc]),
    ];
    for (const [of, doc] of docs) assert.match(doc!, /^[A-Z-]\S* .+[^.]\.$/, of);
  });

  fact('do something at every edit but of what is only drawn', () => {
    const idle = fields.filter(({ field }) => !field.common && !field.read && !field.patch);
    assert.deepEqual(
      idle.map(({ type, name, field }) => [type, name, field.edit]),
      [
        'appearance',
        'castShadow',
        'color',
        'colorKey',
        'geometry',
        'geometryType',
        'texCoord',
        'texCoordKey',
      ].map((name) => ['ParticleSystem', name, 'passive']),
    );
  });
});
