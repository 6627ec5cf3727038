import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Run, World } from '../../../physics-core/inside.js';
import { hashOf } from '../../../physics-core/timeline/hash.js';
import { claim, closeWorlds, world, type Body, type Node, type Vec3 } from '../helpers.js';
import { answered, goAway } from './sides.js';

const box = { type: 'Box', size: [1, 1, 1] };

/** A heap, a pendulum, and a floor with a sensor. */
async function scene(fields = {}): Promise<World> {
  const made = await world(fields);
  made.add(
    'RigidBody',
    { fixed: true, geometry: [{ type: 'Box', size: [20, 1, 20] }] },
    { name: 'floor' },
  );
  for (let i = 0; i < 6; i++)
    made.add(
      'RigidBody',
      { position: [i / 7, 1 + 1.1 * i, 0], geometry: [box] },
      { name: `b${i}` },
    );
  const bob = made.add('RigidBody', { position: [6, 4, 0], geometry: [box] }, { name: 'bob' });
  made.add('BallJoint', { body1: bob, anchorPoint: [3, 4, 0] }, { name: 'joint' });
  return made;
}

/** What is read of Bullet here was made of a quaternion again. */
const rounded = (_: string, value: unknown): unknown =>
  typeof value === 'number' ? Math.round(value * 1e5) / 1e5 : value;

const body = (of: World, name: string): Body => of.node(name) as Body;

test('steps on the other side are the same bits', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  here.step(120);
  assert.equal(await there.ask('step', 120), 1);
  assert.equal(hashOf(there), hashOf(here));
  assert.equal(there.time, here.time);
  assert.equal(there.mirrored, 120);
  closeWorlds();
});

test('what is done here is done there, in its order', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  const early = (on: World): void => {
    body(on, 'b2').applyImpulse([3, 2, 1]);
    body(on, 'bob').set('mass', 5);
    on.add('RigidBody', { position: [0, 12, 0], geometry: [box] }, { name: 'late' });
    body(on, 'b1').remove();
    (on.node('joint') as Node).set('anchorPoint', [4, 4, 0]);
    on.set('gravity', [0, -5, 1]);
  };
  here.step(60);
  await there.ask('step', 60);
  early(here);
  early(there);
  here.step(90);
  await there.ask('step', 90);
  assert.equal(hashOf(there), hashOf(here));
  closeWorlds();
});

test('what is put somewhere here stays there until the other side has heard of it', async () => {
  const there = await scene();
  goAway(there);
  await there.ask('step', 30);
  const seen: number[] = [];
  const place = (): number => (body(there, 'b3').get('position') as Vec3)[0];
  // Both are under way when it is put there, and know nothing of it.
  const steps = [there.ask('step', 1), there.ask('step', 1)];
  body(there, 'b3').teleport([9, 5, 0]);
  for (const step of steps) {
    await step;
    seen.push(place());
  }
  await there.ask('step', 1);
  seen.push(place());
  assert.deepEqual(seen, [9, 9, 9]);
  assert.ok((body(there, 'b3').get('position') as Vec3)[1] < 5);
  closeWorlds();
});

test('frames go by the same clock', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  for (let i = 0; i < 40; i++) {
    here.frame(1 / 60);
    there.frame(1 / 60);
    await answered(there);
  }
  assert.equal(there.time, here.time);
  assert.equal(hashOf(there), hashOf(here));
  there.frame(0);
  const { slot } = body(there, 'bob');
  const at = (of: World): number[] => [...of.poses.data.subarray(7 * slot, 7 * slot + 7)];
  assert.deepEqual(at(there), at(here));
  closeWorlds();
});

test('what happens there is told here, once and in order', async () => {
  const [here, there] = [await scene(), await scene()];
  const heard: string[][] = [[], []];
  goAway(there);
  [here, there].forEach((of, i) => {
    for (const name of ['b0', 'b1', 'bob'])
      for (const event of ['collisionstart', 'collisionend', 'sleep', 'wake'])
        body(of, name).on(event, (detail) => {
          const { other, time } = detail as { other?: Body; time: number };
          heard[i]!.push(`${name} ${event} ${other?.name} ${time}`);
        });
  });
  here.step(400);
  await there.ask('step', 400);
  assert.ok(heard[0]!.length > 2);
  assert.deepEqual(heard[1], heard[0]);
  closeWorlds();
});

