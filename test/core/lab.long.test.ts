import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { floorOf, type Case, type Vec3 } from '../../lab/case.js';
import { cases, caseOf, casesNamed } from '../../lab/cases/index.js';
import { brokenRungs, duel, errorAt } from '../../lab/draw/judge.js';
import { pagesOf, pictureOf } from '../../lab/draw/report.js';
import { NotOffered, type Engine, type Setting } from '../../lab/engines/engine.js';
import { engines } from '../../lab/engines/index.js';
import { readJoints } from '../../lab/joints/numbers.js';
import { withErrors } from '../../lab/joints/text.js';
import { follow } from '../../lab/run/follow.js';
import { compareWith } from '../../lab/run/quick.js';
import { measure, ONCE } from '../../lab/run/measure.js';
import { readReport, withCases } from '../../lab/run/report.js';
import type { Results, Row } from '../../lab/run/row.js';

const engine = (id: string): Engine => engines.find((one) => one.id === id)!;
const level = (name: string): Setting =>
  engine('ours').settings.find((setting) => setting.level === name)!;

async function run(which: Case, id: string, setting: Setting = engine(id).settings[0]!) {
  const running = await engine(id).make(which.scene, setting);
  const found = follow(which, running);
  running.destroy();
  return found;
}

const GRAVITY = 9.81;
const THROWN: Vec3 = [3, 8, 1];

/** A thrown ball of a size that gives floors a meaning. */
const thrown: Case = {
  id: 'T1',
  name: 'Thrown ball',
  says: 'A thrown ball, against x = v t + ½ g t².',
  scene: {
    gravity: [0, -GRAVITY, 0],
    bodies: [{ name: 'ball', shape: { type: 'Sphere', radius: 0.1 }, linearVelocity: THROWN }],
  },
  seconds: 2,
  unit: 'm',
  size: 10,
  singlePrecision: 1e-6,
  watch({ position }) {
    let last = 0;
    return {
      look: (t) => {
        const fallen = (GRAVITY / 2) * t ** 2;
        const way = THROWN.map((v) => v * t).with(1, THROWN[1] * t - fallen);
        last = Math.hypot(...position('ball').map((x, i) => x - way[i]!));
      },
      error: () => last,
    };
  },
};

test('a case comes to the same bits every time, in each engine', async () => {
  for (const { id } of engines)
    assert.deepEqual((await run(thrown, id)).hash, (await run(thrown, id)).hash, id);
});

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

const row = (ms: number, error: number, of: Partial<Row> = {}): Row =>
  ({ case: 'T1', engine: 'ammo', level: null, ms, error, ...of }) as Row;

test('between two runs the error in a given time lies on the line of the logarithms', () => {
  const sweep = [row(1, 1), row(4, 0.01), row(2, 3)];
  assert.ok(
    Math.abs(errorAt(2, sweep) - 0.1) < 1e-12,
    'the run that is dearer and worse does not count',
  );
  assert.equal(errorAt(0.5, sweep), 1);
  assert.equal(errorAt(9, sweep), 0.01);
});

test('a duel counts errors under the floor as at it', () => {
  const mine = (error: number) => row(4, error, { engine: 'ours', level: 'standard' });
  const floor = floorOf(thrown);
  assert.equal(duel(thrown, 'ammo', [mine(0.02), row(4, 0.2)])!.factor, 10);
  assert.equal(duel(thrown, 'ammo', [mine(floor / 1000), row(4, 5 * floor)])!.factor, 5);
  assert.equal(duel(thrown, 'ammo', [mine(0.02)])!.factor, null);
});

