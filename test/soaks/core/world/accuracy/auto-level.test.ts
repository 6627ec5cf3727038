import assert from 'node:assert/strict';
import { levels, type LevelName, type World } from '../../../../../physics-core/inside.js';
import { AutoLevel } from '../../../../../physics-core/effects/costs/auto-level.js';
import { levelNamed } from '../../../../../physics-core/dynamics/levels.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  close,
  fact,
  height,
  position,
  sphere,
  velocity,
  world,
  type Body,
} from '../../../../core/helpers.js';

const FRAME = 1 / 60;

/** What a frame costs at each level, milliseconds. */
type Costs = Record<LevelName, number>;
const COSTS: Costs = { game: 0.5, standard: 1, fine: 2.4, precise: 5.5, reference: 14 };

/** The levels at the end of each second, with frames that cost so much. */
function levelsOver(seconds: number, costs: (second: number) => Costs, budget = 6): LevelName[] {
  const auto = new AutoLevel();
  return Array.from({ length: seconds }, (_, second) => {
    for (let i = 0; i < 60; i++) auto.note(costs(second)[auto.level.name], FRAME, budget);
    return auto.level.name;
  });
}

const scaled = (by: number): Costs =>
  Object.fromEntries(Object.entries(COSTS).map(([name, ms]) => [name, ms * by])) as Costs;

fact('auto climbs to the finest level that fits, a level per second, and stays there', () => {
  assert.deepEqual(
    levelsOver(6, () => COSTS),
    ['fine', 'fine', 'fine', 'fine', 'fine', 'fine'],
  );
  const light = scaled(0.1);
  assert.deepEqual(
    levelsOver(5, () => light),
    ['fine', 'precise', 'reference', 'reference', 'reference'],
  );
});

fact('auto comes down a level per second under load, and never below game', () => {
  const load = (second: number): Costs => scaled(second < 3 ? 0.1 : 50);
  assert.deepEqual(levelsOver(9, load).slice(2), [
    'reference',
    'precise',
    'fine',
    'standard',
    'game',
    'game',
    'game',
  ]);
});

fact('auto does not try again what it has seen not to fit', () => {
  // By the ladder alone precise should take 4.9 of 6.5 ms; here it takes 10.
  const costs = { ...COSTS, fine: 2, precise: 10 };
  const seen = levelsOver(12, () => costs, 6.5);
  assert.equal(seen.filter((name) => name === 'precise').length, 1, seen.join(' '));
  assert.equal(seen.at(-1), 'fine');
});

fact('auto judges by nine frames of ten', () => {
  const end = (every: number): LevelName => {
    const auto = new AutoLevel();
    auto.begin(levelNamed('fine'));
    for (let i = 0; i < 60; i++) auto.note(i % every === 0 ? 20 : 3, FRAME, 6);
    return auto.level.name;
  };
  assert.equal(end(10), 'fine', 'one of ten is slow');
  assert.equal(end(6), 'standard', 'one of six is slow');
});

fact('at 240 frames per second auto still waits a second', () => {
  const auto = new AutoLevel();
  let frames = 0;
  while (auto.level.name === 'standard') {
    auto.note(0.1, 1 / 240, 6);
    frames++;
  }
  close(frames, 240, 1, 'frames');
});

/** A clock that only steps move, so much per step of a world. */
function slowSteps(of: World, ms: (level: LevelName) => number): () => void {
  const { now } = performance;
  let time = 0;
  performance.now = () => time;
  of.on('afterstep', () => (time += ms(of.accuracy)));
  return () => (performance.now = now);
}

