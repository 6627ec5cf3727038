import assert from 'node:assert/strict';
import { loadEngine, World } from '../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  claim,
  close,
  fact,
  height,
  position,
  random,
  watch,
  way,
  world,
  type Body,
} from './helpers.js';

/** Poses of all bodies after every step, as bits. */
function recorded(w: World): number[][] {
  const log: number[][] = [];
  w.on('afterstep', () => log.push([...w.bodies].flatMap((body) => body.readPose([]) as number[])));
  return log;
}

/** Boxes that fall on each other, a pendulum and a motor. */
function busy(w: World): void {
  // Its bodies begin a little inside each other, so that they push.
  claim(w, 'initial-overlap');
  addFloor(w);
  const next = random(7);
  for (let i = 0; i < 8; i++)
    addBody(w, {
      position: [next() - 0.5, 1 + i, next() - 0.5],
      orientation: [0, 0, 1, next()],
      geometry: [box(0.8)],
    });
  const bob = addBody(w, { position: [4, 6, 0], mass: 3 });
  addJoint(w, 'SingleAxisHingeJoint', {
    body1: bob,
    anchorPoint: [3, 6, 0],
    axis: [0, 0, 1],
    minAngle: -1,
    stopBounce: 0.5,
  });
  w.add('MotorJoint', { body1: bob, axis1Torque: 0.5 });
}

/** Where a body is drawn. */
const drawn = (w: World, body: Body): number[] => [
  ...w.poses.data.slice(body.slot * 7, body.slot * 7 + 3),
];

// ---- start -----------------------------------------------------------------------------------------------------------

fact('before its start a world takes nodes and edits, steps nothing and returns 0', async () => {
  const w = new World();
  const ball = addBody(w, { position: [0, 1, 0] });
  ball.set('position', [0, 7, 0]);
  assert.equal(w.step(), 0);
  assert.equal(w.advance(1), 0);
  assert.equal(w.frame(1 / 60), false);
  assert.equal(w.time, 0);
  assert.equal(w.started, false);
  close(ball.get('position') as number[], [0, 7, 0], 0);
  w.start(await loadEngine());
  watch(w);
  assert.equal(await w.ready, w);
  w.step(60);
  close(height(ball), 7 - way(9.8, 0.5), 1e-4, 'm');
});

fact('ready rejects with the problem of a world that can not start', async () => {
  const w = new World();
  w.lifecycle.ready.reject({ code: 'engine-load-failed' });
  await assert.rejects(w.ready, { code: 'engine-load-failed' });
});

fact('a world tells when it is ready, once', async () => {
  const w = new World();
  let times = 0;
  w.on('ready', () => times++);
  const engine = await loadEngine();
  w.start(engine);
  w.start(engine);
  watch(w);
  assert.equal(times, 1);
});

// ---- steps -----------------------------------------------------------------------------------------------------------

fact('step and advance return the seconds they advanced, paused or not', async () => {
  const w = await world();
  w.paused = true;
  assert.equal(w.step(), 1 / 120);
  assert.equal(w.step(3), 3 / 120);
  assert.equal(w.advance(0.5), 0.5);
  assert.equal(w.advance(-1), 0);
  close(w.time, 64 / 120, 1e-12, 's');
});

fact('step(0) applies pending edits and advances nothing', async () => {
  const w = await world();
  const ball = addBody(w);
  assert.equal(w.stats.bodies, 0);
  assert.equal(w.step(0), 0);
  assert.equal(w.stats.bodies, 1);
  assert.equal(w.time, 0);
  close(height(ball), 0, 0, 'm');
});

fact('advance takes steps of the level that an edit just asked for', async () => {
  const w = await world();
  w.set('accuracy', 'game');
  assert.equal(w.advance(1), 1);
  w.set('accuracy', 'fine');
  assert.equal(w.advance(1), 1);
  close(w.time, 2, 1e-9, 's');
});

fact('beforestep and afterstep come once per step, around it', async () => {
  const w = await world();
  const ball = addBody(w, { linearVelocity: [1, 0, 0] });
  const log: string[] = [];
  for (const event of ['beforestep', 'afterstep'])
    w.on(event, () => log.push(`${event} ${Math.round(position(ball)[0] * 120)}`));
  w.step(2);
  assert.deepEqual(log, ['beforestep 0', 'afterstep 1', 'beforestep 1', 'afterstep 2']);
});