test('every case is well formed', () => {
  assert.equal(new Set(cases.map(({ id }) => id)).size, cases.length, 'ids differ');
  for (const which of cases) {
    const { id, name, says, size, singlePrecision, seconds, every = 1 / 60 } = which;
    assert.match(id, /^[a-z]+(-[a-z0-9]+)*$/);
    assert.ok(name.length > 3 && says.endsWith('.'), `${id} has a name and a sentence`);
    assert.ok(size > 0 && singlePrecision > 0, `${id} has a size and a floor`);
    assert.ok(floorOf(which) < 0.05 * size, `${id}: its floor is small against what is measured`);
    const frames = every * 60;
    assert.ok(Math.abs(frames - Math.round(frames)) < 1e-9, `${id}: all levels stop at its looks`);
    assert.ok(
      Math.abs(seconds / every - Math.round(seconds / every)) < 1e-9,
      `${id} ends at a look`,
    );
  }
});

test('every file of cases is listed', () => {
  const text = (file: string) => readFileSync(`lab/cases/${file}`, 'utf8');
  const files = readdirSync('lab/cases').filter((file) =>
    text(file).includes('export const cases: Case[]'),
  );
  assert.ok(files.length > 5);
  for (const file of files) assert.ok(text('index.ts').includes(`./${file.replace('.ts', '.js')}`));
});

test('a name stands for its case, and a family for all of its cases', () => {
  const ids = (name: string) => casesNamed(name).map(({ id }) => id);
  assert.deepEqual(ids('chain'), ['chain-1-20', 'chain-1-1000', 'chain-100-links']);
  assert.deepEqual(ids('bounce-0'), ['bounce-0']);
  assert.deepEqual(ids('chai'), []);
});

test('a case measured anew takes its place in the report, with its own machine and date', () => {
  const of = (id: string, hash: string) => ({ case: id, hash }) as Row;
  const ours = (hash: string) => ['bounce-1', 'cradle'].map((id) => of(id, hash));
  const before: Results = {
    runs: [{ machine: 'a', date: '1', cases: ['bounce-1', 'cradle'] }],
    rows: ours('old'),
    notOffered: [{ case: 'bounce-1', engine: 'jolt', reason: 'old' }],
  };
  const fresh: Results = {
    runs: [{ machine: 'b', date: '2', cases: ['bounce-1'] }],
    rows: [of('bounce-1', 'new')],
    notOffered: [],
  };
  assert.deepEqual(withCases(before, fresh), {
    runs: [{ machine: 'a', date: '1', cases: ['cradle'] }, ...fresh.runs],
    rows: [of('bounce-1', 'new'), of('cradle', 'old')],
    notOffered: [],
  });
});

test('the report has every case, and what it draws of one does not hang on the others', () => {
  const report = readReport();
  const pages = pagesOf(report, readJoints());
  for (const { id } of cases) assert.ok(pages.has(`${id}.html`), id);
  const drawn = pagesOf(report, readJoints());
  for (const [name, text] of pages) assert.equal(drawn.get(name), text, name);
});

test("the README's picture is drawn from the numbers", () => {
  assert.equal(readFileSync('docs/pictures/accuracy.svg', 'utf8'), pictureOf(readReport()));
});

test('the errors in docs/joints.md are those of the numbers', () => {
  const text = readFileSync('docs/joints.md', 'utf8');
  assert.equal(withErrors(text, readJoints()), text);
});

const QUICK = ['game', 'standard', 'fine'];
/** Others, and the finer levels, are judged by `npm run lab`: their references alone take seconds. */
const SMALL = 20;

for (const which of cases.filter(({ scene }) => scene.bodies.length <= SMALL))
  test(`${which.id} ${which.name}: no level errs more than the one before, up to fine`, async () => {
    const rows: Row[] = [];
    for (const name of QUICK) {
      const { error } = await run(which, 'ours', level(name));
      rows.push(row(0, error!, { case: which.id, engine: 'ours', level: name, error }));
    }
    assert.ok(Number.isFinite(rows[1]!.error), `standard comes to an end: ${rows[1]!.error}`);
    if (!which.exception)
      assert.deepEqual(brokenRungs(which, rows), [], rows.map(({ error }) => error).join(', '));
  });