fact('a world with accuracy auto changes its level as its frames allow, and says so', async () => {
  const w = await world({ accuracy: 'auto' });
  addBody(w, { position: [0, 1000, 0] });
  const heard: unknown[] = [];
  w.on('accuracy', (change) => heard.push(change));
  let slow = 0.4;
  const stop = slowSteps(w, () => slow);
  assert.equal(w.accuracy, 'standard');
  assert.equal(w.get('accuracy'), 'auto');
  // 0.8 ms per frame at standard, 1.6 at fine, 3.2 at precise; reference would take more than 6.
  for (let i = 0; i < 300; i++) w.frame(FRAME);
  assert.equal(w.accuracy, 'precise');
  assert.equal(w.levels.find(({ active }) => active)!.name, 'precise');
  slow = 4;
  for (let i = 0; i < 62; i++) w.frame(FRAME);
  assert.equal(w.accuracy, 'fine');
  stop();
  assert.deepEqual(
    heard.map((change) => Object.values(change as object).slice(0, 3)),
    [
      ['fine', 'standard', 'room for more'],
      ['precise', 'fine', 'room for more'],
      ['fine', 'precise', 'over budget'],
    ],
  );
  close((heard[0] as { p90: number }).p90, 0.8, 1e-9, 'ms');
});

fact(
  'auto comes down on a page that draws slowly, too, and not for frames that nobody sees',
  async () => {
    const after = async (seen: boolean): Promise<LevelName> => {
      const w = await world({ accuracy: 'auto' });
      addBody(w, { position: [0, 1000, 0], useGlobalGravity: false });
      const stop = slowSteps(w, () => 1);
      for (let i = 0; i < 61; i++) w.frame(0.1, seen);
      stop();
      return w.accuracy;
    };
    assert.equal(await after(true), 'game');
    assert.equal(await after(false), 'standard');
  },
);

fact('timeBudget is what auto keeps to; an authored level, and none, leave it alone', async () => {
  const after = async (fields: Record<string, unknown>): Promise<LevelName> => {
    const w = await world(fields);
    addBody(w, { position: [0, 1000, 0] });
    const stop = slowSteps(w, () => 0.4);
    for (let i = 0; i < 300; i++) w.frame(FRAME);
    stop();
    return w.accuracy;
  };
  assert.equal(await after({ accuracy: 'auto', timeBudget: 3 }), 'fine');
  assert.equal(await after({ accuracy: 'auto', timeBudget: 0.5 }), 'game');
  assert.equal(await after({ accuracy: 'game', timeBudget: 3 }), 'game');
  assert.equal(await after({ timeBudget: 3 }), 'standard');
  assert.equal(await after({ preferAccuracy: true, timeBudget: 0.5 }), 'precise');
  assert.equal(await after({ preferAccuracy: true, accuracy: 'auto', timeBudget: 0.5 }), 'game');
});

fact('authored iterations hold at every level that auto takes', async () => {
  const w = await world({ accuracy: 'auto', iterations: 33 });
  addBody(w, { position: [0, 1000, 0] });
  for (let i = 0; i < 130; i++) w.frame(FRAME);
  assert.equal(w.accuracy, 'precise');
  assert.equal(w.bullet.settings.iterations, 33);
});

fact(
  'auto begins again at standard after a reset, and where a snapshot was after a restore',
  async () => {
    const w = await world({ accuracy: 'auto' });
    addBody(w, { position: [0, 1000, 0] });
    for (let i = 0; i < 130; i++) w.frame(FRAME);
    assert.equal(w.accuracy, 'precise');
    const kept = w.snapshot();
    const heard: unknown[] = [];
    w.on('accuracy', (change) => heard.push((change as { level: string }).level));
    w.reset();
    assert.equal(w.accuracy, 'standard');
    w.restore(kept);
    assert.equal(w.accuracy, 'precise');
    assert.deepEqual(heard, ['standard', 'precise']);
  },
);

fact('an edit of accuracy says what is in force from then on', async () => {
  const w = await world();
  addBody(w);
  const heard: unknown[] = [];
  w.on('accuracy', (change) => heard.push(change));
  w.accuracy = 'fine';
  w.set('accuracy', 'auto');
  w.step();
  assert.equal(w.accuracy, 'fine', 'auto goes on from there');
  assert.deepEqual(heard, [{ level: 'fine', from: 'standard', because: 'asked' }]);
});

