import assert from 'node:assert/strict';
import { landing, hear, record, asleepAt, sleepers, type Touch } from './event-scenes.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  claim,
  close,
  fact,
  height,
  velocity,
  world,
  type Body,
  overflow,
} from '../helpers.js';

fact('a body may go by its own wake event: the others of the step are read and go on', async () => {
  const { w, low, high } = await sleepers();
  const ball = addBody(w, { position: [0.2, 4, 0], linearVelocity: [0, -8, 0] });
  const events: string[] = [];
  /** Height of the ball, which is read last, as who woke sees it, and at the end of that step. */
  let seen: number[] = [];
  for (const [name, body] of Object.entries({ low, high }))
    body.on('wake', () => {
      events.push(name);
      seen = [height(ball)];
      body.remove();
    });
  let lowest = Infinity;
  w.on('afterstep', () => {
    lowest = Math.min(lowest, height(ball));
    if (seen.length === 1) seen.push(height(ball));
  });
  w.advance(2);
  assert.deepEqual(events.toSorted(), ['high', 'low']);
  assert.equal(seen[0], seen[1]);
  close(height(ball), 0.5, 0.01, 'm, down where the boxes stood');
  above(lowest, 0.4, 'm');
  assert.equal(w.stats.bodies, 2);
});

fact('an edit tells what it brings about when it is over: who is woken finds it done', async () => {
  const w = await world();
  const floor = addFloor(w);
  const boxes = [0, 5].map((x) => addBody(w, { ...asleepAt(0.5), position: [x, 0.5, 0] }));
  w.advance(1);
  const seen: unknown[] = [];
  for (const body of boxes)
    body.on('wake', () => {
      seen.push([floor.built, ...boxes.map(({ sleeping }) => sleeping)]);
      for (const each of boxes) each.remove();
      seen.push('removed');
    });
  floor.remove();
  const found = [false, false, false];
  assert.deepEqual(seen, [found, 'removed', found, 'removed']);
  assert.equal(w.stats.bodies, 0);
  w.step();
});

fact('a kick that wakes a body whose listener removes it is over before it goes', async () => {
  const kicks: [(body: Body) => void, speed: number, y: number][] = [
    [(body) => body.applyImpulse([0, 3, 0]), 3, 1.5],
    [(body) => body.applyForce([0, 3, 0]), 0, 1.5],
    [(body) => body.teleport([3, 3, 0]), 0, 3],
    [(body) => void body.drag([0, 1, 0]), 0, 1.5],
    [(body) => body.set('linearVelocity', [0, 2, 0]), 2, 1.5],
  ];
  for (const [kick, speed, y] of kicks) {
    const { w, high, low } = await sleepers();
    let found: number[] | undefined;
    high.on('wake', () => {
      found = [velocity(high)[1], height(high)];
      high.remove();
    });
    kick(high);
    w.step(0);
    close(found!, [speed, y], 0.01, `m/s and m, after ${kick}`);
    assert.equal(high.built, false);
    w.advance(0.5);
    close(height(low), 0.5, 0.01, 'm');
  }
});

fact('reset() in a sleep event leaves nobody asleep in the new run', async () => {
  const w = await world();
  addFloor(w);
  // They fall for 0.2 m and are put to sleep as one island.
  const boxes = [0.7, 1.7].map((y) => addBody(w, asleepAt(y)));
  let resets = 0;
  const log: string[] = [];
  for (const body of boxes) {
    body.on('wake', () => log.push('wake'));
    body.on('sleep', () => {
      log.push('sleep');
      if (resets++ === 0) w.reset();
    });
  }
  w.on('afterstep', () => {
    if (resets === 0 || w.time > 0.15) return;
    assert.deepEqual(
      boxes.map((body) => body.sleeping),
      [false, false],
    );
  });
  while (resets === 0) w.step();
  assert.equal(w.time, 0);
  // Of the other one nobody heard that it slept, and so nobody hears that it woke.
  assert.deepEqual(log, ['sleep', 'wake']);
  w.advance(0.1);
  below(height(boxes[0]!), 0.69, 'm, it falls again');
});

fact(
  'reset() in a collision event: who was told of a start is told of its end, and the new run is the first one',
  async () => {
    const { w, floor, ball, beside } = await landing();
    const first = record(w);
    w.advance(0.25);
    w.reset();
    const rerun = first.splice(0);
    const log: string[] = [];
    let reset = false;
    // What was not told of the old run does not act on the new one.
    for (const [name, node] of Object.entries({ ball, floor, beside })) {
      hear(node, log, name);
      node.on('collisionstart', () => {
        if (reset) node.get('fixed') || (node as Body).applyImpulse([9, 9, 9]);
        else w.reset();
        reset = true;
      });
    }
    while (!reset) w.step();
    const [name] = log[0]!.split(' ');
    assert.deepEqual(log, [`${name} collisionstart`, `${name} collisionend reset`]);
    assert.equal(w.time, 0);
    first.length = 0;
    w.advance(0.02);
    assert.deepEqual(first, rerun.slice(0, 2));
  },
);

