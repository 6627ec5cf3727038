import assert from 'node:assert/strict';
import { nodeTypes } from '../../../../../physics-core/inside.js';
import {
  addBody,
  below,
  box,
  claim,
  close,
  height,
  velocity,
  world,
  type Body,
  type Node,
} from '../../../helpers.js';
import type { Row } from '../row.js';

type Edit = (contacts: Node[]) => Node[] | undefined;

interface Scene {
  w: Awaited<ReturnType<typeof world>>;
  slab: Node;
  flat: Node;
  ground: Body;
  stone: Body;
  collection: Node;
  sensor: Node;
  /** What becomes of each step's contacts on their way to set_contacts. */
  edit: (edit: Edit | undefined) => void;
}

/** A flat stone of 1 kg on a slab, watched by a sensor whose contacts go through page code to set_contacts. */
export async function scripted(fields: Record<string, unknown> = {}): Promise<Scene> {
  const w = await world();
  const slab = w.add('CollidableShape', { shape: [box(100, 1, 100)] });
  const flat = w.add('CollidableShape', { shape: [box(2, 1, 2)] });
  const ground = addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [slab] });
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: [flat] });
  const collection = w.add('CollisionCollection', { collidables: [slab, flat], ...fields });
  const sensor = w.add('CollisionSensor', { collider: collection });
  let editing: Edit | undefined;
  sensor.on('contacts', (contacts) => {
    const list = editing?.(contacts as Node[]);
    if (list) w.settings.event('set_contacts', list);
  });
  w.advance(0.5);
  return {
    w,
    slab,
    flat,
    ground,
    stone,
    collection,
    sensor,
    edit: (edit) => {
      editing = edit;
      // What is sent after this step acts in the next.
      w.step();
    },
  };
}

const setting =
  (fields: Record<string, unknown>): Edit =>
  (contacts) => {
    for (const contact of contacts)
      for (const [name, value] of Object.entries(fields)) contact.set(name, value);
    return contacts;
  };

/** Throws the stone along x. */
function kick({ stone }: Scene, speed = 1): void {
  stone.event('position', [0, 0.5, 0]);
  stone.event('linearVelocity', [speed, 0, 0]);
}

const first = ({ sensor }: Scene): Node => (sensor.get('contacts') as Node[])[0]!;

/** A field that the sensor fills in. */
const found = (field: string, fact: string, check: (contact: Node, scene: Scene) => void): Row => ({
  field,
  fact,
  run: async () => {
    const scene = await scripted();
    check(first(scene), scene);
    const authored = scene.w.add('Contact');
    assert.deepEqual(authored.get(field), nodeTypes.Contact!.fields[field]!.default);
  },
});