// ---- what a change of level does to the motion -----------------------------------------------------------------------

/** Up and down the ladder, a level each second. */
const UP_AND_DOWN: readonly LevelName[] = [
  'standard',
  'fine',
  'precise',
  'reference',
  'precise',
  'fine',
  'standard',
  'game',
];

/** Visits every 1/60 s of `seconds`, with another level each second. */
function switching(w: World, seconds: number, visit: (time: number) => void): void {
  for (let i = 0; i < seconds * 60; i++) {
    if (i % 60 === 0) w.accuracy = UP_AND_DOWN[(i / 60) % UP_AND_DOWN.length]!;
    w.advance(1 / 60);
    visit((i + 1) / 60);
  }
}

fact('a falling body goes on with its velocity when the level changes', async () => {
  const w = await world();
  const ball = addBody(w, { position: [0, 0, 0] });
  let before = 0;
  switching(w, 8, (time) => {
    // Steps of a 60th at most may be half a step ahead: 9.8 t / 120.
    close(height(ball), -4.9 * time ** 2, (9.8 * time) / 120 + 1e-3, `m after ${time} s`);
    // Way of one 60th: no jump at any of the changes.
    close(before - height(ball), 9.8 * time * FRAME, 9.8 * FRAME * FRAME, `m in a 60th, ${time} s`);
    before = height(ball);
  });
  close(velocity(ball)[1], -9.8 * 8, 9.8 / 120 + 1e-3, 'm/s');
});

fact('a pendulum keeps its energy when the level changes each second', async () => {
  const run = async (change: boolean): Promise<number> => {
    const w = await world({ accuracy: 'game' });
    const ball = addBody(w, { position: [1, 0, 0], geometry: [sphere(0.1)] });
    addJoint(w, 'SingleAxisHingeJoint', { body1: ball, axis: [0, 0, 1] });
    let worst = 0;
    let back = -1;
    const look = (): void => {
      worst = Math.max(worst, height(ball));
      back = Math.max(back, position(ball)[0]);
    };
    if (change) switching(w, 16, look);
    else for (let i = 0; i < 16 * 60; i++) (w.step(), look());
    below(1 - back, 1e-3, 'm that it falls short of where it was let go');
    return worst;
  };
  // Heights over the one it was let go at: as without changes. Half a step of gravity would lift it by 8 cm each time.
  below(await run(false), 1e-3, 'm');
  below(await run(true), 1e-3, 'm');
});

fact('the drawn path goes on evenly when the level changes', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { linearVelocity: [6, 0, 0] });
  const drawn = (): number => w.poses.data[ball.slot * 7]!;
  let before = 0;
  // Frames of 100 Hz never fall on steps.
  for (let i = 0; i < 800; i++) {
    if (i % 100 === 0) w.accuracy = UP_AND_DOWN[i / 100]!;
    w.frame(0.01);
    if (i > 2) close(drawn() - before, 0.06, 1e-4, `m in frame ${i}`);
    before = drawn();
  }
});

fact('a stack at rest stays at rest when the level changes each second', async () => {
  const w = await world({ rest: 'never' });
  addFloor(w);
  const boxes: Body[] = Array.from({ length: 5 }, (_, i) =>
    addBody(w, { position: [0, 0.5 + i, 0], geometry: [box(1)] }),
  );
  w.advance(2);
  const start = boxes.map((body) => position(body));
  let fastest = 0;
  switching(w, 16, () => {
    for (const body of boxes) fastest = Math.max(fastest, Math.hypot(...velocity(body)));
  });
  boxes.forEach((body, i) => close(position(body), start[i]!, 0.01, `m, box ${i}`));
  below(fastest, 0.1, 'm/s');
  assert.equal(levels.length, 5);
});
