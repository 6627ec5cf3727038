import assert from 'node:assert/strict';
import { debugLines } from '../../../physics-core/debug-lines.js';
import { debugging, World, type Timeline } from '../../../physics-core/inside.js';
import { COLOR } from '../../../physics-core/effects/debug/colors.js';
import { POSE } from '../../../physics-core/dynamics/poses.js';
import type { Recording } from '../../../physics-core/timeline/recording.js';
import { hashOf } from '../../../physics-core/timeline/hash.js';
import {
  above,
  addBody,
  addFloor,
  below,
  box,
  claim,
  close,
  distance,
  fact,
  position,
  told,
  world,
  type Body,
  type Vec3,
} from '../helpers.js';

type Pose = readonly number[];

/** A pendulum, and a stack that leans and falls. */
async function scene(fields = {}): Promise<World> {
  const made = await world(fields);
  addFloor(made);
  for (let i = 0; i < 5; i++)
    made.add('RigidBody', { position: [i / 4, 0.5 + i, 0], geometry: [box(1)] }, { name: `b${i}` });
  const bob = made.add('RigidBody', { position: [6, 6, 0], geometry: [box(1)] }, { name: 'bob' });
  made.add('BallJoint', { body1: bob, anchorPoint: [9, 6, 0] });
  return made;
}

const body = (of: World, name: string): Body => of.node(name) as Body;

/** In single precision, as pictures have them. */
const posesIn = (of: World): Map<number, Pose> =>
  new Map(
    [...of.bodies].map(({ id, slot }) => [
      id,
      [...of.poses.current.subarray(slot * POSE, (slot + 1) * POSE)].map(Math.fround),
    ]),
  );

function ghostsOf(timeline: Timeline): Map<number, Pose> {
  const found = new Map<number, Pose>();
  (timeline as Recording).eachGhost((id, pose) => found.set(id, [...pose]));
  return found;
}

/** Whether another run has all bodies where the ghost has them at a time, to the last bit. */
function assertIs(timeline: Timeline, time: number, own: World): void {
  own.flush();
  timeline.seek(time);
  close(timeline.at!, time, 1e-9);
  close(own.time, time, 1e-9);
  assert.deepEqual(ghostsOf(timeline), posesIn(own), `${time} s`);
}

/** What is done in the middle. */
function strike(of: World): void {
  body(of, 'bob').applyImpulse([1, 2, 3]);
  body(of, 'b2').set('mass', 4);
}

/** Runs for so many seconds, struck after some. */
function run(of: World, seconds: number, struck: number): void {
  of.advance(struck);
  strike(of);
  of.advance(seconds - struck);
}

for (const level of ['game', 'standard', 'fine'] as const)
  fact(`a ghost at the run's own level coincides, to the last bit: ${level}`, async () => {
    const of = await scene({ accuracy: level });
    const timeline = await of.record();
    run(of, 2, 0.75);
    await timeline.ghost(level);
    for (const time of [0, 0.5, 1, 1.5, 2]) {
      timeline.seek(time);
      assert.equal(timeline.apart, 0, `${time} s`);
      assert.equal(ghostsOf(timeline).size, 7);
    }
  });

for (const [of, at] of [
  ['standard', 'game'],
  ['standard', 'precise'],
  ['game', 'fine'],
] as const)
  fact(
    `a ghost of a run at ${of} is where a run at ${at} is, to the last bit, with what was done at its time`,
    async () => {
      const [recorded, own] = [await scene({ accuracy: of }), await scene({ accuracy: at })];
      const timeline = await recorded.record();
      run(recorded, 2, 0.75);
      await timeline.ghost(at);
      assert.equal(timeline.ghostLevel, at);
      assertIs(timeline, 0, own);
      own.advance(0.75);
      assertIs(timeline, 0.75, own);
      strike(own);
      for (const time of [1, 1.5, 2]) {
        own.advance(time - own.time);
        assertIs(timeline, time, own);
      }
      above(timeline.apart!, 1e-4);
    },
  );

