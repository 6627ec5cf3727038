import assert from 'node:assert/strict';
import { loadEngine, World } from '../../../physics-core/inside.js';
import { Engine } from '../../../physics-core/engine/engine.js';
import { ApiReader, HeapReader } from '../../../physics-core/engine/heap.js';
import { Owner } from '../../../physics-core/engine/owner.js';
import {
  claim,
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  fact,
  position,
  random,
  watch,
  world,
} from '../helpers.js';

/** The engine as it is with an Ammo build whose memory is laid out in another way. */
async function foreignEngine() {
  const { ammo } = await loadEngine();
  const elsewhere = new ArrayBuffer(ammo.HEAPF32.byteLength);
  const heap = { HEAPF32: new Float32Array(elsewhere), HEAP32: new Int32Array(elsewhere) };
  const foreign = new Proxy(ammo, {
    get: (target, key) =>
      key in heap ? heap[key as keyof typeof heap] : Reflect.get(target, key as string),
  });
  return { engine: new Engine(foreign), heap };
}

function scene(w: World): void {
  addFloor(w);
  const next = random(3);
  for (let i = 0; i < 10; i++)
    addBody(w, {
      position: [next(), 1 + i, next()],
      orientation: [next(), 1, 0, 3 * next()],
      geometry: [box(0.7, 0.5, 0.9)],
      angularVelocity: [next(), next(), next()],
    });
  const bob = addBody(w, { position: [5, 5, 0], centerOfMass: [0, 0.3, 0] });
  addJoint(w, 'BallJoint', { body1: bob, anchorPoint: [5, 6, 0] });
}

fact('the heap is trusted with the Ammo build this package depends on', async () => {
  const engine = await loadEngine();
  assert.equal(engine.heapTrusted, true);
  assert.ok(engine.reader instanceof HeapReader);
});

fact('reading from the heap and through the API gives the same numbers', async () => {
  const w = await world();
  scene(w);
  const { ammo, reader } = w.engine;
  const api = new ApiReader();
  const [fast, sure] = [new Float64Array(13), new Float64Array(13)];
  for (let i = 0; i < 30; i++) {
    w.step(5);
    for (const body of w.bodies) {
      for (const [by, out] of [
        [reader, fast],
        [api, sure],
      ] as const) {
        by.pose(body.body, ammo.getPointer(body.body), out, 0);
        by.velocity(body.body, body.pointer, out, 7);
      }
      // A quaternion and its opposite are one rotation; Bullet's own is of single precision.
      const sign = Math.sign(fast[6]! * sure[6]! || 1);
      for (const k of [3, 4, 5, 6]) sure[k]! *= sign;
      close([...fast], [...sure], 1e-6, 'm, m/s');
      assert.equal(reader.sleeps(body.body, body.pointer), api.sleeps(body.body));
    }
  }
});

fact('with another memory layout all goes through the API, and nothing is written', async () => {
  const { engine, heap } = await foreignEngine();
  assert.equal(engine.heapTrusted, false);
  assert.equal(engine.stages, undefined);
  assert.ok(engine.reader instanceof ApiReader);
  const far = new World();
  far.add('RigidBodyCollection', { rest: 'never' });
  far.start(engine);
  claim(watch(far), 'unknown-ammo-build');
  // One after the other: Bullet has one contact callback, and a page one engine.
  const runs = [far, await world()].map((w) => {
    scene(w);
    w.add('CollisionCollection', { collidables: '*' });
    w.step(30);
    const falling = [...w.bodies].map(position);
    w.step(200);
    for (const body of w.bodies) assert.ok(position(body).every(Number.isFinite));
    assert.ok(w.stats.contacts > 0);
    return falling;
  });
  runs[0]!.forEach((at, i) => close(at, runs[1]![i]!, 1e-5, 'm, before anything touches'));
  const written = heap.HEAP32.filter((word) => word !== 0).length;
  assert.equal(written, 0, 'words written where this build has something else');
});

fact('reads go on after the heap has grown and moved', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { linearVelocity: [1, 0, 0] });
  w.step(60);
  const { ammo } = w.engine;
  const before = ammo.HEAPF32;
  (ammo as unknown as { _malloc(bytes: number): number })._malloc(w.engine.heapBytes);
  assert.notEqual(ammo.HEAPF32, before);
  w.step(60);
  close(position(ball), [1, 0, 0], 1e-4, 'm');
});

fact('an owner frees newest first, once', async () => {
  const { ammo } = await loadEngine();
  const freed: object[] = [];
  const owner = new Owner({
    destroy: (object: object) => freed.push(object),
    getPointer: () => 8,
  } as never);
  const [a, b] = [owner.own({}), owner.own({})];
  owner.dispose();
  owner.dispose();
  assert.deepEqual(freed, [b, a]);
  assert.ok(freed[0] === b && freed[1] === a && ammo);
});
