import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { givenContacts } from '../../../../physics-core/effects/contacts/effects.js';
import { steppingOf } from '../../thread/at-once.js';
import { addBody, addFloor, addJoint, box, close, fact, sphere, world } from '../../helpers.js';

type World = Awaited<ReturnType<typeof world>>;

const effect = (w: World, name: string) => w.effects.find((each) => each.name === name)!;

/** Runs with a clock that goes on by a millisecond whenever somebody looks; returns how often that was. */
function ticking(run: () => void): number {
  const { now } = performance;
  let ticks = 0;
  performance.now = () => ticks++;
  try {
    run();
  } finally {
    performance.now = now;
  }
  return ticks;
}

/** Two balls that swing, and one that falls. */
async function swinging() {
  const w = await world();
  const balls = [0, 5, 10].map((x) => addBody(w, { position: [x, 0, 0] }));
  const joints = balls
    .slice(0, 2)
    .map((body1, i) => addJoint(w, 'BallJoint', { body1, anchorPoint: [5 * i, 1, 1] }));
  w.step(0);
  return { w, balls, joints };
}

describe('world.effects', () => {
  fact('names all that need an effect, and why the first does', async () => {
    const { w, balls, joints } = await swinging();
    const { because, elements } = effect(w, 'joint solve');
    assert.equal(because!.element, joints[0]);
    assert.equal(typeof because!.reason, 'string');
    assert.deepEqual(elements, joints);
    assert.deepEqual(effect(w, 'free flight').elements, balls);
    joints[0]!.remove();
    w.step(0);
    assert.deepEqual(effect(w, 'joint solve').elements, [joints[1]]);
    assert.deepEqual(effect(w, 'motors').elements, []);
  });

  fact('counts the calls of a step, and those for contact points one by one', async () => {
    const w = await world();
    addFloor(w);
    // Four corners.
    addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
    w.add('CollisionCollection', { collidables: '*', appliedParameters: ['BOUNCE'], bounce: 0.5 });
    w.step(170);
    ticking(() => w.step(17));
    assert.equal(effect(w, 'free flight').calls, 1);
    const points = w.stats.contacts;
    assert.equal(points, 4);
    const surface = effect(w, 'contact surface');
    // Before and after the step, and at each point.
    close(surface.calls, 2 + points, 0.5);
    assert.ok(surface.ms > 0, `${surface.ms} ms`);
  });

  fact('has no cost of what is off, nor of one that a step does not call', async () => {
    const { w, joints } = await swinging();
    ticking(() => w.step(34));
    const on = effect(w, 'joint solve');
    assert.ok(on.ms > 0 && on.calls >= 3, `${on.ms} ms in ${on.calls} calls`);
    for (const joint of joints) joint.remove();
    w.step(1);
    const off = effect(w, 'joint solve');
    assert.deepEqual([off.active, off.because, off.ms, off.calls], [false, null, 0, 0]);
    const continuous = effect(w, 'continuous collision');
    assert.deepEqual([continuous.ms, continuous.calls], [0, 0]);
  });

  fact('knows the calls of what goes off within the step, too', async () => {
    const w = await world();
    addFloor(w);
    addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
    const collider = w.add('CollisionCollection', { collidables: '*' });
    const sensor = w.add('CollisionSensor', { collider });
    sensor.on('contacts', (contacts) => w.settings.event('set_contacts', contacts));
    w.step(34);
    assert.ok(steppingOf(w).registry.find(givenContacts)!.cost.calls > 0);
  });

  fact('is measured in one step of 17: in the others effects never look at the clock', async () => {
    const w = await world();
    addBody(w, { geometry: [sphere(1)], torques: [[1, 0, 0]] });
    w.step(1);
    const looks = Array.from({ length: 34 }, () => ticking(() => w.step(1)));
    // Those of the phases of each frame; what stands above them is measured.
    const least = Math.min(...looks);
    assert.equal(least, 4);
    assert.equal(looks.filter((count) => count > least).length, 2);
  });

  fact('tells the chunk of code; where all code is one file, no bytes came for it', async () => {
    const { w } = await swinging();
    const { chunk, bytes } = effect(w, 'joint solve');
    assert.deepEqual([chunk, bytes], ['joints', 0]);
    assert.equal(effect(w, 'free flight').chunk, null);
  });
});
