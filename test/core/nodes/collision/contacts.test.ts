import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  below,
  box,
  claim,
  close,
  fact,
  height,
  position,
  velocity,
  world,
  type Body,
  type Node,
  overflow,
} from '../../helpers.js';
import { watched } from './watched.js';

async function falling(fields: Record<string, unknown> = {}) {
  const w = await world();
  const floor = addFloor(w);
  const ball = addBody(w, { position: [0, 1, 0], ...fields });
  return { w, floor, ball };
}

fact('in a compound body each part has the friction of its own collection', async () => {
  const w = await world();
  const slab = w.add('CollidableShape', { shape: [box(200, 1, 200)] });
  const [front, back] = [0, 1].map(() => w.add('CollidableShape', { shape: [box(0.2, 1, 1)] }));
  const at = (x: number, collidable: unknown) => ({
    type: 'CollidableOffset',
    translation: [x, 0, 0],
    collidable,
  });
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [slab] });
  const sledge = addBody(w, { position: [0, 0.5, 0], geometry: [at(3, front), at(-3, back)] });
  w.add('CollisionCollection', { collidables: [slab, front], frictionCoefficients: [0, 0] });
  w.add('CollisionCollection', { collidables: [slab, back], frictionCoefficients: [0.4, 0.4] });
  w.advance(0.2);
  sledge.event('linearVelocity', [2, 0, 0]);
  w.advance(0.5);
  // Half the weight on each end, and as much more on the front as braking at the ground tips it: N = ½ g - a h / 6.
  const a = (0.4 * 9.8 * 0.5) / (1 + 0.4 * (0.5 / 6));
  close(velocity(sledge)[0], 2 - 0.5 * a, 0.05, 'm/s');
});

fact(
  'with a collider a list changes parameters, and neither drops contacts nor adds any',
  async () => {
    const { w, stones, collection, sensor } = await watched(1);
    w.set('collider', collection);
    const [stone] = stones as [Body];
    sensor.on('contacts', () => w.settings.event('set_contacts', []));
    w.advance(0.5);
    close(height(stone), 0.5, 1e-3, 'm, an empty list');
    const stop = w.on('beforestep', () =>
      w.settings.event('set_contacts', [
        { type: 'Contact', body1: stone, position: [0, 5, 0], contactNormal: [0, 1, 0], depth: 1 },
      ]),
    );
    w.advance(0.5);
    close(height(stone), 0.5, 1e-3, 'm, a contact of page code');
    stop();
  },
);

fact(
  'a world without set_contacts, or with a sensor that watches nothing, collides as always',
  async () => {
    const { w, ball } = await falling();
    const sensor = w.add('CollisionSensor');
    sensor.on('contacts', (contacts) => w.settings.event('set_contacts', contacts));
    w.advance(2);
    close(height(ball), 0.5, 1e-3, 'm');
  },
);

fact('a contact copied by page code is the one it was copied from', async () => {
  const { w, stones, sensor } = await watched(1);
  const [stone] = stones as [Body];
  sensor.on('contacts', (contacts) =>
    w.settings.event(
      'set_contacts',
      (contacts as Node[]).map((contact) => ({
        type: 'Contact',
        position: contact.get('position'),
        contactNormal: contact.get('contactNormal'),
        depth: contact.get('depth'),
        geometry1: contact.get('geometry1'),
        geometry2: contact.get('geometry2'),
        frictionCoefficients: [0, 0],
      })),
    ),
  );
  w.advance(0.2);
  stone.event('linearVelocity', [1, 0, 0]);
  w.advance(1);
  close(velocity(stone), [1, 0, 0], 1e-3, 'm/s, without friction');
  close(height(stone), 0.5, 1e-3, 'm');
});

fact(
  'a stone on contacts of page code is braked by their friction and bounces by them',
  async () => {
    const w = await world();
    const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(2, 1, 2)] });
    let fields: Record<string, unknown> = {};
    w.on('beforestep', () => {
      const [x, y, z] = position(stone);
      const corners = [-1, 1].flatMap((i) => [-1, 1].map((k) => [x + i, 0, z + k]));
      w.settings.event(
        'set_contacts',
        y > 0.501
          ? []
          : corners.map((at) => ({
              type: 'Contact',
              body1: stone,
              position: at,
              depth: 0.5 - y,
              ...fields,
            })),
      );
    });
    w.advance(0.5);
    close(height(stone), 0.5, 2e-3, 'm');
    stone.event('linearVelocity', [2, 0, 0]);
    w.advance(0.2);
    close(velocity(stone)[0], 2 - 0.5 * 9.8 * 0.2, 0.05, 'm/s');
    fields = { bounce: 0.5 };
    stone.event('linearVelocity', [0, -2, 0]);
    w.step();
    close(velocity(stone)[1], 1, 0.1, 'm/s');
  },
);

