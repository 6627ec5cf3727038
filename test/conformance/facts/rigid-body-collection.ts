import { distance, FRAME, holds, LAG, near, ROUGH } from '../checks.js';
import type { Driver, Fact, NodeData } from '../fact.js';
import {
  body,
  box,
  collection,
  collidable,
  G,
  inertia,
  joint,
  slab,
  sphere,
  use,
  WEIGHTLESS,
} from '../scenes.js';
import { collectionRest } from './rigid-body-collection-rest.js';
import { setContacts } from './set-contacts.js';

const height = async (x: Driver, name: string): Promise<number> =>
  (await x.get(name, 'position'))[1];

const fall = (t: number): number => (G * t * t) / 2;

const pin = body('pin', { fixed: true, geometry: [] });

const members: Fact[] = [
  {
    field: 'bodies',
    says: 'a collection moves the bodies it lists, and those that are added while it runs',
    scene: [
      collection({ bodies: [body('ball')] }),
      collection({ DEF: 'up', gravity: [0, 2, 0], bodies: [body('balloon')] }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      const first = [await height(x, 'ball'), await height(x, 'balloon')];
      await x.set('world', 'bodies', [use('ball'), body('late', { position: [5, 0, 0] })]);
      await x.advance(0.5);
      const second = [await height(x, 'ball'), await height(x, 'late')];
      return [
        near('each by its own gravity', first, [-fall(0.5), 0.25], ROUGH * fall(0.5), 'm'),
        near('the first and the added one', second, [-fall(1), -fall(0.5)], ROUGH * fall(1), 'm'),
      ];
    },
  },
  {
    field: 'joints',
    says: 'the joints it lists hold their bodies, and so do those that are added while it runs',
    scene: [
      collection({
        bodies: [pin, body('held', { position: [3, 0, 0] }), body('free', { position: [6, 0, 0] })],
        joints: [joint('BallJoint', { body1: 'held', body2: 'pin' }, { anchorPoint: [3, 0, 0] })],
      }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      const first = [await height(x, 'held'), await height(x, 'free')];
      await x.set('free', 'position', [6, 0, 0]);
      await x.set('free', 'linearVelocity', [0, 0, 0]);
      const added = joint('BallJoint', { body1: 'free', body2: 'pin' }, { anchorPoint: [6, 0, 0] });
      await x.set('world', 'joints', [use('joint'), { ...added, DEF: 'second' }]);
      await x.advance(0.5);
      const second = [await height(x, 'held'), await height(x, 'free')];
      return [
        near('held and free', first, [0, -fall(0.5)], 4.9 * LAG, 'm'),
        // The way that a frame's fall takes before the joint is there.
        near('both held', second, [0, 0], 0.01, 'm'),
      ];
    },
  },
  {
    field: 'collider',
    says: 'exactly what it lists collides: members rest on a member, the others fall through',
    tells: ['not-in-collider'],
    scene: [
      collection({
        collider: {
          type: 'CollisionCollection',
          collidables: [use('slabShape'), collidable(box(1), { DEF: 'member' })],
        },
        bodies: [
          slab(0),
          body('in', { position: [0, 0.5, 0], geometry: [use('member')] }),
          body('out', { position: [4, 0.5, 0], geometry: [collidable(box(1))] }),
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      return [
        near('a member', await height(x, 'in'), 0.5, 0.01, 'm'),
        near('none', await height(x, 'out'), 0.5 - fall(0.5), 4.9 * LAG, 'm'),
      ];
    },
  },
  {
    field: 'enabled',
    says: 'FALSE stops the simulation; TRUE lets it go on from there',
    scene: [collection({ bodies: [body('ball')] })],
    run: async (x) => {
      await x.advance(0.5);
      await x.set('world', 'enabled', false);
      const at = await height(x, 'ball');
      await x.advance(1);
      const still = await height(x, 'ball');
      await x.set('world', 'enabled', true);
      await x.advance(0.5);
      return [
        near('way while disabled', at - still, 0, 4.9 * LAG, 'm'),
        near('going on', await height(x, 'ball'), -fall(1), ROUGH * fall(1), 'm'),
      ];
    },
  },
  {
    field: 'gravity',
    says: 'speeds every body up by g t, from the start and from an event on',
    scene: [collection({ gravity: [0, -4, 0], bodies: [body('ball', { mass: 3 })] })],
    run: async (x) => {
      await x.advance(0.5);
      const first = await x.get('ball', 'linearVelocity');
      await x.set('world', 'gravity', [3, 0, 0]);
      await x.advance(0.5);
      return [
        near('down', first, [0, -2, 0], 4 * LAG, 'm/s'),
        near('sideways', await x.get('ball', 'linearVelocity'), [1.5, -2, 0], 4 * LAG, 'm/s'),
      ];
    },
  },
];

/** A row of balls on ball joints that holds a heavy one at its end. */
function chain(name: string, fields: Record<string, unknown>): NodeData {
  const links = Array.from({ length: 6 }, (_, i) => `${name}${i}`);
  return collection({
    DEF: name,
    ...fields,
    bodies: [
      { ...pin, DEF: `${name}Pin` },
      ...links.map((link, i) =>
        body(link, {
          position: [i, 0, 0],
          mass: i === 5 ? 20 : 0.5,
          inertia: inertia(i === 5 ? 0.32 : 0.008),
          geometry: [collidable(sphere(0.2))],
        }),
      ),
    ],
    joints: links.map((link, i) => ({
      ...joint('BallJoint', { body1: link, body2: i === 0 ? `${name}Pin` : links[i - 1]! }),
      DEF: `${name}Joint${i}`,
      anchorPoint: [i - 0.5, 0, 0],
    })),
  });
}

/** The greatest distance of two neighbours, beyond the metre they are made for, in 0.5 s of each chain. */
async function stretches(x: Driver, names: string[]): Promise<number[]> {
  const worst = names.map(() => 0);
  for (let t = 0; t < 10; t++) {
    await x.advance(0.05);
    for (const [n, name] of names.entries()) {
      const places: number[][] = [];
      for (let i = 0; i < 6; i++) places.push(await x.get(`${name}${i}`, 'position'));
      for (let i = 1; i < 6; i++)
        worst[n] = Math.max(worst[n]!, distance(places[i]!, places[i - 1]!) - 1);
    }
  }
  return worst;
}

/** A weightless ball on a joint, torn 0.1 m from its anchor: what is left after a frame. */
const torn = (DEF: string, errorCorrection: number): NodeData =>
  collection({
    ...WEIGHTLESS,
    DEF,
    errorCorrection,
    bodies: [{ ...pin, DEF: `${DEF}Pin` }, body(`${DEF}Ball`)],
    joints: [
      { ...joint('BallJoint', { body1: `${DEF}Ball`, body2: `${DEF}Pin` }), DEF: `${DEF}Joint` },
    ],
  });

const solver: Fact[] = [
  {
    field: 'iterations',
    says: 'a hundred hold a loaded chain at least twice as well as one, unless one holds it to a millimetre',
    scene: [
      chain('one', { iterations: 1 }),
      chain('many', { iterations: 100 }),
      chain('edited', { iterations: 1 }),
    ],
    run: async (x) => {
      await x.set('edited', 'iterations', 100);
      const [one, many, edited] = await stretches(x, ['one', 'many', 'edited']);
      const bound = Math.max(one! / 2, 1e-3);
      return [
        near('stretch at 100', many!, 0, bound, 'm'),
        near('stretch at 100 by an event', edited!, 0, bound, 'm'),
      ];
    },
  },
  {
    field: 'errorCorrection',
    says: 'is the share of a torn joint that a frame repairs',
    open: 'per frame of 1/60 s, whatever the step of the browser',
    scene: [torn('little', 0.2), torn('half', 0.5)],
    run: async (x) => {
      const gaps = async () => {
        for (const name of ['littleBall', 'halfBall']) await x.set(name, 'position', [0.1, 0, 0]);
        await x.advance(FRAME);
        return Promise.all(
          ['littleBall', 'halfBall'].map(async (name) => (await x.get(name, 'position'))[0]),
        );
      };
      await x.advance(FRAME);
      const first = await gaps();
      await x.set('little', 'errorCorrection', 0.7);
      for (const name of ['littleBall', 'halfBall']) {
        await x.set(name, 'position', [0, 0, 0]);
        await x.set(name, 'linearVelocity', [0, 0, 0]);
      }
      await x.advance(0.5);
      const [edited] = await gaps();
      return [
        near('left at 0.2 and 0.5', first, [0.08, 0.05], 0.002, 'm'),
        near('left at 0.7', edited!, 0.03, 0.002, 'm'),
      ];
    },
  },
  {
    field: 'constantForceMix',
    says: 'makes joints soft: a weight sags twice as deep at twice the softness',
    scene: [
      collection({
        errorCorrection: 0.5,
        constantForceMix: 0.0005,
        bodies: [pin, body('ball', { mass: 2, inertia: inertia(0.2) })],
        joints: [joint('BallJoint', { body1: 'ball', body2: 'pin' })],
      }),
    ],
    run: async (x) => {
      await x.advance(2);
      const once = -(await height(x, 'ball'));
      await x.set('world', 'constantForceMix', 0.001);
      await x.advance(2);
      const twice = -(await height(x, 'ball'));
      return [
        holds('it sags by more than 0.1 mm', once > 1e-4),
        near('twice the softness, depth by depth', twice / once, 2, 0.1, ''),
      ];
    },
  },
  {
    field: 'contactSurfaceThickness',
    says: 'is how deep a box at rest sinks in',
    scene: [
      collection({
        contactSurfaceThickness: 0.02,
        bodies: [slab(0), body('stone', { position: [0, 0.5, 0], geometry: [collidable(box(1))] })],
      }),
    ],
    run: async (x) => {
      await x.advance(2);
      const first = await height(x, 'stone');
      await x.set('world', 'contactSurfaceThickness', 0.06);
      await x.advance(2);
      return [
        near('0.02 m', 0.5 - first, 0.02, 0.003, 'm'),
        near('0.06 m', 0.5 - (await height(x, 'stone')), 0.06, 0.003, 'm'),
      ];
    },
  },
  {
    field: 'maxCorrectionSpeed',
    says: 'bodies that overlap part at this speed, and faster where it is -1',
    tells: ['initial-overlap', 'initial-overlap'],
    scene: ['slow', 'fast'].map((DEF) =>
      collection({
        ...WEIGHTLESS,
        DEF,
        maxCorrectionSpeed: DEF === 'slow' ? 0.5 : -1,
        bodies: [
          body(`${DEF}Wall`, { fixed: true, geometry: [collidable(box(1))] }),
          body(`${DEF}Stone`, { position: [0.6, 0, 0], geometry: [collidable(box(1))] }),
        ],
      }),
    ),
    run: async (x) => {
      await x.advance(0.4);
      const way = async (name: string) => (await x.get(name, 'position'))[0] - 0.6;
      return [
        near('at 0.5 m/s, way in 0.4 s', await way('slowStone'), 0.2, 0.5 * LAG, 'm'),
        holds('unlimited it is out by then', (await way('fastStone')) > 0.38),
      ];
    },
  },
];

export const rigidBodyCollection: Fact[] = [...members, setContacts, ...solver, ...collectionRest];
