import '../../physics-core/index.js';
import { createWorld } from '../../physics-core/create.js';

/**
 * What particles come to after two seconds at `standard`, as a hash of all their places and of the poses of what they and their winds push: the
 * same bits in Node and in every browser. Where the motion is changed on purpose, the test says what they are now.
 */
export const PARTICLE_BITS = 'aaf7ae1e';

const STEPS = 240;

const emitters = [
  { type: 'ConeEmitter', position: [0, 1, 0], angle: 0.6, speed: 5, mass: 0.02, surfaceArea: 0.01 },
  { type: 'ExplosionEmitter', position: [0, 2, 0], speed: 3, mass: 0.02, surfaceArea: 0.01 },
  {
    type: 'PolylineEmitter',
    coord: [-1, 3, 0, 1, 3, 1],
    direction: [0, 0, 0],
    speed: 2,
    mass: 0.02,
  },
  { type: 'SurfaceEmitter', surface: { type: 'Sphere', radius: 0.4 }, speed: 4, mass: 0.02 },
];

/** Four laws of birth, wind that whirls and pushes bodies, drag, and bounces off what spins. */
export async function particleBits(): Promise<string> {
  const world = await createWorld({ rest: 'never' });
  world.add('RigidBody', { fixed: true, geometry: [{ type: 'Box', size: [20, 0.2, 20] }] });
  const pushed = world.add('RigidBody', {
    position: [0.2, 1.5, 0.1],
    angularVelocity: [3, 7, 1],
    geometry: [{ type: 'Box', size: [0.5, 0.7, 0.9] }],
  });
  const blown = world.add('RigidBody', {
    position: [0.2, 3, 1],
    geometry: [{ type: 'Cone', bottomRadius: 0.4, height: 0.9 }],
  });
  const systems = emitters.map((emitter, seed) =>
    world.add('ParticleSystem', {
      emitter,
      physics: [
        { type: 'ForcePhysicsModel', force: [0, -0.196, 0] },
        { type: 'WindPhysicsModel', speed: 2, gustiness: 0.5, turbulence: 0.6 },
      ],
      seed,
      maxParticles: 150,
      particleLifetime: 1.5,
      particleSize: [0.05, 0.05],
      collides: true,
      pushes: true,
      bounce: 0.5,
      damping: 0.2,
    }),
  );
  world.step(STEPS);
  const places = systems.map((system) => system.get('positions') as number[][]);
  const poses = [pushed, blown].flatMap((body) => [
    body.get('position'),
    body.get('orientation'),
  ]) as number[][];
  world.destroy();
  return hashOf([...places, poses].flat(2));
}

/** FNV-1a, 32 bits, of the bytes of numbers. */
function hashOf(numbers: number[]): string {
  let hash = 0x811c9dc5;
  for (const byte of new Uint8Array(Float64Array.from(numbers).buffer))
    hash = Math.imul(hash ^ byte, 0x01000193) >>> 0;
  return hash.toString(16).padStart(8, '0');
}
