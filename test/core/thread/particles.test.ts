import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { World } from '../../../physics-core/inside.js';
import type { Snapshot } from '../../../physics-core/world/snapshot/snapshot.js';
import { statesIn } from '../../../physics-core/world/snapshot/states.js';
import { claim, closeWorlds, world, type Node } from '../helpers.js';
import { goAway } from './sides.js';

const fountain = (w: World): Node =>
  w.add('ParticleSystem', {
    emitter: { type: 'ConeEmitter', mass: 0.1, surfaceArea: 0.05, speed: 4, angle: 0.4 },
    physics: [
      { type: 'ForcePhysicsModel', force: [0, -0.98, 0] },
      { type: 'WindPhysicsModel', speed: 2, turbulence: 0.5 },
    ],
    maxParticles: 60,
    particleLifetime: 1,
  });

const placesOf = (system: Node): unknown => system.get('positions');

test('particles on the other side are the same bits, and are shown here', async () => {
  const [here, there] = [await world(), await world()];
  const [one, other] = [fountain(here), fountain(there)];
  goAway(there);
  here.step(100);
  await there.ask('step', 100);
  assert.deepEqual(placesOf(other), placesOf(one));
  assert.equal(other.get('count'), one.get('count'));
  assert.equal(other.get('isActive'), true);
  closeWorlds();
});

test('a system that is added, edited and removed here is so there', async () => {
  const [here, there] = [await world(), await world()];
  goAway(there);
  const [one, other] = [fountain(here), fountain(there)];
  here.step(50);
  await there.ask('step', 50);
  for (const system of [one, other]) system.set('maxParticles', 10);
  assert.equal(other.get('count'), 10);
  here.step(5);
  await there.ask('step', 5);
  assert.deepEqual(placesOf(other), placesOf(one));
  other.remove();
  await there.ask('step', 5);
  assert.equal(there.problems.length, 0);
  closeWorlds();
});

test('isActive is told once for each change, wherever the steps are taken', async () => {
  const w = await world();
  const system = fountain(w);
  const told: unknown[] = [];
  system.on('isActive', (active) => told.push(active));
  claim(w, 'thread-main');
  w.step(10);
  const away = goAway(w);
  await w.ask('step', 10);
  assert.deepEqual(told, [true]);
  system.set('enabled', false);
  await w.ask('step', 2);
  assert.deepEqual(told, [true, false]);
  system.set('enabled', true);
  await w.ask('step', 2);
  await away.comeBack({ why: 'it is to' });
  w.step(5);
  assert.deepEqual(told, [true, false, true]);
  closeWorlds();
});

test('nobody listened meanwhile: who does then hears of the next change', async () => {
  const w = await world();
  const system = fountain(w);
  goAway(w);
  await w.ask('step', 5);
  const told: unknown[] = [];
  system.on('isActive', (active) => told.push(active));
  system.set('enabled', false);
  await w.ask('step', 2);
  assert.deepEqual(told, [false]);
  closeWorlds();
});

test('come back, they go on as if they had never been away', async () => {
  const [here, there] = [await world(), await world()];
  const [one, other] = [fountain(here), fountain(there)];
  const away = goAway(there);
  claim(there, 'thread-main');
  here.step(40);
  await there.ask('step', 40);
  await away.comeBack({ why: 'it is to' });
  here.step(80);
  there.step(80);
  assert.deepEqual(placesOf(other), placesOf(one));
  closeWorlds();
});

test('what isActive becomes as the world goes away is told, too', async () => {
  const w = await world();
  const system = fountain(w);
  const told: unknown[] = [];
  system.on('isActive', (active) => told.push(active));
  w.step(5);
  system.set('enabled', false);
  goAway(w);
  await w.ask('step', 2);
  assert.deepEqual(told, [true, false]);
  closeWorlds();
});

test('an emitter in the place of another leaves nothing of that on the other side', async () => {
  const w = await world();
  const system = fountain(w);
  goAway(w);
  system.set('emitter', { type: 'PointEmitter', mass: 1, surfaceArea: 1 });
  await w.ask('step', 2);
  const { nodes } = (await w.ask('snapshot')) as Snapshot;
  const types = statesIn({ nodes }).map(({ type }) => type);
  assert.deepEqual(types.sort(), [...w.nodes].map(({ type }) => type.name).sort());
  closeWorlds();
});
