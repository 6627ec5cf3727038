import { holds, same } from '../checks.js';
import type { Driver, Fact, NodeData } from '../fact.js';
import { body, collection, collidable, slab, sphere, use } from '../scenes.js';

type Contact = Record<string, unknown>;

/** A ball at rest on a slab, a sensor of both, and a collection that lists neither. */
const watched = (fields: Record<string, unknown> = {}): NodeData[] => [
  collection({
    bodies: [
      slab(0),
      body('ball', {
        position: [0, 0.5, 0],
        geometry: [collidable(sphere(0.5), { DEF: 'ballShape' })],
      }),
    ],
  }),
  { type: 'CollisionCollection', DEF: 'others', collidables: [] },
  {
    type: 'CollisionCollection',
    DEF: 'both',
    collidables: [use('slabShape'), use('ballShape')],
  },
  { type: 'CollisionSensor', DEF: 'sensor', collider: use('both'), ...fields },
];

async function lift(x: Driver): Promise<void> {
  await x.set('ball', 'position', [0, 20, 0]);
  await x.set('ball', 'linearVelocity', [0, 0, 0]);
  await x.advance(0.2);
}

const active = (x: Driver): Promise<boolean> => x.get('sensor', 'isActive');

export const collisionSensor: Fact[] = [
  {
    field: 'isActive',
    says: 'is TRUE while two members touch',
    scene: watched(),
    run: async (x) => {
      await x.advance(0.5);
      const first = await active(x);
      await lift(x);
      return [same('on the slab', first, true), same('in the air', await active(x), false)];
    },
  },
  {
    field: 'intersections',
    says: 'lists what touches, each once, and nothing when they have parted',
    scene: watched(),
    run: async (x) => {
      await x.advance(0.5);
      const first: string[] = await x.get('sensor', 'intersections');
      await lift(x);
      const second: string[] = await x.get('sensor', 'intersections');
      return [
        same('on the slab', [...first].sort(), ['ballShape', 'slabShape']),
        same('in the air', second, []),
      ];
    },
  },
  {
    field: 'contacts',
    says: 'has a Contact where a ball touches, and none when they have parted',
    scene: watched(),
    run: async (x) => {
      await x.advance(0.5);
      const first: Contact[] = await x.get('sensor', 'contacts');
      const bodies = first.map((contact) => [contact.body1, contact.body2].sort().join(' '));
      await lift(x);
      const second: Contact[] = await x.get('sensor', 'contacts');
      return [
        same('of both bodies', bodies, ['ball slab']),
        same('in the air', second.length === 0, true),
      ];
    },
  },
  {
    field: 'collider',
    says: 'the sensor sees the contacts of the collection it watches',
    scene: watched({ collider: use('others') }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await active(x);
      await x.set('sensor', 'collider', use('both'));
      await x.advance(0.1);
      return [same('of others', first, false), same('of both', await active(x), true)];
    },
  },
  {
    field: 'enabled',
    says: 'a disabled sensor senses nothing',
    scene: watched({ enabled: false }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await active(x);
      await x.set('sensor', 'enabled', true);
      await x.advance(0.1);
      return [holds('disabled it is not active', !first), same('enabled', await active(x), true)];
    },
  },
];