export const contactRows: Row[] = [
  {
    field: 'appliedParameters',
    effect: 'given contacts',
    fact: 'what page code applies acts in the next step, and no longer',
    run: async () => {
      const scene = await scripted({ surfaceSpeed: [1, 0] });
      assert.deepEqual(first(scene).get('appliedParameters'), ['BOUNCE']);
      scene.edit(setting({ appliedParameters: ['SPEED_1'] }));
      scene.w.advance(1);
      close(velocity(scene.stone), [1, 0, 0], 1e-3, 'm/s');
      scene.edit(undefined);
      scene.w.advance(1);
      close(velocity(scene.stone), [0, 0, 0], 1e-3, 'm/s, no list');
    },
  },
  {
    field: 'contactNormal',
    effect: 'given contacts',
    fact: "a point that page code turns is Bullet's own again after the step",
    run: async () => {
      const scene = await scripted();
      scene.edit(setting({ contactNormal: [1, 0, 0] }));
      scene.edit(undefined);
      close(first(scene).get('contactNormal') as number[], [0, 1, 0], 1e-4, 'out of the slab');
    },
  },
  found('body1', 'is the body that moves', (c, { stone }) => assert.equal(c.get('body1'), stone)),
  found('body2', 'is the body it lies on', (c, { ground }) => assert.equal(c.get('body2'), ground)),
  found('geometry1', 'is the collidable of body1', (c, { flat }) =>
    assert.equal(c.get('geometry1'), flat),
  ),
  found('geometry2', 'is the collidable of body2', (c, { slab }) =>
    assert.equal(c.get('geometry2'), slab),
  ),
  {
    field: 'bounce',
    fact: 'a landing stone bounces by the contact as page code changed it',
    run: async () => {
      const scene = await scripted();
      const contact = first(scene);
      assert.equal(contact.get('bounce'), 0);
      contact.set('bounce', 3);
      assert.equal(contact.get('bounce'), 1);
      claim(scene.w, 'out-of-range');
      assert.equal(scene.collection.get('bounce'), 0);
      scene.edit(setting({ bounce: 0.5, minBounceSpeed: 0.5 }));
      // A push down on the resting stone comes back by half, and weight has a step to act on it.
      scene.stone.event('linearVelocity', [0, -2, 0]);
      scene.w.step();
      close(velocity(scene.stone)[1], 1 - 9.8 / 120, 0.01, 'm/s');
    },
  },
  {
    field: 'minBounceSpeed',
    fact: 'an approach below it does not bounce; its default is 0, and the collection says its own',
    run: async () => {
      const scene = await scripted();
      assert.equal(first(scene).get('minBounceSpeed'), 0.1);
      assert.equal(scene.w.add('Contact').get('minBounceSpeed'), 0);
      scene.edit(setting({ bounce: 0.5, minBounceSpeed: 3 }));
      scene.stone.event('linearVelocity', [0, -2, 0]);
      scene.w.step();
      close(velocity(scene.stone)[1], 0, 0.05, 'm/s, too slow');
    },
  },
  {
    field: 'contactNormal',
    effect: 'given contacts',
    fact: 'points into body1; turned by page code the push turns with it, for that step only',
    run: async () => {
      const scene = await scripted();
      close(first(scene).get('contactNormal') as number[], [0, 1, 0], 1e-6, 'up');
      scene.edit(setting({ contactNormal: [0.6, 0.8, 0], frictionCoefficients: [0, 0] }));
      scene.w.step();
      // The stone may move across the normal only: that is g · 0.6 down a slope of 0.8 : 0.6.
      const v = velocity(scene.stone);
      close(v[0] * 0.6 + v[1] * 0.8, 0, 1e-3, 'm/s along the normal');
      close(v[0], 9.8 * 0.6 * 0.8 * scene.w.timeStep, 0.02, 'm/s down the slope');
      scene.edit(undefined);
      scene.w.advance(1);
      close(first(scene).get('contactNormal') as number[], [0, 1, 0], 1e-6, 'up again');
      close(velocity(scene.stone), [0, 0, 0], 1e-3, 'm/s');
    },
  },
  {
    field: 'depth',
    fact: 'is the overlap; a greater one from page code is pushed out, without velocity',
    run: async () => {
      const scene = await scripted();
      close(first(scene).get('depth') as number, 1e-4, 1e-4, 'm, at rest');
      const before = height(scene.stone);
      scene.edit(setting({ depth: 0.05 }));
      scene.w.step();
      close(height(scene.stone) - before, 0.8 * 0.05, 5e-3, 'm, four fifths in the step');
      below(velocity(scene.stone)[1], 0.1, 'm/s');
    },
  },
  {
    field: 'position',
    fact: 'is where they touch; put on one side by page code the push tips the stone over',
    run: async () => {
      const scene = await scripted();
      const corners = (scene.sensor.get('contacts') as Node[]).map((c) => c.get('position'));
      assert.equal(corners.length, 4);
      for (const [x, y, z] of corners as number[][])
        close([Math.abs(x!), y!, Math.abs(z!)], [1, 0, 1], 2e-3, 'm');
      scene.edit((contacts) => {
        for (const contact of contacts) {
          const [, y, z] = contact.get('position') as number[];
          contact.set('position', [0.9, y, z]);
        }
        return contacts;
      });
      scene.w.step(2);
      const turn = scene.stone.get('angularVelocity') as number[];
      // Held at x = 0.9 alone it turns about z: α = m g x / (I + m (x² + h²)), I = (2² + 1²) / 12.
      const rate = (9.8 * 0.9) / (5 / 12 + 0.81 + 0.25);
      close(turn[2]!, 2 * rate * scene.w.timeStep, 0.05, 'rad/s');
    },
  },
  {
    field: 'frictionCoefficients',
    fact: 'a stone on contacts that page code made smooth slides on',
    run: async () => {
      const scene = await scripted();
      assert.deepEqual(first(scene).get('frictionCoefficients'), [0.5, 0.5]);
      scene.edit(setting({ frictionCoefficients: [0, 0] }));
      kick(scene);
      scene.w.advance(1);
      close(velocity(scene.stone), [1, 0, 0], 1e-3, 'm/s');
      scene.edit(setting({ frictionCoefficients: [0.1, 0] }));
      scene.w.advance(0.5);
      close(velocity(scene.stone)[0], 1 - 0.1 * 9.8 * 0.5, 0.02, 'm/s');
    },
  },
  {
    field: 'frictionDirection',
    fact: 'with USER_FRICTION it is friction direction 1: a belt carries along it',
    run: async () => {
      const scene = await scripted();
      close(first(scene).get('frictionDirection') as number[], [1, 0, 0], 1e-6, 'x by itself');
      const belt = { surfaceSpeed: [1, 0], frictionDirection: [0, 0, 1] };
      scene.edit(setting({ ...belt, appliedParameters: ['SPEED-1'] }));
      scene.w.advance(1);
      close(velocity(scene.stone), [1, 0, 0], 1e-3, 'm/s without the token');
      scene.edit(setting({ ...belt, appliedParameters: ['SPEED-1', 'USER_FRICTION'] }));
      scene.w.advance(1.5);
      close(velocity(scene.stone), [0, 0, 1], 1e-3, 'm/s');
    },
  },
  {
    field: 'slipCoefficients',
    fact: 'the stone slides at factor × force',
    run: async () => {
      const scene = await scripted({ slipFactors: [0.3, 0.4] });
      assert.deepEqual(first(scene).get('slipCoefficients'), [0.3, 0.4]);
      scene.edit(setting({ slipCoefficients: [0.05, 0], appliedParameters: ['SLIP-1', 'SLIP-2'] }));
      scene.stone.set('forces', [[2, 0, 1]]);
      scene.w.advance(2);
      close(velocity(scene.stone), [0.1, 0, 0], 1e-3, 'm/s');
    },
  },
  {
    field: 'softnessConstantForceMix',
    fact: 'the stone sinks in by F · softness / (60 · error correction)',
    run: async () => {
      const scene = await scripted();
      assert.equal(first(scene).get('softnessConstantForceMix'), 0.0001);
      const tokens = ['CONSTANT_FORCE', 'ERROR_REDUCTION'];
      scene.edit(setting({ softnessConstantForceMix: 0.05, appliedParameters: tokens }));
      scene.w.advance(4);
      close(0.5 - height(scene.stone) - 1e-4, (9.8 * 0.05) / 60 / 0.8, 2e-4, 'm');
    },
  },
  {
    field: 'softnessErrorCorrection',
    fact: 'the share of the overlap that goes in a frame',
    run: async () => {
      const scene = await scripted();
      scene.w.set('gravity', [0, 0, 0]);
      scene.edit(setting({ softnessErrorCorrection: 0.2, appliedParameters: ['ERROR_REDUCTION'] }));
      scene.stone.event('position', [0, 0.3, 0]);
      scene.w.step();
      const before = 0.5 - height(scene.stone);
      scene.w.step(2);
      close((0.5 - height(scene.stone)) / before, 0.8, 0.01, 'left after a frame');
    },
  },
  {
    field: 'surfaceSpeed',
    fact: 'body1 is carried along body2',
    run: async () => {
      const scene = await scripted();
      scene.edit(setting({ surfaceSpeed: [0.5, -1], appliedParameters: ['SPEED-1', 'SPEED-2'] }));
      scene.w.advance(2);
      close(velocity(scene.stone), [0.5, 0, -1], 1e-3, 'm/s');
    },
  },
];
