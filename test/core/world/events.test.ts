import assert from 'node:assert/strict';
import { Emitter } from '../../../physics-core/base/emitter.js';
import { loadEngine } from '../../../physics-core/create.js';
import { World } from '../../../physics-core/inside.js';
import { landing, hear, record } from './event-scenes.js';
import {
  addBody,
  addFloor,
  box,
  close,
  fact,
  height,
  velocity,
  watch,
  way,
  world,
  type Node,
  type Sensor,
} from '../helpers.js';

// ---- when -----------------------------------------------------------------------------------------------------------

fact(
  'what a step brings about is told when it is over, between beforestep and afterstep',
  async () => {
    const { w, ball, beside } = await landing();
    const log: string[] = [];
    const poses: number[] = [];
    w.on('beforestep', () => log.push('before'));
    w.on('afterstep', () => {
      log.push('after');
      poses.push(height(ball));
    });
    const told: { y: number; vy: number; steps: number }[] = [];
    for (const node of [ball, beside])
      node.on('collisionstart', () => {
        log.push('start');
        told.push({ y: height(ball), vy: velocity(ball)[1], steps: Math.round(w.time * 120) });
      });
    w.advance(0.3);
    const at = log.indexOf('start');
    assert.deepEqual(log.slice(at - 1, at + 3), ['before', 'start', 'start', 'after']);
    // It sees the poses of the step that it tells of, and not half of it.
    assert.equal(told[0]!.y, poses[told[0]!.steps - 1]);
    assert.deepEqual(told[0], told[1]);
  },
);

fact(
  'an edit of a listener acts before the next step, one in beforestep in that very step',
  async () => {
    for (const [event, y] of [
      ['collisionstart', 7],
      ['beforestep', 7 - way(9.8, 1 / 120)],
    ] as const) {
      const { w, ball } = await landing();
      let asked = false;
      const move = (): void => {
        if (w.time < 0.2) return;
        asked = true;
        ball.teleport([0, 7, 0]);
        ball.set('linearVelocity', [0, 0, 0]);
      };
      if (event === 'beforestep') w.on(event, () => !asked && move());
      else {
        ball.set('position', [0, 1, 0]);
        ball.on(event, move);
      }
      let first: number | undefined;
      w.on('afterstep', () => asked && (first ??= height(ball)));
      w.advance(0.5);
      close(first!, y, 1e-5, `m, moved in ${event}`);
    }
  },
);

fact(
  'a step asked for by a listener of the step does nothing; ready may ask for some',
  async () => {
    const { w, ball } = await landing();
    const asked: number[] = [];
    ball.on('collisionstart', () => {
      asked.push(w.step(5), w.advance(1));
      w.frame(0.1);
    });
    let steps = 0;
    w.on('afterstep', () => steps++);
    close(w.step(30), 30 / 120, 1e-12, 's');
    assert.deepEqual([asked, steps], [[0, 0], 30]);

    const late = new World();
    addFloor(late);
    const stone = addBody(late, { position: [0, 0.55, 0] });
    const log: string[] = [];
    hear(stone, log, 'stone');
    late.on('afterstep', () => log.push('after'));
    late.on('ready', () => {
      assert.equal(late.advance(0.25), 0.25);
      log.push('ready');
    });
    late.start(await loadEngine());
    watch(late);
    const start = log.indexOf('stone collisionstart');
    assert.ok(start > 0 && log[start + 1] === 'after' && log.at(-1) === 'ready', log.join());
    assert.equal(log.filter((each) => each === 'after').length, 30);
  },
);

fact('what a listener brings about is told after what came about before', async () => {
  const { w, floor, ball, beside } = await landing();
  const log: string[] = [];
  beside.remove();
  hear(ball, log, 'ball');
  hear(floor, log, 'floor');
  const remove = (): void => {
    ball.remove();
    log.push('removed');
  };
  for (const node of [ball, floor]) node.on('collisionstart', remove);
  w.advance(0.5);
  // Whoever of the two hears first: both hear that it began, then that it ended.
  const both = (words: string): string[] => [`ball ${words}`, `floor ${words}`];
  assert.deepEqual([log[1], log[3]], ['removed', 'removed']);
  assert.deepEqual([log[0], log[2]].toSorted(), both('collisionstart'));
  assert.deepEqual(log.slice(4).toSorted(), both('collisionend removed'));
});