fact('what is done between two steps of the ghost is done in the next one', async () => {
  const [of, own] = [await scene(), await scene({ accuracy: 'game' })];
  const timeline = await of.record();
  of.step(31);
  strike(of);
  of.step(59);
  await timeline.ghost('game');
  own.step(16);
  strike(own);
  own.step(29);
  assertIs(timeline, 0.75, own);
});

fact(
  'where the run has a step and the ghost has none, it is between its two: a falling ball, within half a millimetre',
  async () => {
    const of = await world();
    addBody(of, { position: [0, 20, 0], linearVelocity: [3, 0, 0] });
    const timeline = await of.record();
    of.step(121);
    await timeline.ghost('game');
    timeline.seek(of.time);
    close(timeline.at!, 121 / 120, 1e-9);
    // g dt²/8 is .34 mm, single precision leaves .1 mm, and in half a step of the ghost it falls by 8 cm.
    below(timeline.apart!, 5e-4);
  },
);

for (const level of ['game', 'reference'] as const)
  fact(
    `a force that is asked for in each step has the same impulse in the ghost: ${level}`,
    async () => {
      const of = await world({ gravity: [0, 0, 0] });
      const pushed = addBody(of, { mass: 2 });
      const timeline = await of.record();
      const stop = of.on('beforestep', () => pushed.applyForce([4, 0, 0]));
      of.step(60);
      stop();
      of.step(60);
      close(position(pushed), [0.25 + 0.5, 0, 0], 0.02);
      await timeline.ghost(level);
      timeline.seek(1);
      // The impulse of a step acts at its beginning, whichever step that is.
      close(timeline.apart!, 0, 0.01);
    },
  );

fact('the level stays that of the ghost, whatever the run was asked for', async () => {
  const [of, own] = [await scene(), await scene({ accuracy: 'fine' })];
  const timeline = await of.record();
  of.step(60);
  of.accuracy = 'game';
  of.step(30);
  await timeline.ghost('fine');
  own.step(240);
  assertIs(timeline, 1, own);
});

fact('apart is the greatest distance of a body from its ghost', async () => {
  const [of, own] = [await scene(), await scene({ accuracy: 'game' })];
  const timeline = await of.record();
  of.step(240);
  own.step(120);
  const far = [...of.bodies].map(({ id }) =>
    distance(position(of.node(id)!), position(own.node(id)!)),
  );
  await timeline.ghost('game');
  timeline.seek(2);
  above(timeline.apart!, 0.001);
  close(timeline.apart!, Math.max(...far), 1e-5);
});

fact('bodies that one of the runs does not have are left out', async () => {
  const of = await scene();
  const timeline = await of.record();
  of.step(61);
  const late = addBody(of, { position: [0, 20, 0], linearVelocity: [9, 0, 0] });
  of.step(60);
  const { id } = body(of, 'bob');
  body(of, 'bob').remove();
  of.step(59);
  await timeline.ghost('game');
  timeline.seek(0.5);
  assert.equal(ghostsOf(timeline).has(late.id), false);
  timeline.seek(62 / 120);
  assert.equal(ghostsOf(timeline).has(late.id), false);
  timeline.seek(1.5);
  assert.equal(ghostsOf(timeline).has(late.id), true);
  assert.equal(ghostsOf(timeline).has(id), false);
});

const isDrawn = (of: World): boolean => of.registry.active(debugging);

fact('nobody looks: there is nothing to compare or to draw', async () => {
  const of = await scene();
  const timeline = await of.record();
  of.step(120);
  await timeline.ghost('game');
  assert.equal(timeline.apart, undefined);
  assert.equal(isDrawn(of), false);
  timeline.seek(0.5);
  assert.equal(isDrawn(of), true);
  of.resume();
  assert.equal(isDrawn(of), false);
  assert.equal(timeline.apart, undefined);
});

