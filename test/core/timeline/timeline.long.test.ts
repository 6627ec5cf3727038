import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Timeline, World } from '../../../physics-core/inside.js';
import { hashOf } from '../../../physics-core/timeline/hash.js';
import {
  claim,
  closeWorlds,
  fact,
  told,
  world,
  type Body,
  type Node,
  type Vec3,
} from '../helpers.js';
import { HASHES, towerRun } from './tower.js';

const box = { type: 'Box', size: [1, 1, 1] };

/** A heap, a pendulum, and a ball that flies by. */
async function scene(fields = {}): Promise<World> {
  const made = await world(fields);
  made.add('RigidBody', { fixed: true, geometry: [{ type: 'Box', size: [20, 1, 20] }] });
  for (let i = 0; i < 6; i++)
    made.add(
      'RigidBody',
      { position: [i / 7, 1 + 1.1 * i, 0], geometry: [box] },
      { name: `b${i}` },
    );
  const bob = made.add('RigidBody', { position: [6, 4, 0], geometry: [box] }, { name: 'bob' });
  made.add('BallJoint', { body1: bob, anchorPoint: [3, 4, 0] });
  return made;
}

const body = (of: World, name: string): Body => of.node(name) as Body;
const heights = (of: World): number[] =>
  [0, 1, 2, 3, 4, 5].map((i) => (body(of, `b${i}`).get('position') as number[])[1]!);

async function recorded(of: World, seconds = 10): Promise<Timeline> {
  return of.record({ seconds });
}

test('what is recorded goes the way it goes without, to the bit', async () => {
  const [plain, kept] = [await scene(), await scene()];
  await recorded(kept);
  plain.step(300);
  kept.step(300);
  assert.equal(hashOf(kept), hashOf(plain));
  closeWorlds();
});

test('looking back shows where bodies were, and simulates nothing', async () => {
  const of = await scene();
  const timeline = await recorded(of);
  of.step(60);
  const then = heights(of);
  of.step(120);
  const { stepsTaken } = of;
  timeline.seek(0.5);
  assert.deepEqual(heights(of).map(Math.fround), then.map(Math.fround));
  assert.ok(Math.abs(timeline.at! - 0.5) < 1e-9);
  assert.equal(of.stepsTaken, stepsTaken);
  closeWorlds();
});

test('going on from where one looks is the run from there, to the bit', async () => {
  const [plain, of] = [await scene(), await scene()];
  const timeline = await recorded(of);
  of.step(400);
  timeline.seek(1.7);
  of.resume();
  assert.equal(timeline.at, undefined);
  assert.ok(Math.abs(of.time - 1.7) < 1e-9);
  plain.step(204);
  assert.equal(hashOf(of), hashOf(plain));
  plain.step(300);
  of.step(300);
  assert.equal(hashOf(of), hashOf(plain));
  closeWorlds();
});

test('what was done before where one looks has been done, and what came after has not', async () => {
  const [plain, of] = [await scene(), await scene()];
  const timeline = await recorded(of);
  const early = (on: World): void => {
    body(on, 'b2').applyImpulse([3, 2, 1]);
    body(on, 'bob').set('mass', 5);
    on.add('RigidBody', { position: [0, 12, 0], geometry: [box] }, { name: 'late' });
  };
  for (const each of [plain, of]) {
    each.step(130);
    early(each);
    each.step(20);
  }
  body(of, 'b0').set('fixed', true);
  of.set('gravity', [0, 5, 0]);
  of.step(100);
  timeline.seek(150 / 120);
  of.resume();
  assert.equal(body(of, 'b0').get('fixed'), false);
  assert.equal(body(of, 'bob').get('mass'), 5);
  plain.step(100);
  of.step(100);
  assert.equal(hashOf(of), hashOf(plain));
  closeWorlds();
});

test('a drag that was under way is run anew with it', async () => {
  const [plain, of] = [await scene(), await scene()];
  const timeline = await recorded(of);
  for (const each of [plain, of]) {
    each.step(90);
    const drag = body(each, 'b5').drag([0.7, 6, 0])!;
    for (let i = 0; i < 60; i++) {
      drag.move([0.7 + i / 20, 6 + i / 40, 0]);
      each.step();
    }
    drag.end();
    each.step(30);
  }
  const then = hashOf(plain);
  of.step(60);
  timeline.seek(1.5);
  of.resume();
  assert.equal(hashOf(of), then);
  closeWorlds();
});