// ---- sensors ----------------------------------------------------------------------------------------------------------

fact('a sensor that is active when the world begins anew says that it no longer is', async () => {
  const { w } = await landing();
  const all = w.add('CollisionCollection', { collidables: '*' });
  const sensor = w.add('CollisionSensor', { collider: all }) as Sensor;
  const log: unknown[] = [];
  sensor.on('isActive', (active) => log.push(active ? 'active' : 'inactive'));
  sensor.on('contacts', (contacts) =>
    log.push((contacts as unknown[]).length > 0 ? 'contacts' : 'no contacts'),
  );
  w.advance(0.25);
  assert.equal(log.filter((each) => each === 'active').length, 1);
  log.length = 0;
  w.reset();
  assert.deepEqual(log, ['no contacts', 'inactive']);
  assert.equal(sensor.isActive, false);
  log.length = 0;
  w.step();
  assert.deepEqual(log, []);
});

fact('of a sensor that was not told to be active nothing is taken back', async () => {
  const { w } = await landing();
  const all = w.add('CollisionCollection', { collidables: '*' });
  const sensor = w.add('CollisionSensor', { collider: all }) as Sensor;
  const log: unknown[] = [];
  let reset = false;
  sensor.on('isActive', (active) => log.push(active));
  sensor.on('intersections', () => {
    if (!reset) w.reset();
    reset = true;
  });
  while (!reset) w.step();
  assert.deepEqual(log, []);
  w.advance(0.25);
  assert.deepEqual(log, [true]);
});

fact(
  'lists of contacts that were meant for a step that never came do not act after reset()',
  async () => {
    const w = await world();
    const stone = addBody(w, { position: [0, 5, 0], geometry: [box(1)] });
    const floor = addFloor(w);
    const contact = {
      type: 'Contact',
      geometry1: (stone.asked('geometry') as Node[])[0],
      geometry2: (floor.asked('geometry') as Node[])[0],
      position: [0.5, 4.5, 0],
      contactNormal: [0, 1, 0],
      depth: 0.01,
    };
    const log = record(w);
    w.step(10);
    w.reset();
    const first = log.splice(0);
    w.step(3);
    w.settings.event('set_contacts', [contact]);
    w.reset();
    log.length = 0;
    w.step(10);
    assert.deepEqual(log, first);
  },
);

// ---- who listens --------------------------------------------------------------------------------------------------------

fact(
  'a listener that listens again while it is told hears the next event, and not this one again',
  async () => {
    const w = await world();
    addBody(w);
    let calls = 0;
    const again = (): void => {
      calls++;
      stop();
      if (calls < 100) stop = w.on('afterstep', again);
    };
    let stop = w.on('afterstep', again);
    let inline = 0;
    const listen = (): void => {
      const end = w.on('afterstep', () => {
        end();
        if (++inline < 100) listen();
      });
    };
    listen();
    w.step(3);
    assert.deepEqual([calls, inline], [3, 3]);
  },
);

fact('one removed while an event is told hears it no more, one added hears the next', () => {
  const emitter = new Emitter();
  const log: string[] = [];
  const stops: (() => void)[] = [];
  const note = (name: string) => (): void => void log.push(name);
  emitter.on('event', () => {
    stops.pop()?.();
    emitter.on('event', note('added'));
  });
  stops.push(emitter.on('event', note('removed')));
  emitter.on('event', note('last'));
  emitter.emit('event', 0);
  assert.deepEqual(log, ['last']);
});

fact('listeners replaced between steps go on: a lasting contact starts once (React)', async () => {
  const { w, ball } = await landing();
  let starts = 0;
  const listen = (): (() => void) => ball.on('collisionstart', () => starts++);
  let stop = listen();
  for (let i = 0; i < 360; i++) {
    w.step();
    stop();
    // Looking at values applies edits, and is no step.
    close(height(ball), 0.5, 0.06, 'm');
    stop = listen();
  }
  assert.equal(starts, 1);
  stop();
  w.step();
  assert.equal(w.effects.find(({ name }) => name === 'contact reading')!.active, false);
  listen();
  w.step();
  assert.equal(starts, 2);
});