fact('edits, forces and teleports made in beforestep act in that very step', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const [pushed, moved, fast] = [
    addBody(w),
    addBody(w, { position: [5, 0, 0] }),
    addBody(w, { position: [9, 0, 0] }),
  ];
  w.step(0);
  const stop = w.on('beforestep', () => {
    pushed.applyForce([120, 0, 0]);
    moved.teleport([5, 3, 0]);
    fast.set('linearVelocity', [0, 0, 12]);
  });
  w.step();
  stop();
  close(position(pushed), [1 / 120, 0, 0], 1e-6, 'm');
  close(position(moved), [5, 3, 0], 1e-6, 'm');
  close(position(fast), [9, 0, 0.1], 1e-5, 'm');
});

fact('edits made in afterstep act in the next step', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w);
  w.step(0);
  const stop = w.on('afterstep', () => ball.set('linearVelocity', [12, 0, 0]));
  w.step();
  stop();
  close(position(ball), [0, 0, 0], 0, 'm');
  w.step();
  close(position(ball), [0.1, 0, 0], 1e-6, 'm');
});

fact('a listener that throws stops neither the step nor the others', async () => {
  const w = await world();
  const ball = addBody(w);
  let heard = 0;
  // The error goes to the page by a microtask, where it counts as uncaught.
  const later: (() => void)[] = [];
  const { queueMicrotask } = globalThis;
  globalThis.queueMicrotask = (task) => later.push(task);
  w.on('beforestep', () => {
    throw new Error('mine');
  });
  w.on('beforestep', () => heard++);
  w.step(1);
  globalThis.queueMicrotask = queueMicrotask;
  assert.equal(heard, 1);
  close(height(ball), -way(9.8, 1 / 120), 1e-6, 'm');
  assert.equal(later.length, 1);
  assert.throws(later[0]!, /mine/);
});

// ---- frames ----------------------------------------------------------------------------------------------------------

fact('the motion is the same, bit for bit, at 30, 60, 144 and 240 frames per second', async () => {
  const runs: number[][][] = [];
  for (const rate of [30, 60, 144, 240]) {
    const w = await world();
    busy(w);
    const log = recorded(w);
    for (let i = 0; i < 2 * rate; i++) w.frame(1 / rate);
    assert.ok(log.length >= 239 && log.length <= 240, `${log.length} steps in 2 s at ${rate} Hz`);
    runs.push(log);
  }
  for (const log of runs) assert.deepEqual(log.slice(0, 239), runs[0]!.slice(0, 239));
});

fact(
  'between two steps a body is drawn between their poses, evenly at a constant speed',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const ball = addBody(w, { linearVelocity: [1.2, 0, 0], angularVelocity: [0, 0, 1.2] });
    w.frame(1 / 480);
    let last: number | undefined;
    for (let i = 0; i < 48; i++) {
      w.frame(1 / 480);
      const [x] = drawn(w, ball);
      const angle = 2 * Math.asin(w.poses.data[ball.slot * 7 + 5]!);
      close(angle, x!, 1e-5, 'rad, turning as it goes');
      if (last !== undefined && i > 3) close(x! - last, 1.2 / 480, 1e-6, 'm per frame');
      last = x;
    }
  },
);

fact('a teleport is drawn at once, not smeared over a frame', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { linearVelocity: [1, 0, 0] });
  for (let i = 0; i < 5; i++) w.frame(1 / 480);
  ball.set('position', [50, 0, 0]);
  w.frame(1 / 480);
  assert.ok(drawn(w, ball)[0]! >= 50, `drawn at ${drawn(w, ball)[0]}`);
  ball.teleport([-50, 0, 0]);
  w.frame(1 / 480);
  assert.ok(drawn(w, ball)[0]! <= -49.9, `drawn at ${drawn(w, ball)[0]}`);
});