/** No ghost is there, and none is drawn. */
function assertNone(of: World, timeline: Timeline): void {
  timeline.seek(0.5);
  assert.equal(timeline.ghostLevel, undefined);
  assert.equal(timeline.apart, undefined);
  assert.equal(ghostsOf(timeline).size, 0);
  assert.equal(isDrawn(of), false);
}

fact('taken away, nothing of it is left', async () => {
  const of = await scene();
  const timeline = await of.record();
  of.step(120);
  await timeline.ghost('game');
  timeline.seek(0.5);
  await timeline.ghost();
  assertNone(of, timeline);
  await timeline.ghost('game');
  timeline.stop();
  assert.equal(timeline.ghostLevel, undefined);
  assert.equal(isDrawn(of), false);
});

/** Slices of a step or two: in this process the clock stands. */
async function inSmallSlices(work: () => Promise<void>): Promise<void> {
  const { now } = performance;
  let time = 0;
  performance.now = () => (time += 3);
  try {
    await work();
  } finally {
    performance.now = now;
  }
}

/** Worlds that end while something goes on. */
async function ended(work: () => Promise<void>): Promise<number> {
  const { prototype } = World;
  const { destroy } = prototype;
  let count = 0;
  prototype.destroy = function () {
    count++;
    destroy.call(this);
  };
  try {
    await work();
  } finally {
    prototype.destroy = destroy;
  }
  return count;
}

fact('aborted in the middle, nothing of it is left', async () => {
  const of = await scene();
  const timeline = await of.record();
  of.step(120);
  const { signal, abort } = stopped();
  const onprogress = (done: number): void => void (done > 0.3 && abort());
  const twins = await ended(() =>
    inSmallSlices(() => assert.rejects(timeline.ghost('fine', { signal, onprogress }), /given up/)),
  );
  assert.equal(twins, 1);
  assertNone(of, timeline);
  await assert.rejects(timeline.ghost('fine', { signal }), /given up/);
  assertNone(of, timeline);
});

function stopped(): { signal: AbortSignal; abort: () => void } {
  const controller = new AbortController();
  return { signal: controller.signal, abort: () => controller.abort(new Error('given up')) };
}

fact('a later call takes the place of one that is under way, which settles', async () => {
  const of = await scene();
  const timeline = await of.record();
  of.step(120);
  await inSmallSlices(async () => {
    let second: Promise<void> | undefined;
    const onprogress = (done: number): void => {
      if (done > 0.3) second ??= timeline.ghost('game');
    };
    await timeline.ghost('fine', { onprogress });
    assert.equal(timeline.ghostLevel, 'game');
    await second;
  });
  const own = await scene({ accuracy: 'game' });
  own.step(60);
  assertIs(timeline, 1, own);
});

fact(
  'while a ghost is on its way the world goes on as it would have, and ends as it would',
  async () => {
    const [plain, of] = [await scene(), await scene()];
    const timeline = await of.record();
    of.step(120);
    await inSmallSlices(() => timeline.ghost('game', { onprogress: () => of.step(1) }));
    plain.step(of.stepsTaken);
    above(plain.stepsTaken, 150);
    assert.equal(hashOf(of), hashOf(plain));
    const twins = await ended(() =>
      inSmallSlices(() => timeline.ghost('fine', { onprogress: () => of.destroy() })),
    );
    // The world itself, in each slice after which it was told to, and the twin.
    assert.equal(twins, 2);
  },
);

fact('what came after it was run is run the next time one looks', async () => {
  const [of, own] = [await scene(), await scene({ accuracy: 'game' })];
  const timeline = await of.record();
  of.step(120);
  await timeline.ghost('game');
  of.step(60);
  timeline.seek(1.25);
  await until(() => timeline.apart !== undefined);
  own.step(75);
  assertIs(timeline, 1.25, own);
});

