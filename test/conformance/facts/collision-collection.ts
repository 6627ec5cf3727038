import { holds, near, ROUGH } from '../checks.js';
import type { Driver, Fact, NodeData } from '../fact.js';
import { body, box, collection, collidable, G, slab, sphere, use } from '../scenes.js';

type Fields = Record<string, unknown>;

/** A stone just above a slab, and the collection of both that is the world's collider. */
export const onSlab = (
  parameters: Fields,
  stone: Fields = {},
  shape: NodeData = box(2, 1, 2),
): NodeData[] => [
  collection({
    bodies: [
      slab(0),
      body('stone', {
        position: [0, 0.5, 0],
        geometry: [collidable(shape, { DEF: 'stoneShape' })],
        ...stone,
      }),
    ],
    collider: {
      type: 'CollisionCollection',
      DEF: 'collection',
      collidables: [use('slabShape'), use('stoneShape')],
      ...parameters,
    },
  }),
];

const position = (x: Driver): Promise<number[]> => x.get('stone', 'position');
const velocity = (x: Driver): Promise<number[]> => x.get('stone', 'linearVelocity');

/** Sends the stone along the slab and measures how far it has come when it lies still. */
async function slide(x: Driver, [vx, vz]: [number, number]): Promise<[number, number]> {
  await x.set('stone', 'position', [0, 0.5, 0]);
  await x.set('stone', 'linearVelocity', [vx, 0, vz]);
  await x.advance(3);
  const [px, , pz] = await position(x);
  return [px!, pz!];
}

/** Way until friction has stopped a speed, metres. */
const stopped = (mu: number, speed: number): number => (speed * speed) / (2 * mu * G);

/** Height above the slab of the next peak of a ball that falls a metre. */
async function peak(x: Driver): Promise<number> {
  await x.set('stone', 'position', [0, 1.5, 0]);
  await x.set('stone', 'linearVelocity', [0, 0, 0]);
  // It lands after 0.45 s, and has come up again after 0.9 s at most.
  await x.advance(0.5);
  let highest = 0;
  for (let i = 0; i < 30; i++) {
    highest = Math.max(highest, (await position(x))[1]! - 0.5);
    await x.advance(1 / 60);
  }
  return highest;
}

const STEP_ERROR = 0.06;