test('sensors tell, and can be read', async () => {
  const of = await scene();
  const collider = of.add('CollisionCollection', {
    collidables: [body(of, 'floor'), body(of, 'b0')].flatMap(
      (each) => each.get('geometry') as Node[],
    ),
  });
  const sensor = of.add('CollisionSensor', { collider });
  goAway(of);
  const heard: unknown[] = [];
  sensor.on('contacts', (detail) => heard.push(detail));
  await of.ask('step', 120);
  assert.equal(sensor.get('isActive'), true);
  assert.equal((sensor.get('intersections') as Node[]).length, 2);
  const [contact] = heard.at(-1) as Node[];
  assert.ok(Math.abs((contact!.get('contactNormal') as Vec3)[1]) > 0.99);
  assert.equal((contact!.get('body1') as Node).world, of);
  closeWorlds();
});

test('contacts of a sensor can be read once they were asked for', async () => {
  const of = await scene();
  const collider = of.add('CollisionCollection', { collidables: '*' });
  const sensor = of.add('CollisionSensor', { collider });
  goAway(of);
  await of.ask('step', 120);
  assert.deepEqual(sensor.get('contacts'), []);
  await of.ask('step', 10);
  assert.ok((sensor.get('contacts') as Node[]).length > 2);
  closeWorlds();
});

test('outputs of joints, velocities and stats are those of the step that came back', async () => {
  const worlds = [await scene(), await scene()] as const;
  for (const of of worlds) {
    const door = of.add('RigidBody', { position: [-6, 3, 0], geometry: [box] }, { name: 'door' });
    const frame = of.add('RigidBody', { position: [-8, 3, 0], fixed: true, geometry: [box] });
    const hinge = { body1: frame, body2: door, anchorPoint: [-7, 3, 0], axis: [0, 0, 1] };
    of.add('SingleAxisHingeJoint', { ...hinge, forceOutput: ['ALL'] }, { name: 'hinge' });
  }
  const [here, there] = worlds;
  goAway(there);
  here.step(77);
  await there.ask('step', 77);
  const outputs = (of: World): unknown[] => {
    const hinge = of.node('hinge') as Node;
    const { bodies, awake, joints, contacts } = of.stats;
    return [
      ...['angle', 'angleRate', 'body1AnchorPoint', 'body2AnchorPoint'].map((name) =>
        hinge.get(name),
      ),
      body(of, 'door').get('linearVelocity'),
      body(of, 'bob').get('angularVelocity'),
      { bodies, awake, joints, contacts },
    ];
  };
  const [one, other] = [outputs(there), outputs(here)].map((all) => JSON.stringify(all, rounded));
  assert.equal(one, other);
  closeWorlds();
});

test('what is said of pausing holds, whatever was answered meanwhile', async () => {
  const of = await scene();
  goAway(of);
  of.paused = true;
  of.frame(1 / 60);
  of.paused = false;
  await answered(of);
  assert.equal(of.paused, false);
  of.frame(1 / 60);
  of.paused = true;
  await answered(of);
  const { time } = of;
  of.frame(1 / 60);
  await answered(of);
  assert.equal(of.paused, true);
  assert.equal(of.time, time);
  closeWorlds();
});

test('the time that the other side takes to begin is no time of the world', async () => {
  const of = await scene();
  goAway(of);
  for (let i = 0; i < 100; i++) of.frame(1 / 60);
  await answered(of);
  assert.ok(of.time <= 1 / 60);
  assert.equal(of.stats.dropped, 0);
  closeWorlds();
});

test('where no worker can be had the world runs here, and answers what was asked', async () => {
  const [here, there] = [await scene(), await scene()];
  const away = goAway(there);
  body(there, 'b1').set('mass', 3);
  const asked = there.ask('step', 30);
  const kept = there.record();
  away.missing(new Error('forbidden'));
  claim(there, 'thread-main');
  assert.equal(await asked, 0.25);
  assert.equal((await kept).from, 0.25);
  here.flush();
  body(here, 'b1').set('mass', 3);
  here.step(30);
  assert.equal(hashOf(there), hashOf(here));
  closeWorlds();
});

test('a body that is held when its world comes back is let go, and nobody holds it unseen', async () => {
  const of = await scene();
  goAway(of);
  await of.ask('step', 10);
  of.on('beforestep', () => {});
  const ends: string[] = [];
  const drag = body(of, 'bob').drag([6, 4, 0], (reason) => ends.push(reason))!;
  drag.move([6, 9, 0]);
  await answered(of);
  claim(of, 'thread-main');
  assert.deepEqual(ends, ['reset']);
  assert.equal(drag.held, false);
  assert.equal(of.effects.find(({ name }) => name === 'dragging')!.active, false);
  closeWorlds();
});