test('a step goes on from where one looks', async () => {
  const of = await scene();
  const timeline = await recorded(of);
  of.step(240);
  timeline.seek(1);
  of.step();
  assert.ok(Math.abs(of.time - 121 / 120) < 1e-9);
  assert.equal(timeline.at, undefined);
  closeWorlds();
});

test('what is done while one looks back is done when time goes on', async () => {
  const of = await scene();
  const timeline = await recorded(of);
  of.step(240);
  timeline.seek(1);
  body(of, 'bob').set('mass', 7);
  of.resume();
  assert.equal(body(of, 'bob').get('mass'), 7);
  closeWorlds();
});

test('of many edits of a field while one looks back the last one counts, and is recorded in its turn', async () => {
  const [plain, of] = [await scene(), await scene()];
  const timeline = await recorded(of);
  of.step(240);
  timeline.seek(1);
  for (const mass of [2, 3, 9]) body(of, 'bob').set('mass', mass);
  of.step(120);
  plain.step(120);
  body(plain, 'bob').set('mass', 9);
  plain.step(120);
  assert.equal(hashOf(of), hashOf(plain));
  timeline.seek(1.5);
  of.resume();
  of.step(60);
  assert.equal(hashOf(of), hashOf(plain));
  closeWorlds();
});

test('who takes hold of a body while looking back goes on from there', async () => {
  const [plain, of] = [await scene(), await scene()];
  const timeline = await recorded(of);
  of.step(240);
  plain.step(120);
  timeline.seek(1);
  for (const each of [of, plain]) {
    const drag = body(each, 'bob').drag(body(each, 'bob').get('position') as Vec3)!;
    drag.move([5, 6, 0]);
    each.step(60);
  }
  assert.equal(timeline.at, undefined);
  assert.equal(hashOf(of), hashOf(plain));
  closeWorlds();
});

test('a snapshot is of where one looks', async () => {
  const [plain, of] = [await scene(), await scene()];
  const timeline = await recorded(of);
  of.step(240);
  plain.step(120);
  timeline.seek(1);
  const there = of.snapshot();
  assert.equal(of.time, 2);
  of.resume();
  of.step(30);
  of.restore(there);
  assert.equal(hashOf(of), hashOf(plain));
  closeWorlds();
});

test('at the end nothing is gone back to: what was done since the last step stays', async () => {
  const of = await scene();
  const timeline = await recorded(of);
  of.step(121);
  const then = hashOf(of);
  body(of, 'bob').set('mass', 8);
  timeline.seek(of.time);
  of.resume();
  assert.equal(hashOf(of), then);
  assert.equal(body(of, 'bob').get('mass'), 8);
  closeWorlds();
});

fact('what is done to a shape that came with its body is run anew', async () => {
  const of = await scene();
  const timeline = await recorded(of);
  of.step(10);
  const late = of.add('RigidBody', { position: [0, 9, 0], geometry: [box] });
  of.step(10);
  const [shape] = late.get('geometry') as [Node];
  shape.set('shape', [{ type: 'Sphere', radius: 0.7 }]);
  of.step(100);
  timeline.seek(1);
  of.resume();
  assert.deepEqual(of.problems, []);
  closeWorlds();
});

test('so many seconds are kept, and one more at most', async () => {
  const of = await scene();
  const timeline = await recorded(of, 2);
  of.step(600);
  assert.equal(timeline.to, 5);
  assert.ok(timeline.from <= 3 && timeline.from >= 2, String(timeline.from));
  timeline.seek(0);
  assert.equal(timeline.at, timeline.from);
  closeWorlds();
});

test('each 60 steps have a hash, the same in each run', async () => {
  const [one, other] = [await scene(), await scene()];
  const timelines = [await recorded(one), await recorded(other)];
  one.step(240);
  for (let i = 0; i < 240; i++) other.step();
  assert.deepEqual(
    timelines[0]!.hashes.map(({ step }) => step),
    [60, 120, 180, 240],
  );
  assert.deepEqual(timelines[0]!.hashes, timelines[1]!.hashes);
  closeWorlds();
});

test('hashes are those of the browsers', async () => {
  assert.deepEqual(
    (await towerRun()).map(({ hash }) => hash),
    HASHES,
  );
});

test('a reset begins the recording anew', async () => {
  const of = await scene();
  const timeline = await recorded(of);
  of.step(240);
  of.reset();
  assert.equal(of.timeline, timeline);
  assert.deepEqual([timeline.from, timeline.to], [0, 0]);
  of.step(120);
  assert.equal(timeline.to, 1);
  closeWorlds();
});

