import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import type { PhysicsNode } from '../../../../physics-core/nodes/node/node.js';
import { addBody, box, close, fact, WEIGHTLESS, world, type Vec3 } from '../../helpers.js';

// What a ParticleSystem in a world does.

const fountain = (w: World, fields: Record<string, unknown> = {}): PhysicsNode =>
  w.add('ParticleSystem', {
    emitter: { type: 'PointEmitter', mass: 0.1, speed: 4, variation: 0, direction: [0, 1, 0] },
    physics: [{ type: 'ForcePhysicsModel', force: [0, -0.98, 0] }],
    maxParticles: 20,
    particleLifetime: 1,
    lifetimeVariation: 0,
    ...fields,
  });

const placesOf = (system: PhysicsNode): Vec3[] => system.get('positions') as Vec3[];

fact('particles rise and fall as the parabola is, oldest first', async () => {
  const w = await world();
  const system = fountain(w);
  w.advance(0.475);
  const places = placesOf(system);
  assert.equal(places.length, 10);
  places.forEach(([x, y, z], k) => {
    const age = 0.475 - k / 20;
    close(y, 4 * age - 4.9 * age * age, 1e-9);
    assert.deepEqual([x, z], [0, 0]);
  });
  assert.equal(system.get('count'), 10);
});

fact('a world goes on while particles live, and rests when the last one has gone', async () => {
  const w = await world();
  const system = fountain(w);
  const told: unknown[] = [];
  system.on('isActive', (active) => told.push(active));
  for (let i = 0; i < 29; i++) w.frame(1 / 60);
  assert.equal(system.get('count'), 10);
  assert.equal(system.get('isActive'), true);
  system.set('createParticles', false);
  let frames = 0;
  while (w.frame(1 / 60) && frames < 200) frames++;
  assert.ok(frames > 55 && frames < 70, `${frames}`);
  assert.equal(system.get('isActive'), false);
  assert.deepEqual(told, [true, false]);
});

fact('what stops has no effect, what goes leaves none', async () => {
  const w = await world();
  assert.equal(w.effects.find(({ name }) => name === 'particles')!.active, false);
  const system = fountain(w);
  w.step();
  assert.equal(w.effects.find(({ name }) => name === 'particles')!.active, true);
  system.remove();
  w.step();
  assert.equal(w.effects.find(({ name }) => name === 'particles')!.active, false);
});

fact('an emitter on a body goes with it, and its particles have its speed', async () => {
  const w = await world(WEIGHTLESS);
  const body = addBody(w, {
    position: [1, 2, 3],
    linearVelocity: [6, 0, 0],
    geometry: [box(1, 1, 1)],
  });
  const system = fountain(w, { body, physics: [] });
  w.advance(0.475);
  const places = placesOf(system);
  assert.equal(places.length, 10);
  places.forEach(([x, y, z], k) => {
    const [born, age] = [k / 20, 0.475 - k / 20];
    close(x, 1 + 6 * born + 6 * age, 1e-5);
    close(y, 2 + 4 * age, 1e-5);
    close(z, 3, 1e-5);
  });
});

fact('a body that turns throws what is born away from its axis', async () => {
  const w = await world(WEIGHTLESS);
  const body = addBody(w, { angularVelocity: [0, 2, 0], geometry: [box(1, 1, 1)] });
  const system = fountain(w, {
    body,
    physics: [],
    maxParticles: 1,
    particleLifetime: 10,
    emitter: { type: 'PointEmitter', position: [3, 0, 0], speed: 0, variation: 0 },
  });
  w.step();
  // Born at the step's beginning at 3 0 0, thrown along -z at ω r.
  const [[x, , z]] = placesOf(system) as [Vec3];
  close(x, 3, 1e-4);
  close(z, -6 * w.timeStep, 1e-4);
});

