import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import { claim, codes, fact, told, world } from '../../helpers.js';

// What an author gets wrong about particles is told once, and the world goes on.

const system = (w: World, fields: Record<string, unknown> = {}) =>
  w.add('ParticleSystem', { emitter: { type: 'PointEmitter', mass: 1, speed: 1 }, ...fields });

for (const emitter of ['SurfaceEmitter', 'VolumeEmitter', 'PolylineEmitter'])
  fact(
    `a ${emitter} without geometry bears nothing and is told once, until it has one`,
    async () => {
      const w = await world();
      claim(w, 'idle-emitter');
      const node = system(w, { emitter: { type: emitter, mass: 1, speed: 1 } });
      w.step(20);
      assert.equal(node.get('count'), 0);
      assert.equal(node.get('isActive'), false);
      assert.equal(told(w, 'idle-emitter').length, 1);
      assert.match(told(w, 'idle-emitter')[0]!, new RegExp(`ParticleSystem: its ${emitter} `));
      const box = { type: 'Box', size: [1, 1, 1] };
      node.set('emitter', {
        type: emitter,
        mass: 1,
        ...(emitter === 'SurfaceEmitter' ? { surface: box } : {}),
        ...(emitter === 'PolylineEmitter' ? { coord: [0, 0, 0, 1, 0, 0] } : {}),
        ...(emitter === 'VolumeEmitter' ? TETRAHEDRON : {}),
      });
      w.step(20);
      assert.deepEqual(codes(w), []);
      assert.ok((node.get('count') as number) > 0);
    },
  );

const TETRAHEDRON = {
  coord: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
  coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1],
};

fact('forces on particles without mass are told, and no more once they have one', async () => {
  const w = await world();
  claim(w, 'idle-force');
  const emitter = w.add('PointEmitter', { speed: 1 });
  system(w, { emitter, physics: [{ type: 'ForcePhysicsModel' }] });
  w.step(3);
  assert.deepEqual(codes(w), ['idle-force']);
  emitter.set('mass', 0.1);
  w.step();
  assert.deepEqual(codes(w), []);
});

fact('a wind that finds no area, and pushes that come to nothing, are told', async () => {
  for (const [fields, attribute] of [
    [{ physics: [{ type: 'WindPhysicsModel', speed: 3 }] }, 'physics'],
    [{ pushes: true }, 'pushes'],
    [{ pushes: true, collides: true, emitter: { type: 'PointEmitter' } }, 'pushes'],
  ] as const) {
    const w = await world();
    claim(w, 'idle-force');
    system(w, fields);
    w.step();
    assert.deepEqual(
      w.problems.map((problem) => [problem.code, problem.attribute]),
      [['idle-force', attribute]],
    );
  }
});

fact('a wind that pushes bodies needs no particles, nor an area or mass of them', async () => {
  const wind = { type: 'WindPhysicsModel', speed: 3 };
  for (const fields of [
    { emitter: null, maxParticles: 0 },
    { emitter: { type: 'PointEmitter', speed: 1 } },
    { collides: true },
  ]) {
    const w = await world();
    system(w, { pushes: true, physics: [wind], ...fields });
    w.step();
  }
});

fact('a wind that is not enabled makes no push of pushes', async () => {
  const w = await world();
  claim(w, 'idle-force');
  const wind = w.add('WindPhysicsModel', { speed: 3, enabled: false });
  system(w, { pushes: true, physics: [wind] });
  w.step();
  assert.match(told(w, 'idle-force')[0]!, /pushes without collides, and without a wind/);
  wind.set('enabled', true);
  w.step();
  assert.deepEqual(told(w, 'idle-force'), []);
});

