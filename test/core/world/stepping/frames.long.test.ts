import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  box,
  claim,
  close,
  fact,
  height,
  position,
  way,
  world,
} from '../../helpers.js';
import { recorded, busy } from '../runs.js';

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
  addBody(w);
  w.timeScale = 0.1;
  w.frame(0.5);
  close(w.time, 0.05, 1e-9, 's');
});

fact('frames take no step where nothing is awake, and what wakes goes on from there', async () => {
  const w = await world();
  const ball = addBody(w, { linearVelocity: [1, 0, 0] });
  for (let i = 0; i < 60; i++) w.frame(1 / 60);
  ball.sleep();
  let told = 0;
  w.on('beforestep', () => told++);
  for (let i = 0; i < 60; i++) w.frame(1 / 60);
  assert.deepEqual([w.time, w.stepsTaken, told], [1, 120, 0]);
  assert.equal(w.poses.movedCount, 0);
  assert.equal(w.step(12), 0.1, 'steps by hand only pass time');
  ball.wake();
  assert.equal(w.frame(1 / 60), true);
  assert.deepEqual([told, w.stepsTaken], [14, 122]);
  close(w.time, 1.1 + 1 / 60, 1e-9, 's');
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

fact('timeScale refuses what is no speed, and keeps the last one', async () => {
  const w = await world();
  claim(w, 'bad-value');
  w.timeScale = 0.5;
  w.timeScale = NaN;
  w.timeScale = -1;
  assert.equal(w.timeScale, 0.5);
});
