import '../../physics-core/index.js';
import { debugLines } from '../../physics-core/debug-lines.js';
import { BODIES, box, type Scene } from './scenes.js';

/** One effect more than a scene has without it. */
export interface Addition {
  /** As `world.effects` calls it. */
  effect: string;
  /** What calls for it, for people. */
  by: string;
  without: Scene;
  with: Scene;
  /** Files of the build that are fetched for it, by how their names begin; undefined: that of its chunk. */
  files?: readonly string[];
}

// Nothing but Bullet moves these.
const drifting: Scene = { body: { useGlobalGravity: false, linearVelocity: [0, 1, 0] } };
const falling: Scene = {};
// Half as dense as water, at its surface.
const floating: Scene = { body: { mass: 260 } };
const slabs = { geometry: [box(1, 2, 0.5)], angularVelocity: [0.1, 3, 0.1] };
const rods = { geometry: [box(0.6, 0.02, 0.02)] };
const standing: Scene = { floor: true };
const onAxles: Scene = { joint: ['DoubleAxisHingeJoint', { axis1: [0, 1, 0], axis2: [0, 0, 1] }] };

const axle = (fields: Record<string, unknown>): Scene => ({
  joint: ['DoubleAxisHingeJoint', { ...onAxles.joint![1], ...fields }],
});

const cylinder = { type: 'Cylinder', radius: 0.5, height: 1 };

const tetrahedron = {
  type: 'IndexedFaceSet',
  coord: [0.3, 0.3, 0.3, -0.3, -0.3, 0.3, -0.3, 0.3, -0.3, 0.3, -0.3, -0.3],
  coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1],
};

/** What touches goes to page code, which hands it back or does not. */
const sensed = (handBack: boolean): Scene => ({
  floor: true,
  also: (world) => {
    const collider = world.add('CollisionCollection', { collidables: '*' });
    const sensor = world.add('CollisionSensor', { collider });
    sensor.on('contacts', (contacts) => {
      if (handBack) world.settings.event('set_contacts', contacts);
    });
  },
});

