import type {
  ConeEmitterFields,
  ParticleSystemFields,
  WindPhysicsModelFields,
  World,
} from '../../physics-core/index.js';
import { box } from '../price/scene.js';
import { hanging } from './bodies.js';
import { FOUNTAIN, MASS } from './fountain.js';

/** What is measured in Node. */
export interface NodeScene {
  id: string;
  name: string;
  /** Whether Babylon.js has it, too. */
  inBabylon?: boolean;
  /** Seconds until all is as it stays. */
  before: number;
  addBodies?(world: World): void;
  /** Fields of the system. */
  system?: ParticleSystemFields;
  /** Fields of its emitter. */
  emitter?: ConeEmitterFields;
  /** Of the wind that moves its particles besides gravity. */
  wind?: WindPhysicsModelFields;
}

const BODIES = 50;

const drag = { damping: 0.2 };
const WIND = { direction: [1, 0, 0], speed: 2 };
/** m² that each shows to the wind. */
const shown = { surfaceArea: 0.001 };

function addHanging(world: World): void {
  for (const { position, shape, spin } of hanging(BODIES))
    world.add('RigidBody', {
      position,
      angularVelocity: spin,
      geometry: [shape],
      useGlobalGravity: false,
      autoDisable: false,
    });
}

/** Metres: of the ground, and from one box on it to the next. */
const [WIDE, APART] = [40, 1.2];

function addStanding(world: World): void {
  world.add('RigidBody', {
    fixed: true,
    position: [0, -0.5, 0],
    geometry: [box(WIDE, 1, WIDE)],
  });
  const row = Math.ceil(Math.sqrt(BODIES));
  for (let i = 0; i < BODIES; i++) {
    const [column, line] = [i % row, Math.floor(i / row)];
    const at = (place: number): number => APART * (place - (row - 1) / 2);
    world.add('RigidBody', {
      position: [at(column), 0.3, at(line)],
      geometry: [box(0.6, 0.6, 0.6)],
    });
  }
}

const { life } = FOUNTAIN;
/** Seconds that those live that come to lie within the first of them. */
const LONG = 8;

export const nodeScenes: readonly NodeScene[] = [
  { id: 'free', name: 'in free flight', before: life, inBabylon: true },
  {
    id: 'wind',
    name: 'with drag, in a wind',
    before: life,
    system: drag,
    emitter: shown,
    wind: WIND,
  },
  {
    id: 'whirl',
    name: 'with drag, in a wind that whirls',
    before: life,
    system: drag,
    emitter: shown,
    wind: { ...WIND, turbulence: 0.5 },
  },
  {
    id: 'turning',
    name: 'among 50 bodies that turn in the air',
    before: life,
    addBodies: addHanging,
    system: { collides: true, bounce: 0.6 },
  },
  {
    id: 'flying',
    name: 'onto 50 boxes and the ground, most in the air',
    before: life,
    addBodies: addStanding,
    emitter: { position: [0, 0.5, 0] },
    system: { collides: true, bounce: 0.6 },
  },
  {
    id: 'lying',
    name: 'most lying on 50 boxes and the ground',
    before: LONG,
    addBodies: addStanding,
    emitter: { position: [0, 1, 0], speed: 4, angle: 0.8 },
    system: { collides: true, particleLifetime: LONG },
  },
];

/** The fountain in a world, otherwise where the scene says so. */
export const addFountain = (world: World, scene: NodeScene, count: number) =>
  world.add('ParticleSystem', {
    maxParticles: count,
    particleLifetime: life,
    lifetimeVariation: 0,
    particleSize: [FOUNTAIN.size, FOUNTAIN.size],
    emitter: {
      type: 'ConeEmitter',
      angle: FOUNTAIN.angle,
      speed: FOUNTAIN.speed,
      variation: FOUNTAIN.variation,
      mass: MASS,
      ...scene.emitter,
    },
    physics: [
      { type: 'ForcePhysicsModel', force: [0, FOUNTAIN.gravity * MASS, 0] },
      ...(scene.wind ? [{ type: 'WindPhysicsModel' as const, ...scene.wind }] : []),
    ],
    ...scene.system,
  });