fact('marks tell what was done, and when', async () => {
  const of = await scene();
  const timeline = await recorded(of);
  of.step(60);
  body(of, 'bob').set('mass', 7);
  of.step(60);
  const mark = timeline.marks.find(({ text }) => text.includes('mass'))!;
  assert.equal(mark.text, 'RigidBody "bob": set mass');
  assert.ok(Math.abs(mark.time - 0.5) < 0.02);
  closeWorlds();
});

fact('an import that is given up leaves the world as it was', async () => {
  const from = await scene();
  await recorded(from);
  from.step(120);
  const to = await scene();
  const before = hashOf(to);
  await assert.rejects(to.importRun(from.exportRun()!, { signal: AbortSignal.abort() }));
  assert.equal(hashOf(to), before);
  assert.equal(to.timeline, undefined);
  closeWorlds();
});

test('a world ends while somebody looks back without a word', async () => {
  const of = await scene();
  const timeline = await recorded(of);
  of.step(100);
  timeline.seek(0.5);
  of.destroy();
  assert.equal(of.timeline, undefined);
  assert.deepEqual(of.problems, []);
  closeWorlds();
});

test('stopped, nothing is kept, and the world runs on as it would have', async () => {
  const [plain, of] = [await scene(), await scene()];
  const timeline = await recorded(of);
  of.step(100);
  timeline.stop();
  assert.equal(of.timeline, undefined);
  of.step(100);
  plain.step(200);
  assert.equal(hashOf(of), hashOf(plain));
  closeWorlds();
});

test('an exported run runs anew in another world of the scene, and in an empty one', async () => {
  const from = await scene();
  await recorded(from);
  from.step(100);
  body(from, 'b4').applyImpulse([2, 0, 0]);
  from.step(150);
  const run = JSON.parse(JSON.stringify(from.exportRun()!));
  for (const to of [await scene(), await world()]) {
    const timeline = (await to.importRun(run))!;
    assert.equal(hashOf(to), hashOf(from));
    assert.deepEqual(timeline.hashes, from.timeline!.hashes);
    timeline.seek(1);
    to.resume();
    assert.ok(Math.abs(to.time - 1) < 1e-9);
  }
  closeWorlds();
});

test('a run that goes another way says at which step', async () => {
  const from = await scene();
  await recorded(from);
  from.step(300);
  const run = from.exportRun()!;
  run.hashes[2]!.hash = '00000000';
  const to = await scene();
  claim(to, 'run-diverged');
  await to.importRun(run);
  assert.match(told(to, 'run-diverged')[0]!, /step 180/);
  assert.ok(Math.abs(to.time - 1.5) < 1e-9);
  closeWorlds();
});

test('a run of another scene is told, and nothing is done', async () => {
  const from = await scene();
  await recorded(from);
  from.step(60);
  const few = await world();
  few.add('RigidBody', { geometry: [box] }, { name: 'b1' });
  const others = await scene();
  others.node('b4')!.remove();
  for (const to of [few, others]) {
    claim(to, 'bad-value');
    to.step(1);
    const before = hashOf(to);
    assert.equal(await to.importRun(from.exportRun()!), undefined);
    assert.match(told(to, 'bad-value')[0]!, /^this run is of another scene/);
    assert.equal(hashOf(to), before);
  }
  closeWorlds();
});

test('what is no run, no time and no number of seconds is told, and nothing is done', async () => {
  const of = await scene();
  claim(of, 'bad-value');
  const timeline = await recorded(of);
  of.step(60);
  const before = hashOf(of);
  assert.equal(await of.importRun({} as never), undefined);
  const run = of.exportRun()!;
  const evil = { ...run, calls: [{ step: 0, next: 1, singly: true, method: 'destroy', args: [] }] };
  assert.equal(await of.importRun(evil), undefined);
  assert.equal(await of.importRun({ ...run, x3dPhysicsRun: 99 } as never), undefined);
  assert.equal(await of.importRun({ ...run, steps: 1e12 }), undefined);
  for (const broken of [
    { ...run, calls: [null] },
    { ...run, hashes: [null] },
    { ...run, start: { ...run.start, nodes: [] } },
    { ...run, calls: [{ step: 0, next: 1, singly: true, method: 'add', args: ['Nothing'] }] },
  ])
    assert.equal(await of.importRun(JSON.parse(JSON.stringify(broken))), undefined);
  timeline.seek(NaN);
  assert.equal(timeline.at, undefined);
  assert.equal(hashOf(of), before);
  assert.equal(told(of, 'bad-value').length > 0, true);
  closeWorlds();
});