export const additions: readonly Addition[] = [
  {
    effect: 'free flight',
    by: 'gravity',
    without: drifting,
    with: falling,
  },
  {
    effect: 'forces',
    by: 'a force on each body',
    without: falling,
    with: { body: { forces: [[1, 0, 0]] } },
  },
  {
    effect: 'gyroscopic torque',
    by: 'slabs that spin, not balls',
    without: drifting,
    with: { body: { ...drifting.body, ...slabs } },
  },
  {
    effect: 'full turns',
    by: 'balls that spin at 100 rad/s',
    without: drifting,
    with: { body: { ...drifting.body, angularVelocity: [0, 100, 0] } },
  },
  {
    effect: 'axis damping',
    by: 'autoDamp of slabs that spin',
    without: { body: slabs },
    with: { body: { ...slabs, autoDamp: true, angularDampingFactor: 0.1 } },
  },
  {
    effect: 'mesh shapes',
    by: 'tetrahedra, not balls',
    without: drifting,
    with: { body: { ...drifting.body, geometry: [tetrahedron] } },
  },
  {
    effect: 'continuous collision',
    by: 'bodies that fly 0.8 m in a step',
    without: drifting,
    with: { body: { useGlobalGravity: false, linearVelocity: [0, 100, 0] } },
  },
  {
    effect: 'swept ends',
    by: 'thin rods that turn at 20 rad/s, with nothing within reach',
    without: { body: { ...drifting.body, ...rods, angularVelocity: [0, 0.2, 0] } },
    with: { body: { ...drifting.body, ...rods, angularVelocity: [0, 20, 0] } },
  },
  {
    effect: 'joint solve',
    by: 'a ball joint of each body',
    without: falling,
    with: { joint: ['BallJoint', {}] },
  },
  {
    effect: 'motors',
    by: 'a motor of each axle',
    without: onAxles,
    with: axle({ desiredAngularVelocity2: 3, maxTorque2: 1 }),
  },
  {
    effect: 'stops',
    by: 'stops of each axle',
    without: onAxles,
    with: axle({ minAngle1: -0.5, maxAngle1: 0.5 }),
  },
  {
    effect: 'suspension',
    by: 'a soft suspension of each axle',
    without: onAxles,
    with: axle({ suspensionForce: 0.1, suspensionErrorCorrection: 0.5 }),
  },
  {
    effect: 'contact solve',
    by: 'a floor under all bodies',
    without: falling,
    with: standing,
  },
  {
    effect: 'contact shapes',
    by: 'cylinders on it, not balls',
    without: standing,
    with: { floor: true, body: { geometry: [cylinder] } },
  },
  {
    effect: 'contact surface',
    by: 'bounce of all bodies on it',
    without: standing,
    with: {
      floor: true,
      also: (world) =>
        world.add('CollisionCollection', {
          collidables: '*',
          appliedParameters: ['BOUNCE'],
          bounce: 0.5,
        }),
    },
  },
  {
    effect: 'contact reading',
    by: 'a listener to collisionstart at each body',
    without: standing,
    with: {
      floor: true,
      also: (_, bodies) => bodies.forEach((body) => body.on('collisionstart', () => {})),
    },
  },
  {
    effect: 'given contacts',
    by: 'set_contacts of what a sensor tells',
    without: sensed(false),
    with: sensed(true),
  },
  {
    effect: 'pair filter',
    by: `20 collections that leave out ${BODIES / 2} bodies`,
    without: standing,
    with: {
      floor: true,
      also: (world, bodies) => {
        for (let i = 0; i < 20; i++) {
          const collidables = bodies.filter((_, k) => k % 40 === i || k % 20 === i / 2);
          world.add('CollisionCollection', {
            collidables: collidables.flatMap((body) => body.get('geometry') as never[]),
            enabled: false,
          });
        }
      },
    },
  },
  {
    effect: 'carrying',
    by: 'a floor that is moved before each step',
    without: standing,
    with: {
      floor: true,
      each: (_, __, floor) => {
        let steps = 0;
        const y = floor!.pose().p[1];
        return () => {
          const [x, , z] = floor!.pose().p;
          floor!.event('position', [x, y + 0.1 * Math.sin(steps++ / 20), z]);
        };
      },
    },
  },
  {
    effect: 'particles',
    by: 'a thousand particles that fall beside them',
    without: drifting,
    with: {
      ...drifting,
      also: (world) => {
        world.add('ParticleSystem', {
          emitter: { type: 'ConeEmitter', speed: 4, mass: 0.001 },
          physics: [{ type: 'ForcePhysicsModel', force: [0, -0.0098, 0] }],
          maxParticles: 1000,
          particleLifetime: 1,
        });
      },
    },
  },
  {
    effect: 'water',
    by: 'a sea that they float in',
    without: floating,
    with: {
      ...floating,
      also: (world) => {
        world.add('WaterVolume', { size: [400, 100, 400], position: [40, -49.5, 20] });
      },
    },
  },
  {
    effect: 'waves',
    by: 'waves of that sea',
    without: {
      ...floating,
      also: (world) => {
        world.add('WaterVolume', { size: [400, 100, 400], position: [40, -49.5, 20] });
      },
    },
    with: {
      ...floating,
      also: (world) => {
        world.add('WaterVolume', {
          size: [400, 100, 400],
          position: [40, -49.5, 20],
          waves: true,
        });
      },
    },
  },
  {
    effect: 'ropes',
    by: 'a rope of a hundred links that hangs beside them',
    without: drifting,
    with: {
      ...drifting,
      also: (world) => {
        world.add('Rope', {
          points: [0, 400, 0, 10, 400, 0],
          segments: 100,
          fixedIndex: [0],
        });
      },
    },
  },
  {
    effect: 'deformables',
    by: 'a cloth of sixteen by sixteen cells that hangs beside them',
    without: drifting,
    with: {
      ...drifting,
      also: (world) => {
        world.add('Cloth', { size: [2, 2], fixedIndex: [272, 288] });
      },
    },
  },
  {
    effect: 'dragging',
    by: 'a hand that holds one body',
    without: drifting,
    with: {
      ...drifting,
      each: (_, [body]) => {
        body!.drag(body!.pose().p);
        return () => {};
      },
    },
    files: ['chunk-drag-code', 'chunk-hands'],
  },
  {
    effect: 'rest',
    by: 'bodies that may sleep, and move',
    without: falling,
    with: { world: { rest: 'auto' } },
  },
  {
    effect: 'debug drawing',
    by: 'debug, with each step drawn',
    without: drifting,
    with: {
      ...drifting,
      world: { debug: true },
      each: async (world) => {
        const lines = await debugLines(world);
        return () => lines.update();
      },
    },
    files: ['chunk-debug-code', 'chunk-sketch'],
  },
  {
    effect: 'monitor',
    by: 'an <x3d-physics-monitor>',
    without: drifting,
    with: { ...drifting, also: (world) => void world.recordCosts('the lab') },
    files: ['ui/monitor', 'ui/chunk-styles'],
  },
  {
    effect: 'user timing',
    by: 'world.profile',
    without: drifting,
    with: { ...drifting, also: (world) => void (world.profile = true) },
  },
];
