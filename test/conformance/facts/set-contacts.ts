import { FRAME, LAG, near, ROUGH } from '../checks.js';
import type { Driver, Fact, NodeData } from '../fact.js';
import { body, box, collection, collidable, G, slab, use } from '../scenes.js';

type Contact = Record<string, any>;

const REFERENCES = ['body1', 'body2', 'geometry1', 'geometry2'];

/** A Contact that was read, as a node that can be sent. */
function asNode({ metadata: _, ...contact }: Contact): NodeData {
  const names = REFERENCES.filter((field) => contact[field]);
  const references = names.map((field) => [field, use(contact[field])]);
  const values = Object.entries(contact).filter(([field]) => !REFERENCES.includes(field));
  return { type: 'Contact', ...Object.fromEntries([...values, ...references]) };
}

/** Page code between the sensor and the collection, frame by frame. */
async function handOn(
  x: Driver,
  seconds: number,
  change: (contacts: Contact[]) => Contact[],
): Promise<void> {
  for (let i = 0; i < Math.round(seconds / FRAME); i++) {
    const contacts = change(await x.get('sensor', 'contacts'));
    await x.set('world', 'set_contacts', contacts.map(asNode));
    await x.advance(FRAME);
  }
}

const smooth = (contact: Contact): Contact => ({
  ...contact,
  appliedParameters: ['FRICTION_COEFFICIENT-2'],
  frictionCoefficients: [0, 0],
});

/** Of friction, m/s². */
const DECELERATION = 0.1 * G;

export const setContacts: Fact = {
  field: 'set_contacts',
  says: 'takes contacts as page code changed them: without friction a box slides on, left out they let it fall',
  open: 'the list stands for all that the sensor reported, for one frame',
  frameByFrame: true,
  scene: [
    collection({
      bodies: [
        slab(0),
        body('stone', {
          position: [0, 0.5, 0],
          linearVelocity: [0.6, 0, 0],
          geometry: [collidable(box(2, 1, 2), { DEF: 'stoneShape' })],
        }),
      ],
    }),
    {
      type: 'CollisionSensor',
      DEF: 'sensor',
      collider: {
        type: 'CollisionCollection',
        appliedParameters: ['FRICTION_COEFFICIENT-2'],
        frictionCoefficients: [0.1, 0.1],
        collidables: [use('slabShape'), use('stoneShape')],
      },
    },
  ],
  run: async (x) => {
    await handOn(x, 0.5, (contacts) => contacts.map(smooth));
    const slid = await x.get('stone', 'linearVelocity');
    await handOn(x, 0.25, (contacts) => contacts);
    const slowed = await x.get('stone', 'linearVelocity');
    const [, from] = await x.get('stone', 'position');
    await handOn(x, 0.5, () => []);
    const [, to] = await x.get('stone', 'position');
    return [
      near('without friction, after 0.5 s', slid[0], 0.6, DECELERATION * LAG, 'm/s'),
      near(
        'handed through, 0.25 s on',
        slowed[0],
        0.6 - DECELERATION * 0.25,
        DECELERATION * LAG,
        'm/s',
      ),
      near('left out, fall in 0.5 s', from - to, G / 8, (G / 8) * ROUGH, 'm'),
    ];
  },
};