fact(
  'after a hidden tab of ten seconds the work is bounded and a stack still stands (S11)',
  async () => {
    const w = await world();
    claim(w, 'lag');
    addFloor(w);
    const stack = [0, 1, 2, 3, 4].map((i) =>
      addBody(w, { position: [0, 0.5 + i, 0], geometry: [box(1)] }),
    );
    for (let i = 0; i < 60; i++) w.frame(1 / 60);
    let steps = 0;
    w.on('afterstep', () => steps++);
    const lags: { dropped: number }[] = [];
    w.on('lag', (lag) => lags.push(lag as { dropped: number }));
    w.frame(10);
    assert.ok(steps <= 12, `${steps} steps`);
    close(lags[0]!.dropped, 10 - steps / 120, 1 / 120 + 1e-9, 's dropped');
    for (let i = 0; i < 60; i++) w.frame(1 / 60);
    stack.forEach((body, i) => close(position(body), [0, 0.5 + i, 0], 0.02, 'm'));
  },
);

fact('a frame whose steps take too long takes fewer and reports the time it drops', async () => {
  const w = await world();
  addBody(w);
  w.step();
  let dropped = 0;
  w.on('lag', (lag) => (dropped += (lag as { dropped: number }).dropped));
  const { now } = performance;
  let clock = 0;
  performance.now = () => (clock += 15);
  w.frame(0.1);
  performance.now = now;
  assert.ok(w.time < 0.05, `${w.time} s taken`);
  close(w.time + dropped, 0.1 + 1 / 120, 1e-9, 's');
});

fact('a fixed body that jumps is drawn where it is, however many steps a frame takes', async () => {
  for (const rate of [30, 60, 144]) {
    const w = await world();
    addBody(w, { position: [0, 50, 0] });
    const post = addBody(w, { fixed: true, position: [1, 2, 3] });
    w.frame(1 / rate);
    close(drawn(w, post), [1, 2, 3], 1e-6, `m at ${rate} Hz`);
    post.set('position', [9, 2, 3]);
    w.frame(1 / rate);
    close(drawn(w, post), [9, 2, 3], 1e-6, `m at ${rate} Hz, moved`);
    for (let i = 0; i < 30; i++) w.frame(1 / rate);
    assert.ok(![...w.poses.moved.slice(0, w.poses.movedCount)].includes(post.slot), 'drawn once');
  }
});

fact('frames of zero, negative or no time advance nothing (S26)', async () => {
  const w = await world();
  const ball = addBody(w, { position: [0, 5, 0] });
  for (const seconds of [0, -1, NaN]) w.frame(seconds);
  assert.equal(w.time, 0);
  for (let i = 0; i < 60; i++) w.frame(1 / 60);
  close(height(ball), 5 - way(9.8, 1), 1e-3, 'm after a second of true frames');
});

fact('timeScale stretches time, paused stops it; steps asked for act all the same', async () => {
  const w = await world();
  const ball = addBody(w);
  w.timeScale = 0.5;
  for (let i = 0; i < 60; i++) w.frame(1 / 60);
  close(w.time, 0.5, 1e-9, 's');
  w.paused = true;
  for (let i = 0; i < 60; i++) w.frame(1 / 60);
  close(w.time, 0.5, 1e-9, 's, paused');
  w.step(60);
  close(height(ball), -way(9.8, 1), 1e-3, 'm');
  w.paused = false;
  w.timeScale = 1;
  for (let i = 0; i < 60; i++) w.frame(1 / 60);
  close(w.time, 2, 1e-9, 's');
});

fact(
  'at timeScale 10 a world runs ten times as fast, at 60 frames per second and at 20',
  async () => {
    for (const rate of [20, 60]) {
      const w = await world();
      const ball = addBody(w);
      w.timeScale = 10;
      let lag = 0;
      w.on('lag', () => lag++);
      for (let i = 0; i < rate / 2; i++) w.frame(1 / rate);
      close(w.time, 5, 1e-6, 's in half a second');
      close(height(ball), -4.9 * 25, 0.5, 'm');
      assert.equal(lag, 0);
    }
  },
);

fact('in slow motion a slow frame loses nothing', async () => {
  const w = await world();
  w.timeScale = 0.1;
  w.frame(0.5);
  close(w.time, 0.05, 1e-9, 's');
});

