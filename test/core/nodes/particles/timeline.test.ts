import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import type { PhysicsNode } from '../../../../physics-core/nodes/node/node.js';
import { addBody, box, fact, world, type Body, type Vec3 } from '../../helpers.js';

// Who looks back sees particles as they were, too.

const fountain = (w: World, fields: Record<string, unknown> = {}): PhysicsNode =>
  w.add('ParticleSystem', {
    emitter: { type: 'PointEmitter', mass: 0.1, speed: 4, direction: [0, 0, 0] },
    physics: [{ type: 'ForcePhysicsModel', force: [0, -0.98, 0] }],
    maxParticles: 60,
    particleLifetime: 1,
    ...fields,
  });

const placesOf = (system: PhysicsNode): Vec3[] => system.get('positions') as Vec3[];

/** Pictures are in single precision. */
const single = (places: Vec3[]): number[][] => places.map((place) => place.map(Math.fround));

fact('a moment that is looked at has the particles of then, and nothing is simulated', async () => {
  const w = await world();
  const system = fountain(w);
  const timeline = await w.record({ seconds: 10 });
  w.advance(0.5);
  const then = placesOf(system);
  w.advance(1);
  const now = placesOf(system);
  timeline.seek(0.5);
  assert.deepEqual(placesOf(system), single(then));
  assert.equal(system.get('count'), then.length);
  timeline.seek(0);
  assert.deepEqual(placesOf(system), []);
  timeline.seek(1.5);
  assert.deepEqual(placesOf(system), single(now));
});

fact('gone on from a moment, they go the way they went, to the bit', async () => {
  const w = await world();
  const system = fountain(w);
  const timeline = await w.record({ seconds: 10 });
  w.advance(0.5);
  const then = placesOf(system);
  w.advance(0.7);
  const later = placesOf(system);
  timeline.seek(0.5);
  w.resume();
  assert.deepEqual(placesOf(system), then);
  w.advance(0.7);
  assert.deepEqual(placesOf(system), later);
});

fact('a system that came later has no particles at a moment before it', async () => {
  const w = await world();
  fountain(w);
  const timeline = await w.record({ seconds: 10 });
  w.advance(0.5);
  const late = fountain(w);
  w.advance(0.5);
  timeline.seek(0.25);
  assert.deepEqual(placesOf(late), []);
  timeline.seek(1);
  assert.ok(placesOf(late).length >= 30);
});

fact('the recording stopped, they are those of the running world', async () => {
  const w = await world();
  const system = fountain(w);
  const timeline = await w.record({ seconds: 10 });
  w.advance(1);
  const now = placesOf(system);
  timeline.seek(0.5);
  timeline.seek(1);
  timeline.stop();
  assert.deepEqual(placesOf(system), now);
});

/** What rains onto a lift that its author moves along in each step. */
function onLift(w: World): { system: PhysicsNode; go: (from: number, to: number) => void } {
  const lift: Body = addBody(w, { fixed: true, geometry: [box(2, 0.2, 2)] });
  const system = fountain(w, {
    emitter: { type: 'PointEmitter', mass: 0.1, position: [0, 1, 0], direction: [0, -1, 0] },
    collides: true,
    particleLifetime: 3,
  });
  const go = (from: number, to: number): void => {
    for (let i = from; i < to; i++) {
      lift.set('position', [0.003 * i, 0.002 * i, 0]);
      w.step(1);
    }
  };
  return { system, go };
}

fact(
  'restored, what lies on a lift that is moved along goes the way it went, to the bit',
  async () => {
    const w = await world();
    const { system, go } = onLift(w);
    go(0, 90);
    const then = w.snapshot();
    go(90, 92);
    const later = placesOf(system);
    w.restore(then);
    go(90, 92);
    assert.deepEqual(placesOf(system), later);
  },
);

fact('and so it does, gone on from any moment of a recording', async () => {
  const w = await world();
  const { system, go } = onLift(w);
  const timeline = await w.record({ seconds: 10 });
  go(0, 180);
  const then = placesOf(system);
  go(180, 190);
  timeline.seek(1.5);
  w.resume();
  assert.deepEqual(placesOf(system), then);
});

fact(
  'gone on from before its emitter was another, a system has that one again, and a body its shape',
  async () => {
    const w = await world();
    const system = fountain(w);
    const crate = addBody(w, { geometry: [box(1, 1, 1)] });
    const timeline = await w.record({ seconds: 10 });
    w.advance(0.5);
    system.set('emitter', { type: 'PointEmitter', mass: 1, speed: 9 });
    crate.set('geometry', [box(2, 2, 2)]);
    w.advance(0.5);
    timeline.seek(0.5);
    w.resume();
    assert.equal((system.get('emitter') as PhysicsNode).get('speed'), 4);
    assert.equal((crate.get('geometry') as PhysicsNode[]).length, 1);
  },
);
