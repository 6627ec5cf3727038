import { FRAME, near, same } from '../checks.js';
import type { Check, Driver, Fact, NodeData } from '../fact.js';
import { body, box, collection, collidable, G, slab, use } from '../scenes.js';

type Contact = Record<string, any>;

const REFERENCES = ['body1', 'body2', 'geometry1', 'geometry2'];

/** A flat stone on a slab, watched by a sensor. There is no collider: page code may hand contacts on. */
const scene = (parameters: Record<string, unknown> = {}): NodeData[] => [
  collection({
    bodies: [
      slab(0),
      body('stone', {
        position: [0, 0.5, 0],
        geometry: [collidable(box(2, 1, 2), { DEF: 'stoneShape' })],
      }),
    ],
  }),
  {
    type: 'CollisionSensor',
    DEF: 'sensor',
    collider: {
      type: 'CollisionCollection',
      DEF: 'collection',
      collidables: [use('slabShape'), use('stoneShape')],
      ...parameters,
    },
  },
];

/** A Contact that was read, as a node that can be sent. */
function asNode(contact: Contact): NodeData {
  const entries = Object.entries(contact).filter(([, value]) => value !== null);
  const node = entries.map(([field, value]) => [
    field,
    REFERENCES.includes(field) ? use(value) : value,
  ]);
  return { type: 'Contact', ...Object.fromEntries(node) };
}

const contacts = (x: Driver): Promise<Contact[]> => x.get('sensor', 'contacts');
const velocity = (x: Driver): Promise<number[]> => x.get('stone', 'linearVelocity');

/** Hands every contact on with other values, frame by frame. */
async function handOn(
  x: Driver,
  frames: number,
  change: Contact | ((contact: Contact) => Contact),
): Promise<void> {
  for (let i = 0; i < frames; i++) {
    const list = (await contacts(x)).map((contact) => ({
      ...contact,
      ...(typeof change === 'function' ? change(contact) : change),
    }));
    await x.set('world', 'set_contacts', list.map(asNode));
    await x.advance(FRAME);
  }
}

const OPEN = 'the list stands for all that the sensor reported, for one frame';

/** What a sensor fills in. */
const found = (
  field: string,
  says: string,
  check: (contacts: Contact[]) => Check[],
  parameters: Record<string, unknown> = {},
): Fact => ({
  field,
  says,
  scene: scene(parameters),
  run: async (x) => {
    await x.advance(0.5);
    return check(await contacts(x));
  },
});

/** What page code changes. */
const changed = (
  field: string,
  says: string,
  run: Fact['run'],
  more: Partial<Fact> & { parameters?: Record<string, unknown> } = {},
): Fact => {
  const { parameters, ...fact } = more;
  return { field, says, open: OPEN, frameByFrame: true, scene: scene(parameters), run, ...fact };
};

