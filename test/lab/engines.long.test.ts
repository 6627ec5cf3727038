import assert from 'node:assert/strict';
import { test } from 'node:test';
import { caseOf } from '../../lab/cases/index.js';
import { NotOffered } from '../../lab/engines/engine.js';
import { compareWith } from '../../lab/run/quick.js';
import { measure, ONCE } from '../../lab/run/measure.js';
import type { Row } from '../../lab/run/row.js';
import { engine, level, run, GRAVITY, thrown } from './runs.js';

test('raw Ammo falls as far as its step makes it: exactly ½ g t dt too far', async () => {
  for (const setting of engine('ammo').settings.slice(0, 4)) {
    const { error } = await run(thrown, 'ammo', setting);
    assert.ok(Math.abs(error! / ((GRAVITY / 2) * 2 * setting.step) - 1) < 0.01, `${error}`);
  }
});

test('our engine falls at least as true as raw Ammo at each step, at levels and between them', async () => {
  for (const setting of engine('ours').settings.slice(0, 9)) {
    const { error } = await run(thrown, 'ours', setting);
    assert.ok(error! <= (GRAVITY / 2) * 2 * setting.step * 1.01, `${setting.step}: ${error}`);
  }
});

test('our engine takes the step it is set to, at levels and between them', async () => {
  for (const setting of engine('ours').settings) {
    const running = await engine('ours').make(thrown.scene, setting);
    assert.equal(running.timeStep, setting.step);
    running.destroy();
  }
});

test('a joint that an engine has no words for is not offered, and the reason is told', async () => {
  const slider = caseOf('slider-stop');
  await assert.rejects(
    () => run(slider, 'cannon'),
    (error) => error instanceof NotOffered && error.message === 'sliders',
  );
  const { rows, notOffered } = await measure(
    slider,
    [{ engine: engine('cannon'), setting: engine('cannon').settings[0]! }],
    { pains: ONCE, fresh: true, progress: () => {} },
  );
  assert.deepEqual(rows, []);
  assert.deepEqual(notOffered, [{ case: 'slider-stop', engine: 'cannon', reason: 'sliders' }]);
});

test('the gap is the way between the halves of a joint', async () => {
  const pendulum = caseOf('pendulum-rod');
  const raw = await run(pendulum, 'ammo');
  assert.ok(raw.gap! > 1e-3 && raw.gap! < 0.1, `raw Ammo's hinge gapes ${raw.gap} m`);
  assert.equal((await run(thrown, 'ammo')).gap, 0);
});

test('a quick run finds an error that came out otherwise', async () => {
  const entries = [{ engine: engine('ours'), setting: level('game') }];
  const { rows } = await measure(thrown, entries, { pains: ONCE, fresh: true, progress: () => {} });
  const compare = (row: Row) =>
    compareWith(
      { rows: [row], notOffered: [] },
      [thrown],
      () => {},
      () => {},
    );
  assert.equal(await compare(rows[0]!), 0);
  assert.equal(await compare({ ...rows[0]!, error: rows[0]!.error! * (1 + 1e-12) }), 1);
  assert.equal(await compare({ ...rows[0]!, hash: 'another' }), 1);
});