fact('edits of an emitter, a model and the system act from the next step on', async () => {
  const w = await world();
  const emitter = w.add('PointEmitter', { speed: 1, variation: 0, mass: 1 });
  const model = w.add('ForcePhysicsModel', { enabled: false, force: [0, -6, 0] });
  const system = w.add('ParticleSystem', {
    emitter,
    physics: [model],
    maxParticles: 1,
    particleLifetime: 100,
  });
  w.advance(1);
  close(placesOf(system)[0]![1], 1, 1e-9);
  model.set('enabled', true);
  w.advance(1);
  close(placesOf(system)[0]![1], 2 - 3, 1e-9);
  model.set('force', [0, 0, 0]);
  emitter.set('direction', [1, 0, 0]);
  w.advance(1);
  close(placesOf(system)[0]![1], 2 - 3 - 5, 1e-9);
  system.set('enabled', false);
  w.step();
  system.set('enabled', true);
  w.advance(1);
  close(placesOf(system)[0]![0], 1, 1e-9);
});

fact('after a reset and after going back the same particles fly, bit for bit', async () => {
  const w = await world();
  const system = fountain(w, {
    seed: 7,
    lifetimeVariation: 0.5,
    emitter: { type: 'ConeEmitter', mass: 0.1, surfaceArea: 0.01, speed: 3, angle: 1 },
    physics: [
      { type: 'ForcePhysicsModel', force: [0, -0.98, 0] },
      { type: 'WindPhysicsModel', direction: [1, 0, 0], speed: 3, turbulence: 0.3 },
    ],
  });
  w.advance(0.7);
  const kept = w.snapshot();
  w.advance(0.7);
  const first = placesOf(system);
  w.restore(kept);
  w.advance(0.7);
  assert.deepEqual(placesOf(system), first);
  w.reset();
  w.advance(1.4);
  assert.deepEqual(placesOf(system), first);
});

fact(
  'a world that rests goes on where it is put back to living particles, and tells so once',
  async () => {
    const w = await world();
    const system = fountain(w);
    const told: unknown[] = [];
    system.on('isActive', (active) => told.push(active));
    w.advance(0.5);
    system.set('createParticles', false);
    w.advance(0.1);
    const kept = w.snapshot();
    w.advance(0.2);
    const first = placesOf(system);
    w.advance(3);
    assert.deepEqual(told, [true, false]);
    w.restore(kept);
    w.advance(0.2);
    assert.deepEqual(placesOf(system), first);
    w.advance(3);
    assert.equal(system.get('count'), 0);
    assert.deepEqual(told, [true, false, true, false]);
  },
);

fact('a body that is not simulated throws nothing with the speed that it had', async () => {
  const w = await world(WEIGHTLESS);
  const body = addBody(w, { linearVelocity: [0, 1, 0], geometry: [box(0.1, 0.1, 0.1)] });
  addBody(w, { position: [50, 0, 0], linearVelocity: [1, 0, 0] });
  const system = fountain(w, { body, physics: [], emitter: { type: 'PointEmitter', speed: 0 } });
  w.advance(0.5);
  body.set('enabled', false);
  w.advance(1.2);
  for (const [, y] of placesOf(system)) close(y, 0.5, 0.02);
});

fact('isActive is told once for each change, through resets and restores', async () => {
  const w = await world();
  const system = fountain(w);
  const told: unknown[] = [];
  system.on('isActive', (active) => told.push(active));
  const empty = w.snapshot();
  w.advance(0.5);
  w.reset();
  w.advance(0.5);
  assert.deepEqual(told, [true]);
  system.set('enabled', false);
  w.reset();
  w.advance(0.1);
  assert.deepEqual(told, [true, false]);
  w.restore(empty);
  w.advance(0.1);
  assert.deepEqual(told, [true, false, true]);
});

fact('a body that is made again goes on throwing', async () => {
  const w = await world(WEIGHTLESS);
  const body = addBody(w, { geometry: [box(1, 1, 1)] });
  const system = fountain(w, { body, physics: [] });
  w.advance(0.2);
  body.unmake();
  w.advance(0.3);
  const count = system.get('count');
  body.set('geometry', [box(2, 2, 2)]);
  w.advance(0.2);
  assert.ok((system.get('count') as number) > (count as number));
  for (const at of placesOf(system)) assert.ok(at.every(Number.isFinite));
});
