import assert from 'node:assert/strict';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  below,
  box,
  claim,
  close,
  height,
  position,
  sphere,
  velocity,
  way,
  world,
  type Body,
  type Node,
  type Sensor,
} from '../../../helpers.js';
import { surfaceRows } from './surfaces.js';
import type { Row } from '../row.js';

/** A slab and a ball above it, each of one named collidable, and a collection of both. */
async function pair(fields: Record<string, unknown> = {}, ball: Record<string, unknown> = {}) {
  const w = await world({ accuracy: 'fine' });
  const slab = w.add('CollidableShape', { shape: [box(100, 1, 100)] });
  const round = w.add('CollidableShape', { shape: [ball.shape ?? sphere(0.5)] });
  const { shape: _, ...others } = ball;
  const ground = addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [slab] });
  const body = addBody(w, { position: [0, 1.5, 0], geometry: [round], ...others });
  const collection = w.add('CollisionCollection', { collidables: [slab, round], ...fields });
  return { w, slab, round, ground, body, collection };
}

/** Height of the next peak above the rest height of a ball dropped from a metre above it. */
function peak(w: World, ball: Body): number {
  ball.event('position', [0, 1.5, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.step();
  while (velocity(ball)[1] <= 0 && height(ball) > 0.501) w.step();
  let highest = 0;
  for (let t = 0; t < 0.6; t += w.timeStep) {
    w.step();
    highest = Math.max(highest, height(ball) - 0.5);
  }
  return highest;
}

/** Way that a box thrown flat at 4 m/s slides until it stops. */
function slide(w: World, stone: Body, direction: [number, number]): number {
  stone.event('position', [0, 0.5, 0]);
  stone.event('orientation', [0, 0, 1, 0]);
  stone.event('angularVelocity', [0, 0, 0]);
  stone.event('linearVelocity', [4 * direction[0], 0, 4 * direction[1]]);
  w.advance(4);
  const [x, , z] = position(stone);
  return Math.hypot(x, z);
}

const basicRows: Row[] = [
  {
    field: 'collidables',
    fact: 'a member that leaves the collider falls through; * takes everything in',
    run: async () => {
      const { w, slab, round, body, collection } = await pair();
      claim(w, 'not-in-collider');
      w.set('collider', collection);
      w.advance(1);
      close(height(body), 0.5, 1e-3, 'm, both listed');
      collection.set('collidables', [slab]);
      w.advance(0.5);
      close(height(body), 0.5 - way(9.8, 0.5), 2e-3, 'm, left out');
      collection.set('collidables', '*');
      body.event('position', [0, 1, 0]);
      body.event('linearVelocity', [0, 0, 0]);
      w.advance(1);
      close(height(body), 0.5, 1e-3, 'm, everything');
      collection.set('collidables', [round]);
      w.advance(0.5);
      close(height(body), 0.5 - way(9.8, 0.5), 2e-3, 'm, the slab left out');
    },
  },
  {
    field: 'enabled',
    fact: 'members of a disabled collection pass through each other until it is enabled again',
    run: async () => {
      const { w, body, collection } = await pair();
      w.advance(1);
      collection.set('enabled', false);
      w.advance(0.5);
      close(height(body), 0.5 - way(9.8, 0.5), 2e-3, 'm, disabled');
      collection.unset('enabled');
      body.event('position', [0, 1, 0]);
      body.event('linearVelocity', [0, 0, 0]);
      w.advance(1);
      close(height(body), 0.5, 1e-3, 'm, enabled again');
    },
  },
  {
    field: 'appliedParameters',
    fact: 'bounce acts only while BOUNCE is applied',
    run: async () => {
      const { w, body, collection } = await pair({ bounce: 0.8, appliedParameters: [] });
      below(peak(w, body), 0.01, 'm, not applied');
      collection.set('appliedParameters', ['BOUNCE']);
      close(peak(w, body), 0.64, 0.02, 'm, applied');
      collection.set('appliedParameters', ['SLIP_1']);
      below(peak(w, body), 0.01, 'm, something else applied');
    },
  },
  {
    field: 'bounce',
    effect: 'contact surface',
    fact: 'a ball dropped from h comes back to h e², for every e',
    run: async () => {
      const { w, body, collection } = await pair();
      below(peak(w, body), 0.01, 'm at the default of 0');
      for (const e of [1, 0.8, 0.5]) {
        collection.set('bounce', e);
        close(peak(w, body), e * e, 0.03, `m at ${e}`);
      }
      collection.unset('bounce');
      below(peak(w, body), 0.01, 'm, unset');
    },
  },
  {
    field: 'minBounceSpeed',
    fact: 'an approach below this speed does not bounce, one above it does',
    run: async () => {
      const { w, body, collection } = await pair({ bounce: 0.8 });
      // A metre's fall ends at √(2 g) = 4.43 m/s.
      close(peak(w, body), 0.64, 0.02, 'm at the default of 0.1 m/s');
      collection.set('minBounceSpeed', 4.8);
      below(peak(w, body), 0.01, 'm at 4.8 m/s');
      collection.set('minBounceSpeed', 4.0);
      close(peak(w, body), 0.64, 0.02, 'm at 4.0 m/s');
    },
  },
  {
    field: 'frictionCoefficients',
    fact: 'a sliding box stops after v² / (2 μ g), in every direction',
    run: async () => {
      const { w, body, collection } = await pair({}, { shape: box(2, 1, 2) });
      const d = Math.SQRT1_2;
      const expected = (mu: number) => 16 / (2 * mu * 9.8);
      w.advance(1);
      close(slide(w, body, [1, 0]), expected(0.5), 0.05, 'm, nobody wrote it: 0.5');
      collection.set('frictionCoefficients', [0.2, 0.2]);
      close(slide(w, body, [1, 0]), expected(0.2), 0.1, 'm at 0.2');
      close(slide(w, body, [d, d]), expected(0.2), 0.1, 'm at 0.2, oblique');
      collection.set('frictionCoefficients', [0, 0]);
      close(slide(w, body, [1, 0]), 16, 0.05, 'm at 0: 4 m/s for 4 s');
      collection.unset('frictionCoefficients');
      close(slide(w, body, [1, 0]), expected(0.5), 0.05, 'm, unset');
    },
  },
];

export const collectionRows: Row[] = [...basicRows, ...surfaceRows];

async function watched() {
  const scene = await pair();
  const sensor = scene.w.add('CollisionSensor', { collider: scene.collection }) as Sensor;
  const sent: unknown[] = [];
  sensor.on('isActive', (active) => sent.push(active));
  return { ...scene, sensor, sent };
}

/** Lets the ball down on the slab. */
function land(w: World, ball: Body): void {
  ball.event('position', [0, 0.6, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(1);
}

/** Far from everything. */
function lift(w: World, ball: Body): void {
  ball.event('position', [0, 50, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(0.1);
}

export const sensorRows: Row[] = [
  {
    field: 'collider',
    fact: 'the sensor sees the contacts of the collection it watches now',
    run: async () => {
      const { w, body, collection, sensor } = await watched();
      const other = w.add('CollisionCollection', { collidables: [] });
      land(w, body);
      assert.equal(sensor.get('isActive'), true);
      sensor.set('collider', other);
      w.step();
      assert.equal(sensor.get('isActive'), false);
      sensor.set('collider', collection);
      w.step();
      assert.equal(sensor.get('isActive'), true);
      sensor.set('collider', null);
      w.step();
      assert.equal(sensor.get('isActive'), false);
    },
  },
  {
    field: 'enabled',
    fact: 'a disabled sensor senses nothing until it is enabled again',
    run: async () => {
      const { w, body, sensor } = await watched();
      land(w, body);
      sensor.set('enabled', false);
      w.step();
      assert.equal(sensor.get('isActive'), false);
      sensor.unset('enabled');
      w.step();
      assert.equal(sensor.get('isActive'), true);
    },
  },
  {
    field: 'isActive',
    effect: 'contact reading',
    fact: 'turns TRUE once at the start of a contact and FALSE once at its end',
    run: async () => {
      const { w, body, sensor, sent } = await watched();
      w.step();
      assert.equal(sensor.get('isActive'), false);
      land(w, body);
      assert.deepEqual(sent, [true]);
      lift(w, body);
      assert.deepEqual(sent, [true, false]);
      land(w, body);
      assert.deepEqual(sent, [true, false, true]);
    },
  },
  {
    field: 'intersections',
    effect: 'contact reading',
    fact: 'names the collidables that touch, each once, and none when they part',
    run: async () => {
      const { w, slab, round, body, sensor } = await watched();
      const lists: unknown[] = [];
      sensor.on('intersections', (list) => lists.push(list));
      land(w, body);
      const found = sensor.get('intersections') as unknown[];
      assert.equal(found.length, 2);
      assert.ok(found.includes(slab) && found.includes(round));
      lift(w, body);
      assert.deepEqual(sensor.get('intersections'), []);
      assert.deepEqual(lists.at(-1), []);
      assert.equal(lists.filter((list) => (list as []).length === 0).length, 1);
    },
  },
  {
    field: 'contacts',
    effect: 'contact reading',
    fact: 'has a Contact for the point where a ball touches, a new one with every step, and none when they part',
    run: async () => {
      const { w, slab, round, ground, body, sensor } = await watched();
      land(w, body);
      const [first, ...others] = sensor.get('contacts') as Node[];
      assert.equal(others.length, 0);
      close(first!.get('position') as number[], [0, 0, 0], 2e-3, 'm');
      close(first!.get('contactNormal') as number[], [0, 1, 0], 1e-4, 'out of the slab');
      assert.equal(first!.get('geometry1'), round);
      assert.equal(first!.get('geometry2'), slab);
      assert.equal(first!.get('body1'), body);
      assert.equal(first!.get('body2'), ground);
      w.step();
      assert.notEqual((sensor.get('contacts') as Node[])[0], first);
      const lists: unknown[][] = [];
      sensor.on('contacts', (list) => lists.push(list as unknown[]));
      lift(w, body);
      assert.deepEqual(lists, [[]]);
      assert.deepEqual(sensor.get('contacts'), []);
    },
  },
  {
    effect: 'contact reading',
    fact: 'reads no contact any more from the step on after the last listener has gone',
    run: async () => {
      const w = await world();
      addFloor(w);
      const body = addBody(w, { position: [0, 0.5, 0] });
      let reads = 0;
      const { bullet } = w;
      const each = bullet.eachTouchingPair.bind(bullet);
      bullet.eachTouchingPair = (visit) => {
        reads++;
        each(visit);
      };
      const readsInStep = (): number => {
        reads = 0;
        w.step();
        return reads;
      };
      // The first step looks for what overlaps.
      w.step();
      const before = readsInStep();
      const stop = body.on('collisionstart', () => {});
      assert.notEqual(readsInStep(), before);
      stop();
      assert.equal(readsInStep(), before);
    },
  },
];