fact('gone on from an earlier moment, the ghost is one of what has been', async () => {
  const [of, own] = [await scene(), await scene({ accuracy: 'game' })];
  const timeline = await of.record();
  of.step(120);
  await timeline.ghost('game');
  timeline.seek(0.5);
  of.resume();
  strike(of);
  of.step(60);
  timeline.seek(0.75);
  await until(() => timeline.apart !== undefined);
  own.step(30);
  strike(own);
  own.step(15);
  assertIs(timeline, 0.75, own);
});

fact('a reset begins the ghost anew, too', async () => {
  const [of, own] = [await scene(), await scene({ accuracy: 'game' })];
  const timeline = await of.record();
  run(of, 1, 0.5);
  await timeline.ghost('game');
  of.reset();
  of.step(120);
  assert.equal(timeline.ghostLevel, 'game');
  timeline.seek(1);
  await until(() => timeline.apart !== undefined);
  strike(own);
  own.step(1);
  own.reset();
  own.step(60);
  assertIs(timeline, 1, own);
});

async function until(condition: () => boolean): Promise<void> {
  while (!condition()) await new Promise((resolve) => setTimeout(resolve));
}

fact('what is no level is told, and the ghost that is there stays', async () => {
  const of = await scene();
  claim(of, 'bad-value');
  const timeline = await of.record();
  of.step(60);
  await timeline.ghost('game');
  await timeline.ghost('best' as never);
  assert.match(told(of, 'bad-value')[0]!, /game, standard, fine, precise, reference.*best/);
  assert.equal(timeline.ghostLevel, 'game');
});

fact('an exported run says nothing of ghosts', async () => {
  const of = await scene();
  const timeline = await of.record();
  run(of, 1, 0.5);
  const before = JSON.stringify(of.exportRun());
  await timeline.ghost('game');
  assert.equal(JSON.stringify(of.exportRun()), before);
  assert.deepEqual(Object.keys(of.exportRun()!.calls[0]!).sort(), [
    'args',
    'method',
    'next',
    'node',
    'singly',
    'step',
  ]);
});

/** Where lines of a colour end. */
function endsOf({ positions, colors, count }: Lines, color: readonly number[]): Vec3[] {
  const ends: Vec3[] = [];
  for (let i = 0; i < 2 * count; i++)
    if (distance([...colors.subarray(3 * i, 3 * i + 3)], color) < 1e-6)
      ends.push([...positions.subarray(3 * i, 3 * i + 3)] as Vec3);
  return ends;
}

type Lines = Awaited<ReturnType<typeof debugLines>>;

fact(
  'the debug drawing has ghosts of what moves, in a colour of their own, and can draw nothing else',
  async () => {
    const of = await world({ gravity: [0, 0, 0] });
    addFloor(of);
    // Its centre of mass lies off its origin, and it turns.
    const turning = addBody(of, {
      geometry: [{ ...box(1), translation: [3, 0, 0] }],
      position: [0, 5000, 0],
      angularVelocity: [0, 0, 2],
    });
    const timeline = await of.record();
    of.step(60);
    const lines = await debugLines(of);
    await timeline.ghost('standard');
    lines.update();
    assert.equal(endsOf(lines, COLOR.ghost).length, 0);
    const awake = endsOf(lines, COLOR.awake);
    timeline.seek(of.time);
    lines.update();
    assert.equal(lines.count, 12 + 12 + 3 + 12);
    assert.deepEqual(
      endsOf(lines, COLOR.ghost).map((end) => end.map((x) => x.toFixed(2))),
      awake.map((end) => end.map((x) => x.toFixed(2))),
    );
    lines.updateGhosts();
    assert.equal(lines.count, 12);
    timeline.seek(0);
    lines.updateGhosts();
    for (const end of endsOf(lines, COLOR.ghost)) {
      close(Math.abs(end[0] - 3), 0.5, 1e-3);
      close(Math.abs(end[1] - 5000), 0.5, 1e-3);
    }
    assert.ok(turning.movable);
    lines.dispose();
  },
);