fact(
  'a machine that does not keep up drops time and takes ever the same work (no spiral)',
  async () => {
    const w = await world();
    claim(w, 'lag');
    addBody(w);
    w.step();
    const { now } = performance;
    let clock = 0;
    let steps = 0;
    w.on('beforestep', () => {
      clock += 20;
      steps++;
    });
    performance.now = () => clock;
    w.timeScale = 100;
    try {
      let dropped = 0;
      w.on('lag', (lag) => (dropped += (lag as { dropped: number }).dropped));
      const start = w.time;
      for (let i = 0; i < 50; i++) {
        steps = 0;
        const before = clock;
        w.frame(0.1);
        // 50 ms are over within the third step of 20 ms.
        assert.equal(steps, 3);
        assert.equal(clock - before, 60);
      }
      close(w.time - start + dropped, 100 * 50 * 0.1, 0.01, 's, taken or dropped');
    } finally {
      performance.now = now;
    }
  },
);

// ---- reset -----------------------------------------------------------------------------------------------------------

fact('reset and n steps are the first n steps, bit for bit', async () => {
  const w = await world();
  busy(w);
  w.add('CollisionCollection', { collidables: '*', bounce: 0.3 });
  const log = recorded(w);
  w.step(180);
  const first = log.splice(0);
  w.reset();
  assert.equal(w.time, 0);
  w.step(180);
  assert.deepEqual(log, first);
  w.reset();
  w.reset();
  log.length = 0;
  w.step(60);
  assert.deepEqual(log, first.slice(0, 60));
});

fact('reset goes back to what was asked last, and ends what only the run did', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { position: [1, 0, 0], linearVelocity: [1, 0, 0] });
  w.advance(1);
  ball.set('position', [5, 0, 0]);
  ball.applyForce([1000, 0, 0]);
  w.reset();
  close(position(ball), [5, 0, 0], 0, 'm');
  w.advance(1);
  close(position(ball), [6, 0, 0], 1e-4, 'm');
});

fact('two worlds step side by side as each does alone', async () => {
  const alone = await world();
  busy(alone);
  const log = recorded(alone);
  alone.step(120);
  const [a, b] = [await world(), await world({ gravity: [0, 0, -20] })];
  busy(a);
  busy(b);
  b.add('CollisionCollection', { collidables: '*', bounce: 1 });
  const both = recorded(a);
  for (let i = 0; i < 120; i++) {
    a.step();
    b.step();
  }
  assert.deepEqual(both, log);
});

fact('time is counted in steps, so that it does not round', async () => {
  const w = await world();
  w.step(1200);
  assert.equal(w.time, 10);
  w.accuracy = 'fine';
  w.step(240);
  assert.equal(w.time, 11);
});

fact(
  'a step asked for within a step does nothing, and odd counts are whole steps or none',
  async () => {
    const w = await world();
    addBody(w);
    const inner: number[] = [];
    const stop = w.on('beforestep', () => inner.push(w.step(1)));
    assert.equal(w.step(2), 2 / 120);
    stop();
    assert.deepEqual(inner, [0, 0]);
    close(w.step(1.9), 1 / 120, 1e-12, 's');
    for (const none of [-1, NaN, 0]) assert.equal(w.step(none), 0);
    assert.equal(w.advance(NaN), 0);
    close(w.time, 3 / 120, 1e-12, 's');
  },
);

fact('timeScale refuses what is no speed, and keeps the last one', async () => {
  const w = await world();
  claim(w, 'bad-value');
  w.timeScale = 0.5;
  w.timeScale = NaN;
  w.timeScale = -1;
  assert.equal(w.timeScale, 0.5);
});

fact('reset undoes what events did, and the author may say the same again', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  claim(w, 'unchanged-value');
  const ball = addBody(w, { position: [0, 9, 0], mass: 2 });
  w.step();
  ball.event('position', [7, 7, 7]);
  ball.event('linearDampingFactor', 0.5);
  w.step();
  close(position(ball), [7, 7, 7], 1e-6, 'm');
  const { patched } = w.stats;
  ball.set('position', [0, 9, 0]);
  w.step();
  assert.equal(w.stats.patched, patched);
  w.reset();
  close(position(ball), [0, 9, 0], 1e-6, 'm');
  assert.equal(ball.asked('linearDampingFactor'), 0.001);
});