fact('points that a list moved are written no more once Bullet has taken them back', async () => {
  const { w, stones, sensor } = await watched(1);
  claim(w, 'nan-state');
  const [stone] = stones as [Body];
  w.advance(0.2);
  const contacts = sensor.contacts;
  for (const contact of contacts) contact.set('position', [0.1, 0.005, 0.1]);
  w.settings.event('set_contacts', contacts);
  for (let i = 0; i < 4; i++) overflow(stone, [0, -1e38, 0]);
  const { ammo } = w.engine;
  const manifolds: number[] = [];
  w.bullet.eachPair((manifold) => manifolds.push(manifold));
  const read = (): number[] =>
    manifolds.flatMap((at) => [...ammo.HEAP32.subarray(at >> 2, (at >> 2) + 64)]);
  const park = stone.presence.park.bind(stone.presence);
  let taken: number[] | undefined;
  stone.presence.park = () => {
    park();
    taken = read();
  };
  w.step();
  assert.equal(w.bullet.manifoldCount, 0);
  assert.deepEqual(read(), taken);
});

fact('what a hit passed on is written into no point that Bullet has taken back', async () => {
  const w = await world();
  claim(w, 'nan-state');
  w.add('CollisionCollection', { collidables: '*', bounce: 0.5 });
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.505, 0], linearVelocity: [0, -2, 0] });
  w.step(1);
  ball.teleport([0, 0.501, 0]);
  ball.set('linearVelocity', [0, -3, 0]);
  const { ammo } = w.engine;
  let taken: number[] | undefined;
  const manifolds: number[] = [];
  const read = (): number[] =>
    manifolds.flatMap((at) => [...ammo.HEAP32.subarray(at >> 2, (at >> 2) + 256)]);
  const { bodies } = w;
  const readBodies = bodies.read.bind(bodies);
  let pushed = 0;
  bodies.read = () => {
    w.bullet.eachPair((pointer) => {
      manifolds.push(pointer);
      const manifold = ammo.wrapPointer(pointer, ammo.btPersistentManifold);
      for (let i = 0; i < manifold.getNumContacts(); i++)
        pushed += manifold.getContactPoint(i).getAppliedImpulse();
    });
    readBodies();
    ball.presence.park();
    taken = read();
  };
  w.step();
  assert.ok(pushed > 0, 'it was hit in that step');
  assert.equal(w.bullet.manifoldCount, 0);
  assert.deepEqual(read(), taken);
});

fact('worlds with different parameters step in turn, each by its own', async () => {
  const all = await Promise.all(
    [0, 0.5, 1].map(async (bounce) => {
      const w = await world({ accuracy: 'fine' });
      addFloor(w);
      const ball = addBody(w, { position: [0, 1.5, 0] });
      if (bounce > 0) w.add('CollisionCollection', { collidables: '*', bounce });
      return { w, ball, bounce, peak: 0 };
    }),
  );
  for (let t = 0; t < 1.1; t += 1 / 240)
    for (const one of all) {
      one.w.step();
      if (t > 0.5) one.peak = Math.max(one.peak, height(one.ball) - 0.5);
    }
  for (const { bounce, peak } of all) close(peak, bounce * bounce, 0.04, `m at ${bounce}`);
});

fact('a collection that says no more than the default costs nothing', async () => {
  const { w, ball } = await falling();
  const collection = w.add('CollisionCollection', { collidables: '*' });
  const writing = () => w.effects.find(({ name }) => name === 'contact surface')!.active;
  w.advance(1);
  assert.equal(writing(), false);
  collection.set('frictionCoefficients', [0, 0]);
  w.step();
  assert.equal(writing(), true);
  collection.unset('frictionCoefficients');
  w.step(2);
  assert.equal(writing(), false);
  ball.event('linearVelocity', [1, 0, 0]);
  w.advance(1);
  below(velocity(ball)[0], 0.8, 'm/s: it rubs again');
});

fact('softness is told with what it leaves out', async () => {
  const { w } = await falling();
  claim(w, 'approximated-field');
  w.add('CollisionCollection', {
    collidables: '*',
    appliedParameters: ['CONSTANT_FORCE'],
    softnessConstantForceMix: 0.05,
  });
  w.step();
  const [told] = w.problems;
  assert.equal(told!.attribute, 'softnessConstantForceMix');
});

fact('a Contact that page code made may go: what the others bear stays known', async () => {
  const { w, stones, sensor } = await watched(1);
  const [stone] = stones as [Body];
  stone.set('forces', [[2, 0, 0]]);
  w.advance(0.5);
  for (let i = 0; i < 60; i++) {
    for (const contact of sensor.contacts) {
      contact.set('appliedParameters', ['SLIP-1']);
      contact.set('slipCoefficients', [0.1, 0]);
    }
    w.settings.event('set_contacts', sensor.contacts);
    w.add('Contact', {}).remove();
    w.step();
  }
  // Slip is speed per force, which is that of the step before.
  close(velocity(stone), [0.2, 0, 0], 0.005, 'm/s');
});