fact('restore() in a listener likewise, and a body that sleeps on is said to sleep', async () => {
  const { w, low, high } = await sleepers();
  const asleep = w.snapshot();
  const log: string[] = [];
  low.on('sleep', () => {
    log.push('low');
    w.restore(asleep);
  });
  high.on('sleep', () => log.push('high'));
  high.on('wake', () => log.push('high wakes'));
  low.wake();
  while (!log.includes('low')) w.step();
  assert.deepEqual(log, ['high wakes', 'low', 'high']);
  assert.ok(low.sleeping && high.sleeping);
});

fact(
  'destroy() in a listener: the others hear of whole contacts, and step() says how far it came',
  async () => {
    const { w, ball } = await landing();
    const heard: Touch[] = [];
    ball.on('collisionstart', () => w.destroy());
    for (const event of ['collisionstart', 'collisionend'])
      ball.on(event, (detail) => heard.push(detail as Touch));
    let after = 0;
    w.on('afterstep', () => after++);
    const seconds = w.step(60);
    assert.equal(w.started, false);
    assert.deepEqual(
      heard.map(({ contacts, reason }) => [contacts.length, reason]),
      [
        [1, undefined],
        [0, 'removed'],
      ],
    );
    close(seconds, heard[0]!.time, 1e-12, 's');
    // The step that the world ended in has no end of its own.
    assert.equal(after, Math.round(seconds * 120) - 1);
    assert.equal(w.step(), 0);
  },
);

fact('destroy() in beforestep: that step is not taken', async () => {
  const { w } = await landing();
  let steps = 0;
  w.on('beforestep', () => ++steps === 4 && w.destroy());
  close(w.step(10), 3 / 120, 1e-12, 's');
  assert.equal(steps, 4);
});

fact('step() returns the seconds taken where a listener changes the level meanwhile', async () => {
  const w = await world();
  addBody(w);
  w.on('afterstep', () => w.time > 0.02 && (w.accuracy = 'fine'));
  assert.equal(w.step(9), 3 / 120 + 6 / 240);
  close(w.time, 0.05, 1e-12, 's');
});

fact('a listener of a joint limit may take the joint away', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const doors = [0, 9].map((x) => {
    const door = addBody(w, {
      position: [x + 1, 0, 0],
      linearVelocity: [0, 1, 0],
      angularVelocity: [0, 0, 1],
    });
    return addJoint(w, 'SingleAxisHingeJoint', {
      body1: door,
      anchorPoint: [x, 0, 0],
      axis: [0, 0, 1],
      maxAngle: 0.3,
    });
  });
  const log: unknown[] = [];
  for (const door of doors)
    door.on('jointlimit', (detail) => {
      log.push((detail as { limit: string }).limit);
      for (const each of doors) each.remove();
    });
  w.advance(1);
  // Both reached theirs in one step.
  assert.deepEqual(log, ['max', 'max']);
  assert.equal(w.stats.joints, 0);
});

fact(
  'a problem of a step is told after it: who hears that a body broke may remove it',
  async () => {
    const { w, ball, beside } = await landing();
    claim(w, 'nan-state');
    w.step();
    let read: number | undefined;
    w.on('problem', (problem) => {
      assert.equal((problem as { element: unknown }).element, ball);
      read = height(beside);
      ball.remove();
    });
    overflow(ball, [1e38, 0, 0]);
    overflow(ball, [1e38, 0, 0]);
    overflow(ball, [1e38, 0, 0]);
    overflow(ball, [1e38, 0, 0]);
    const before = height(beside);
    w.step();
    below(read!, before, 'm, read before anybody heard');
    w.advance(1);
    close(height(beside), 0.5, 0.01, 'm');
  },
);

fact('a problem of an edit is told when the edit is in place', async () => {
  const w = await world();
  claim(w, 'out-of-range');
  const ball = addBody(w, { linearDampingFactor: 0.2 });
  let asked: unknown;
  w.on('problem', () => (asked = ball.asked('linearDampingFactor')));
  ball.set('linearDampingFactor', 7);
  assert.equal(asked, 1);
});

fact('the end of a drag by reset() is told when the world stands again', async () => {
  const { w, ball } = await landing();
  w.advance(0.1);
  let end: unknown[] | undefined;
  ball.drag([0, 0.5, 0], (reason) => (end = [reason, w.started, w.time, height(ball)]));
  w.reset();
  assert.deepEqual(end!.slice(0, 3), ['reset', true, 0]);
  close(end![3] as number, 0.55, 1e-6, 'm');
});

fact('a listener that pauses the world stops it there, and it goes on from there', async () => {
  const w = await world();
  addBody(w);
  let steps = 0;
  const stop = w.on('afterstep', () => {
    steps++;
    w.paused = true;
  });
  w.frame(0.1);
  assert.equal(steps, 1);
  stop();
  w.paused = false;
  w.frame(1 / 60);
  close(w.time, 3 / 120, 1e-9, 's, nothing to catch up');
});