export const collisionCollection: Fact[] = [
  {
    field: 'appliedParameters',
    says: 'a parameter acts while its token stands there: BOUNCE, and none of the others by it',
    scene: onSlab({ bounce: 0.8, surfaceSpeed: [1, 0] }, {}, sphere(0.5)),
    run: async (x) => {
      const first = await peak(x);
      await x.set('collection', 'appliedParameters', []);
      const none = await peak(x);
      await x.set('collection', 'appliedParameters', ['BOUNCE']);
      return [
        near('with BOUNCE', first, 0.64, STEP_ERROR, 'm'),
        holds('without', none < 0.05),
        near('with it again', await peak(x), 0.64, STEP_ERROR, 'm'),
        near('no belt by it', (await velocity(x))[0]!, 0, 1e-3, 'm/s'),
      ];
    },
  },
  {
    field: 'bounce',
    says: 'a ball dropped from a metre comes back to bounce² metres',
    scene: onSlab({ bounce: 0.5 }, {}, sphere(0.5)),
    run: async (x) => {
      const first = await peak(x);
      await x.set('collection', 'bounce', 0.9);
      return [
        near('at 0.5', first, 0.25, STEP_ERROR, 'm'),
        near('at 0.9', await peak(x), 0.81, STEP_ERROR, 'm'),
      ];
    },
  },
  {
    field: 'minBounceSpeed',
    says: 'an approach below it does not bounce: a metre’s fall ends at 4.43 m/s',
    scene: onSlab({ bounce: 0.8, minBounceSpeed: 4 }, {}, sphere(0.5)),
    run: async (x) => {
      const first = await peak(x);
      await x.set('collection', 'minBounceSpeed', 5);
      return [
        near('at 4 m/s', first, 0.64, STEP_ERROR, 'm'),
        holds('at 5 m/s', (await peak(x)) < 0.05),
      ];
    },
  },
  {
    field: 'collidables',
    says: 'exactly its members collide: one that leaves falls through',
    scene: onSlab({}),
    // What is in no collider is told.
    tells: ['not-in-collider'],
    run: async (x) => {
      await x.advance(0.5);
      const first = (await position(x))[1]!;
      await x.set('collection', 'collidables', [use('slabShape')]);
      await x.advance(0.5);
      const second = (await position(x))[1]!;
      return [
        near('as a member', first, 0.5, 0.01, 'm'),
        near('fall in 0.5 s', first - second, G / 8, (G / 8) * ROUGH, 'm'),
      ];
    },
  },
  {
    field: 'enabled',
    says: 'a disabled collection lets its members pass through each other until it is enabled',
    scene: onSlab({ enabled: false }),
    run: async (x) => {
      await x.advance(0.5);
      const first = (await position(x))[1]!;
      await x.set('collection', 'enabled', true);
      await x.set('stone', 'position', [0, 0.6, 0]);
      await x.set('stone', 'linearVelocity', [0, 0, 0]);
      await x.advance(0.5);
      return [
        near('fall in 0.5 s', 0.5 - first, G / 8, (G / 8) * ROUGH, 'm'),
        near('enabled', (await position(x))[1]!, 0.5, 0.01, 'm'),
      ];
    },
  },
  {
    field: 'frictionCoefficients',
    says: 'with FRICTION_COEFFICIENT-2 each acts along its own direction: what slides stops after v² / 2 μ g',
    open: 'direction 1 lies along the world’s x axis, direction 2 across the surface',
    scene: onSlab({
      appliedParameters: ['FRICTION_COEFFICIENT-2'],
      frictionCoefficients: [0.5, 0.2],
    }),
    run: async (x) => {
      const first = [await slide(x, [2, 0]), await slide(x, [0, 2])].flat();
      await x.set('collection', 'frictionCoefficients', [0.25, 0.25]);
      const second = await slide(x, [2, 0]);
      await x.set('collection', 'appliedParameters', []);
      await x.set('collection', 'frictionCoefficients', [0.25, 0.5]);
      return [
        near(
          '0.5 along x, 0.2 along z',
          first,
          [stopped(0.5, 2), 0, 0, stopped(0.2, 2)],
          0.06,
          'm',
        ),
        near('0.25 both', second, [stopped(0.25, 2), 0], 0.06, 'm'),
        near(
          'without the token the first',
          await slide(x, [0, 2]),
          [0, stopped(0.25, 2)],
          0.06,
          'm',
        ),
      ];
    },
  },
  {
    field: 'surfaceSpeed',
    says: 'with SPEED-1 and SPEED-2 the slab is a belt that carries the stone at this speed',
    open: 'of two bodies the one that moves is carried',
    scene: onSlab({
      appliedParameters: ['SPEED-1', 'SPEED-2', 'FRICTION_COEFFICIENT-2'],
      frictionCoefficients: [0.5, 0.5],
      surfaceSpeed: [1.5, -0.5],
    }),
    run: async (x) => {
      await x.advance(2);
      const first = await velocity(x);
      await x.set('collection', 'surfaceSpeed', [-1, 0]);
      await x.advance(2);
      const second = await velocity(x);
      await x.set('collection', 'appliedParameters', ['FRICTION_COEFFICIENT_2']);
      await x.advance(1);
      return [
        near('both', first, [1.5, 0, -0.5], 0.01, 'm/s'),
        near('backwards', second, [-1, 0, 0], 0.01, 'm/s'),
        near('without the tokens', await velocity(x), [0, 0, 0], 0.01, 'm/s'),
      ];
    },
  },
  {
    field: 'slipFactors',
    says: 'with SLIP-1 and SLIP-2 a load slides at factor × force',
    open: 'the force is that of all contact points of the two bodies',
    scene: onSlab(
      { appliedParameters: ['SLIP-1', 'SLIP-2'], slipFactors: [0.05, 0.2] },
      { forces: [[2, 0, 1]] },
    ),
    run: async (x) => {
      await x.advance(3);
      const first = await velocity(x);
      await x.set('collection', 'slipFactors', [0.2, 0]);
      await x.advance(3);
      return [
        near('at 0.05 and 0.2', first, [0.1, 0, 0.2], 0.002, 'm/s'),
        near('at 0.2 and 0', await velocity(x), [0.4, 0, 0], 0.005, 'm/s'),
      ];
    },
  },
  {
    field: 'softnessConstantForceMix',
    says: 'with CONSTANT_FORCE a load F sinks in by F · softness / (60 · error correction)',
    open: 'the force is that of all contact points of the two bodies',
    tells: ['approximated-field', 'approximated-field'],
    scene: onSlab({
      appliedParameters: ['CONSTANT_FORCE', 'ERROR_REDUCTION'],
      softnessConstantForceMix: 0.1,
      softnessErrorCorrection: 0.8,
    }),
    run: async (x) => {
      await x.advance(4);
      const first = 0.5 - (await position(x))[1]!;
      await x.set('collection', 'softnessConstantForceMix', 0.3);
      await x.advance(6);
      return [
        near('at 0.1', first, (G * 0.1) / 48, 0.001, 'm'),
        near('at 0.3', 0.5 - (await position(x))[1]!, (G * 0.3) / 48, 0.001, 'm'),
      ];
    },
  },
  {
    field: 'softnessErrorCorrection',
    says: 'with ERROR_REDUCTION it is the share of an overlap that goes in a frame',
    tells: ['initial-overlap'],
    scene: [
      ...onSlab(
        { appliedParameters: ['ERROR_REDUCTION'], softnessErrorCorrection: 0.1 },
        { position: [0, 0.3, 0], useGlobalGravity: false },
      ),
    ],
    run: async (x) => {
      await x.advance(0.1);
      const first = 0.5 - (await position(x))[1]!;
      await x.set('collection', 'softnessErrorCorrection', 0.5);
      await x.advance(0.1);
      const second = 0.5 - (await position(x))[1]!;
      return [
        // A frame more or less is a tenth of it.
        near('after six frames at 0.1', first, 0.2 * 0.9 ** 6, 0.2 * 0.9 ** 6 * 0.2, 'm'),
        holds('after six more at 0.5', second < first * 0.5 ** 4),
      ];
    },
  },
];