export const contact: Fact[] = [
  changed(
    'metadata',
    'says nothing about motion: the stone rests on contacts with it',
    async (x) => {
      await x.advance(0.5);
      await handOn(x, 10, { metadata: { type: 'MetadataString', name: 'note', value: ['seen'] } });
      return [near('height', (await x.get('stone', 'position'))[1], 0.5, 0.002, 'm')];
    },
  ),
  found('body1', 'is the body that the normal points into: the stone', ([first]) => [
    same('body1', first!.body1, 'stone'),
  ]),
  found('body2', 'is the other body: the slab', ([first]) => [same('body2', first!.body2, 'slab')]),
  found('geometry1', 'is the collidable of body1', ([first]) => [
    same('geometry1', first!.geometry1, 'stoneShape'),
  ]),
  found('geometry2', 'is the collidable of body2', ([first]) => [
    same('geometry2', first!.geometry2, 'slabShape'),
  ]),
  found('position', 'is a corner of the stone', (all) => [
    near('corners', all.length, 4, 0, ''),
    near(
      'distance of each from the middle',
      all.map(({ position: [x, , z] }) => Math.hypot(x, z)),
      [1, 1, 1, 1].map(() => Math.SQRT2),
      0.02,
      'm',
    ),
  ]),
  found('contactNormal', 'is the unit normal out of the slab', (all) =>
    all.map(({ contactNormal }) => near('normal', contactNormal, [0, 1, 0], 1e-3, '')),
  ),
  found('depth', 'is next to nothing where a stone rests', (all) =>
    all.map(({ depth }) => near('depth', depth, 0, 0.002, 'm')),
  ),
  changed('depth', 'a greater one is pushed out in the frame', async (x) => {
    await x.advance(0.5);
    const [, before] = await x.get('stone', 'position');
    await handOn(x, 1, { depth: 0.1 });
    const [, after] = await x.get('stone', 'position');
    return [near('lift', after - before, 0.08, 0.01, 'm')];
  }),
  changed(
    'appliedParameters',
    'a token that page code adds switches its parameter on',
    async (x) => {
      await x.advance(0.5);
      await handOn(x, 40, { appliedParameters: ['SPEED-1'] });
      const first = await velocity(x);
      await x.advance(0.5);
      return [
        near('with SPEED-1', first, [1, 0, 0], 0.02, 'm/s'),
        near('without', await velocity(x), [0, 0, 0], 0.02, 'm/s'),
      ];
    },
    { parameters: { surfaceSpeed: [1, 0] } },
  ),
  changed('bounce', 'a stone that is thrown down comes up by this share', async (x) => {
    await x.advance(0.5);
    await x.set('stone', 'linearVelocity', [0, -2, 0]);
    await handOn(x, 1, { bounce: 0.5, minBounceSpeed: 1 });
    return [near('speed', (await velocity(x))[1]!, 1, 0.2, 'm/s')];
  }),
  changed('minBounceSpeed', 'an approach below it does not bounce', async (x) => {
    await x.advance(0.5);
    await x.set('stone', 'linearVelocity', [0, -2, 0]);
    await handOn(x, 1, { bounce: 0.5, minBounceSpeed: 3 });
    return [near('speed', (await velocity(x))[1]!, 0, 0.1, 'm/s')];
  }),
  changed('frictionCoefficients', 'a stone on smooth contacts slides on', async (x) => {
    await x.advance(0.5);
    await x.set('stone', 'linearVelocity', [1, 0, 0]);
    await handOn(x, 20, { frictionCoefficients: [0, 0] });
    const first = (await velocity(x))[0]!;
    await handOn(x, 15, { frictionCoefficients: [0.1, 0.1] });
    return [
      near('at 0', first, 1, 0.01, 'm/s'),
      near('at 0.1, 0.25 s', (await velocity(x))[0]!, 1 - 0.1 * G * 0.25, 0.04, 'm/s'),
    ];
  }),
  changed('frictionDirection', 'with USER_FRICTION a belt carries along it', async (x) => {
    await x.advance(0.5);
    await handOn(x, 40, {
      appliedParameters: ['USER_FRICTION', 'SPEED-1'],
      surfaceSpeed: [1, 0],
      frictionDirection: [0, 0, 1],
    });
    return [near('speed', await velocity(x), [0, 0, 1], 0.02, 'm/s')];
  }),
  changed('surfaceSpeed', 'carries body1 along body2', async (x) => {
    await x.advance(0.5);
    await handOn(x, 40, { appliedParameters: ['SPEED-1', 'SPEED-2'], surfaceSpeed: [-1, 0.5] });
    return [near('speed', await velocity(x), [-1, 0, 0.5], 0.02, 'm/s')];
  }),
  changed('slipCoefficients', 'the stone slides at factor × force', async (x) => {
    await x.set('stone', 'forces', [[2, 0, 1]]);
    await x.advance(0.5);
    await handOn(x, 60, { appliedParameters: ['SLIP-1', 'SLIP-2'], slipCoefficients: [0.1, 0] });
    return [near('speed', await velocity(x), [0.2, 0, 0], 0.005, 'm/s')];
  }),
  changed(
    'softnessConstantForceMix',
    'the stone sinks in by F · softness / (60 · error correction)',
    async (x) => {
      await x.advance(0.5);
      await handOn(x, 120, {
        appliedParameters: ['CONSTANT_FORCE', 'ERROR_REDUCTION'],
        softnessConstantForceMix: 0.1,
      });
      const [, y] = await x.get('stone', 'position');
      return [near('depth', 0.5 - y, (G * 0.1) / 48, 0.001, 'm')];
    },
  ),
  changed(
    'softnessErrorCorrection',
    'is the share of an overlap that goes in a frame',
    async (x) => {
      await x.advance(0.1);
      await x.set('stone', 'useGlobalGravity', false);
      await x.set('stone', 'position', [0, 0.4, 0]);
      await x.advance(FRAME);
      const before = 0.5 - (await x.get('stone', 'position'))[1];
      await handOn(x, 2, { appliedParameters: ['ERROR_REDUCTION'], softnessErrorCorrection: 0.3 });
      const after = 0.5 - (await x.get('stone', 'position'))[1];
      return [near('left after two frames', after / before, 0.49, 0.03, '')];
    },
    { parameters: { appliedParameters: ['ERROR_REDUCTION'], softnessErrorCorrection: 0.1 } },
  ),
];