fact('numbers that no system can have are one problem each, and what was valid stays', async () => {
  const w = await world();
  claim(w, 'out-of-range', 'bad-value');
  const node = system(w);
  node.set('maxParticles', 1e9);
  node.set('particleLifetime', -2);
  node.set('bounce', 3);
  node.set('lifetimeVariation', NaN);
  w.step(10);
  assert.deepEqual(
    w.problems.map(({ code, attribute }) => [code, attribute]),
    [
      ['out-of-range', 'maxParticles'],
      ['out-of-range', 'particleLifetime'],
      ['out-of-range', 'bounce'],
      ['bad-value', 'lifetimeVariation'],
    ],
  );
  assert.equal(node.get('maxParticles'), 200);
  assert.equal(node.get('particleLifetime'), 5);
  assert.equal(node.get('bounce'), 1);
});

fact('what emits, moves or carries may go at any time', async () => {
  const w = await world();
  const body = w.add('RigidBody', { geometry: [{ type: 'Sphere' }] });
  const emitter = w.add('PointEmitter', { mass: 1, speed: 1 });
  const model = w.add('ForcePhysicsModel', { force: [0, -1, 0] });
  const node = system(w, { emitter, physics: [model], body });
  w.step(10);
  const count = node.get('count') as number;
  assert.ok(count > 0);
  model.remove();
  w.step(10);
  body.remove();
  w.step(10);
  assert.equal(node.get('isActive'), true);
  for (const at of node.get('positions') as number[][]) assert.ok(at.every(Number.isFinite));
  emitter.remove();
  w.step(10);
  node.remove();
  w.step(10);
});

fact(
  'all systems of a world together have 100,000 particles: who finds no room is told, until others go',
  async () => {
    const w = await world();
    claim(w, 'out-of-range');
    const many = { maxParticles: 100_000, particleLifetime: 1, lifetimeVariation: 0 };
    const burst = { emitter: { type: 'ExplosionEmitter', mass: 1, speed: 1 } };
    const first = system(w, { ...many, ...burst, maxParticles: 99_990, particleLifetime: 0.5 });
    const second = system(w, many);
    w.advance(0.25);
    assert.equal(first.get('count'), 99_990);
    assert.equal(second.get('count'), 10);
    assert.deepEqual(codes(w), ['out-of-range']);
    assert.match(told(w, 'out-of-range')[0]!, /at most 100000 particles live in a world/);
    w.advance(0.5);
    assert.equal(first.get('count'), 0);
    assert.ok((second.get('count') as number) > 20_000);
    assert.deepEqual(codes(w), []);
  },
);

const crowd = { maxParticles: 99_990, emitter: { type: 'ExplosionEmitter' } };

fact('who bears none any more is not told that there is no room', async () => {
  const w = await world();
  claim(w, 'out-of-range');
  system(w, crowd);
  const burst = system(w, { emitter: { type: 'ExplosionEmitter' } });
  const steady = system(w, { maxParticles: 1000 });
  w.step(2);
  assert.equal(burst.get('count'), 10);
  assert.deepEqual(codes(w), ['out-of-range']);
  steady.set('createParticles', false);
  w.step(1);
  assert.deepEqual(codes(w), []);
});

fact(
  'who asks for less, but still for too much, is told again; who asks for no more than there is, is not',
  async () => {
    const w = await world();
    claim(w, 'out-of-range');
    system(w, crowd);
    const steady = system(w, { maxParticles: 1000 });
    w.step(10);
    assert.equal(steady.get('count'), 10);
    assert.deepEqual(codes(w), ['out-of-range']);
    steady.set('maxParticles', 900);
    w.step(5);
    assert.deepEqual(codes(w), ['out-of-range']);
    steady.set('maxParticles', 10);
    w.step(1);
    assert.deepEqual(codes(w), []);
  },
);

fact('going back to when there was room, nobody is told that there is none', async () => {
  const w = await world();
  claim(w, 'out-of-range');
  system(w, crowd);
  system(w, { maxParticles: 100, particleLifetime: 10 });
  w.step(1);
  const before = w.snapshot();
  w.advance(1.5);
  assert.deepEqual(codes(w), ['out-of-range']);
  w.restore(before);
  w.step(1);
  assert.deepEqual(codes(w), []);
});