test('what is lost is told once, stands still, and begins anew by reset()', async () => {
  const of = await scene();
  const away = goAway(of);
  await of.ask('step', 20);
  await of.record();
  const waiting = of.ask('step', 20);
  away.lost(new Error('no memory'));
  await assert.rejects(waiting, /no memory/);
  await assert.rejects(of.ask('step'), /lost/);
  await assert.rejects(of.record(), /lost/);
  assert.equal(of.timeline, undefined);
  of.frame(1 / 60);
  assert.equal(of.stepping.needsFrame, false);
  claim(of, 'thread-lost');
  of.reset();
  assert.equal(of.elsewhere, undefined);
  of.step(20);
  assert.ok(of.time > 0.16);
  closeWorlds();
});

test('what can’t be known at once is said so, once, and can be asked', async () => {
  const of = await scene();
  goAway(of);
  assert.equal(of.raycast([0, 9, 0], [0, -9, 0]), null);
  assert.equal(of.snapshot(), null);
  assert.equal(of.step(), 0);
  assert.equal(of.advance(1), 0);
  claim(of, 'asynchronous', 'asynchronous', 'asynchronous');
  const hit = (await of.ask('raycast', [6, 9, 0], [6, -9, 0])) as { node: Node };
  assert.equal(hit.node, of.node('bob'));
  closeWorlds();
});

test('a snapshot of there goes on here, to the bit', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  await there.ask('step', 50);
  const snapshot = (await there.ask('snapshot')) as ReturnType<World['snapshot']>;
  here.restore(snapshot);
  here.step(50);
  await there.ask('step', 50);
  assert.equal(hashOf(there), hashOf(here));
  there.restore(snapshot);
  await there.ask('step', 50);
  assert.equal(hashOf(there), hashOf(here));
  there.reset();
  here.reset();
  here.step(70);
  await there.ask('step', 70);
  assert.equal(hashOf(there), hashOf(here));
  closeWorlds();
});

test('who listens before each step has the world back, and it goes on to the bit', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  await there.ask('step', 50);
  there.on('beforestep', () => {});
  body(there, 'b3').set('mass', 2);
  assert.equal(there.elsewhere !== undefined, true);
  await answered(there);
  assert.equal(there.elsewhere, undefined);
  claim(there, 'thread-main');
  here.step(50);
  body(here, 'b3').set('mass', 2);
  here.step(50);
  there.step(50);
  assert.equal(hashOf(there), hashOf(here));
  closeWorlds();
});

test('what is recorded there is shown here, and gone on from to the bit', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  await there.ask('step', 50);
  here.step(50);
  const [mine, timeline] = [await here.record(), await there.record()];
  assert.equal(timeline.from, mine.from);
  const bob = (on: World): number[] => body(on, 'bob').get('position') as number[];
  here.step(250);
  await there.ask('step', 250);
  body(here, 'b2').set('mass', 3);
  body(there, 'b2').set('mass', 3);
  for (const each of [mine, timeline]) each.seek(1.5);
  assert.equal(timeline.at, 1.5);
  await answered(there);
  assert.equal(timeline.at, mine.at);
  assert.equal(timeline.to, mine.to);
  assert.deepEqual(timeline.hashes, mine.hashes);
  assert.deepEqual(bob(there), bob(here));
  for (const each of [here, there]) each.resume();
  assert.equal(timeline.at, undefined);
  await answered(there);
  assert.equal(there.time, here.time);
  here.step(200);
  await there.ask('step', 200);
  assert.equal(hashOf(there), hashOf(here));
  assert.notEqual(there.elsewhere, undefined);
  closeWorlds();
});

test('what another thread recorded is shown without waiting for a frame, edits before it done before', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  const timelines = [await here.record(), await there.record()];
  here.step(240);
  await there.ask('step', 240);
  for (const each of [here, there]) body(each, 'b2').set('mass', 3);
  for (const each of timelines) each.seek(1);
  const bob = (on: World): number[] => body(on, 'bob').get('position') as number[];
  const before = bob(there);
  // Nobody asks, and no frame comes.
  for (let i = 0; i < 1000 && bob(there)[1] === before[1]; i++)
    await new Promise((resolve) => setTimeout(resolve, 1));
  assert.deepEqual(bob(there), bob(here));
  for (const each of [here, there]) each.resume();
  await answered(there);
  assert.deepEqual(
    [here, there].map((each) => body(each, 'b2').get('mass')),
    [1, 1],
  );
  closeWorlds();
});

test('what is done before it has gone on from where one looked is done once', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  const timelines = [await here.record(), await there.record()];
  here.step(240);
  await there.ask('step', 240);
  body(here, 'b0').set('fixed', true);
  body(there, 'b0').set('fixed', true);
  for (const each of timelines) each.seek(1);
  await answered(there);
  for (const each of [here, there]) {
    each.resume();
    body(each, 'b3').applyImpulse([4, 3, 0]);
    body(each, 'bob').set('mass', 6);
  }
  await answered(there);
  for (const each of [here, there]) {
    assert.equal(body(each, 'b0').get('fixed'), false);
    assert.equal(body(each, 'bob').get('mass'), 6);
  }
  here.step(100);
  await there.ask('step', 100);
  assert.equal(hashOf(there), hashOf(here));
  closeWorlds();
});

