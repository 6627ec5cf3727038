import type { NodeData } from '../conformance/fact.js';
import { use } from '../conformance/scenes.js';
import { ANGLES, AXES, kept, OFF, ON, POINTS, SHARES, type Edit } from './edit.js';

const TETRAHEDRON = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const SIDES = [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1];
const INSIDE_OUT = [0, 1, 2, -1, 0, 3, 1, -1, 0, 2, 3, -1, 1, 3, 2, -1];

const coordinate = (point: number[]): NodeData => ({ type: 'Coordinate', point });

/** Where those bear particles that have to be told. */
const SOURCES: Record<string, Record<string, unknown>> = {
  PointEmitter: {},
  ConeEmitter: {},
  ExplosionEmitter: {},
  PolylineEmitter: { coord: coordinate([0, 0, 0, 1, 0, 0]) },
  SurfaceEmitter: { surface: { type: 'Box' } },
  VolumeEmitter: { coord: coordinate(TETRAHEDRON), coordIndex: SIDES },
};

const system = (DEF: string, emitter: NodeData, physics: NodeData[] = []): NodeData => ({
  type: 'ParticleSystem',
  DEF,
  emitter,
  physics,
});

/** What forces and winds move. */
const source = (DEF: string): NodeData => ({
  type: 'PointEmitter',
  DEF,
  mass: 1,
  surfaceArea: 1,
});

const MODELS = ['ForcePhysicsModel', 'WindPhysicsModel', 'BoundedPhysicsModel'];

const model = (type: string, DEF = type): NodeData => ({ type, DEF });

/** One of each emitter in a system of its own, one with a model of each kind, and two of which it may take parts. */
export const particleScene = (): NodeData[] => [
  system(
    'system',
    source('source'),
    MODELS.map((type) => model(type)),
  ),
  system('spareSystem', source('spareSource'), [model('ForcePhysicsModel', 'spareForce')]),
  system('otherSystem', source('otherSource'), [model('WindPhysicsModel', 'otherWind')]),
  ...Object.entries(SOURCES).map(([type, fields]) =>
    system(`${type}System`, { ...model(type), ...fields }),
  ),
];

export const PARTICLE_SUBJECTS: Record<string, string> = {
  ParticleSystem: 'system',
  ...Object.fromEntries([...Object.keys(SOURCES), ...MODELS].map((type) => [type, type])),
};

/** Points for the fields that take them. */
export const POINT_SPARES: Record<string, NodeData> = {
  corners: coordinate(TETRAHEDRON.map((value) => 2 * value)),
  otherCorners: coordinate(TETRAHEDRON.map((value) => 3 * value)),
};

/** Any node does: nobody but who draws asks which. */
const drawn = kept([use('data'), use('moreData')]);
const KEYS = kept([
  [0, 1],
  [0, 2],
]);

const SHOWN = ['.count', '.positions'];

const systemEdits: Record<string, Edit> = {
  appearance: drawn,
  castShadow: kept(OFF),
  color: drawn,
  colorKey: KEYS,
  geometry: kept([use('flat'), use('long')]),
  geometryType: kept(['LINE', 'POINT']),
  texCoord: drawn,
  texCoordKey: KEYS,
  createParticles: { values: OFF },
  enabled: { values: OFF, changes: [...SHOWN, '.isActive'] },
  lifetimeVariation: { values: [0.5, 0.6] },
  maxParticles: { values: [5, 7], changes: SHOWN },
  particleLifetime: { values: [1, 2] },
  particleSize: {
    values: [
      [0.1, 0.2],
      [0.2, 0.1],
    ],
  },
  emitter: { values: [use('spareSource'), use('otherSource')], stays: ['.emitter'] },
  physics: { values: [[use('spareForce')], [use('otherWind')]], stays: ['.physics'] },
  collides: { values: ON },
  pushes: { values: ON, given: { collides: true } },
  bounce: { values: SHARES },
  friction: { values: SHARES },
  seed: { values: [1, 2] },
  damping: { values: SHARES },
  body: { values: [use('spare'), use('pole')] },
};

const emitterEdits: Record<string, Edit> = {
  on: { values: OFF },
  speed: { values: [1, 2] },
  variation: { values: [0.5, 0.6] },
  mass: { values: [1, 2] },
  surfaceArea: { values: [1, 2] },
  position: { values: POINTS },
  direction: { values: AXES },
  angle: { values: ANGLES },
};

/** Without them it bears nothing, and says so. */
const points: Edit = {
  values: [use('corners'), use('otherCorners')],
  stays: ['.coord'],
  ends: ['idle-emitter'],
};

const enabled: Edit = { values: OFF };

export const particleEdits: Record<string, Record<string, Edit>> = {
  ParticleSystem: systemEdits,
  PointEmitter: emitterEdits,
  ConeEmitter: emitterEdits,
  ExplosionEmitter: emitterEdits,
  PolylineEmitter: {
    ...emitterEdits,
    coord: points,
    coordIndex: {
      values: [
        [0, 1, -1],
        [1, 0, -1],
      ],
    },
  },
  SurfaceEmitter: {
    ...emitterEdits,
    surface: {
      values: [use('flat'), use('long')],
      stays: ['.surface'],
      ends: ['idle-emitter'],
    },
  },
  VolumeEmitter: {
    ...emitterEdits,
    coord: points,
    coordIndex: {
      values: [INSIDE_OUT, [...SIDES].slice(0, -1)],
      stays: ['.coordIndex'],
      ends: ['idle-emitter'],
    },
    internal: { values: OFF },
  },
  ForcePhysicsModel: { enabled, force: { values: POINTS } },
  WindPhysicsModel: {
    enabled,
    direction: { values: AXES },
    speed: { values: [1, 2] },
    gustiness: { values: [0.5, 0.6] },
    turbulence: { values: SHARES },
  },
  BoundedPhysicsModel: { enabled, geometry: { values: [use('flat'), use('long')] } },
};
