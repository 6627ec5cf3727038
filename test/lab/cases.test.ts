import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { floorOf } from '../../lab/case.js';
import { cases, casesNamed } from '../../lab/cases/index.js';

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