test('what is recorded there plays here while time stands, and paused it stays', async () => {
  const of = await scene();
  goAway(of);
  const timeline = await of.record();
  await of.ask('step', 240);
  timeline.play();
  assert.ok(timeline.playing && timeline.at === 0 && of.stepping.needsFrame);
  for (let i = 0; i < 30; i++) {
    of.frame(1 / 60);
    await answered(of);
  }
  assert.ok(Math.abs(timeline.at - 0.5) < 0.04, String(timeline.at));
  assert.equal(of.time, 2);
  timeline.pause();
  await answered(of);
  const { at } = timeline;
  of.frame(1);
  await answered(of);
  assert.equal(timeline.at, at);
  assert.equal(timeline.playing, false);
  closeWorlds();
});

test('who takes hold of a body while looking at another thread’s past goes on from there, and takes hold again', async () => {
  const of = await scene();
  goAway(of);
  const timeline = await of.record();
  await of.ask('step', 240);
  timeline.seek(1);
  await answered(of);
  assert.equal(body(of, 'bob').drag([6, 4, 0]), undefined);
  assert.equal(timeline.at, undefined);
  await answered(of);
  assert.equal(of.time, 1);
  assert.ok(body(of, 'bob').drag(body(of, 'bob').get('position') as Vec3)!.held);
  closeWorlds();
});

test('a run that was recorded there is asked for, and runs anew in another world', async () => {
  const of = await scene();
  goAway(of);
  await of.record();
  await of.ask('step', 100);
  body(of, 'b4').applyImpulse([2, 0, 0]);
  await of.ask('step', 100);
  assert.equal(of.exportRun(), null);
  claim(of, 'asynchronous');
  void of.timeline!.marks;
  const run = JSON.parse(JSON.stringify(await of.ask('exportRun'))) as Run;
  assert.ok(of.timeline!.marks.some(({ text }) => text.includes('applyImpulse')));
  const to = await scene();
  const timeline = await to.importRun(run);
  assert.deepEqual(timeline!.hashes, of.timeline!.hashes);
  assert.equal(hashOf(to), hashOf(of));
  closeWorlds();
});

test('stopped, nothing is kept there; who looked goes on from where he did', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  for (const each of [here, there]) await each.record();
  here.step(240);
  await there.ask('step', 240);
  for (const each of [here, there]) {
    each.timeline!.seek(1);
    each.timeline!.stop();
    assert.equal(each.timeline, undefined);
  }
  here.step(60);
  await there.ask('step', 60);
  assert.equal(hashOf(there), hashOf(here));
  assert.equal(await there.ask('exportRun'), undefined);
  closeWorlds();
});

test('a world that comes back is recorded on, from then on', async () => {
  const of = await scene();
  goAway(of);
  await of.record({ seconds: 3 });
  await of.ask('step', 120);
  const stop = of.on('beforestep', () => {});
  await answered(of);
  await answered(of);
  claim(of, 'thread-main');
  assert.equal(of.elsewhere, undefined);
  assert.equal(of.timeline!.from, 1);
  of.step(60);
  assert.equal(of.timeline!.to, 1.5);
  stop();
  closeWorlds();
});

test('a body can be dragged there', async () => {
  const [here, there] = [await scene(), await scene()];
  goAway(there);
  const grip = (of: World) => body(of, 'bob').drag([6, 4, 0])!;
  const [a, b] = [grip(here), grip(there)];
  for (let i = 0; i < 30; i++) {
    for (const drag of [a, b]) drag.move([6 + i / 20, 5, 0]);
    here.step(2);
    await there.ask('step', 2);
  }
  for (const drag of [a, b]) drag.end();
  here.step(30);
  await there.ask('step', 30);
  assert.equal(hashOf(there), hashOf(here));
  closeWorlds();
});

test('problems of steps come from there, those of edits from here, each once', async () => {
  const of = await scene();
  goAway(of);
  const problems: string[] = [];
  of.on('problem', (problem) => problems.push((problem as { code: string }).code));
  body(of, 'b0').set('mass', -3);
  of.set('contactSurfaceThickness', NaN);
  await of.ask('step', 10);
  assert.deepEqual(problems, ['out-of-range', 'bad-value']);
  claim(of, 'out-of-range', 'bad-value');
  closeWorlds();
});
