import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { readContacts } from '../../lab/contacts/numbers.js';
import { withContacts } from '../../lab/contacts/text.js';
import { matrixPicture } from '../../lab/draw/stability-picture.js';
import { pictureOf } from '../../lab/draw/report.js';
import { readJoints } from '../../lab/joints/numbers.js';
import { withErrors } from '../../lab/joints/text.js';
import { readStability } from '../../lab/stability/numbers.js';
import { promiseCount } from '../../lab/stability/table.js';
import { withMatrix } from '../../lab/stability/text.js';
import { readReport, withCases } from '../../lab/run/report.js';
import type { Results, Row } from '../../lab/run/row.js';

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

test('what one machine measures on one day is one run', () => {
  const one = (id: string): Results => ({
    runs: [{ machine: 'a', date: '1', cases: [id] }],
    rows: [],
    notOffered: [],
  });
  assert.deepEqual(withCases(one('bounce-1'), one('cradle')).runs, [
    { machine: 'a', date: '1', cases: ['bounce-1', 'cradle'] },
  ]);
});

test('the picture of the page on accuracy is drawn from the numbers', () => {
  assert.equal(readFileSync('docs/pictures/accuracy.svg', 'utf8'), pictureOf(readReport()));
});

test('the errors in docs/joints.md are those of the numbers', () => {
  const text = readFileSync('docs/joints.md', 'utf8');
  assert.equal(withErrors(text, readJoints()), text);
});

test('the tables in docs/contacts.md are those of the numbers', () => {
  const text = readFileSync('docs/contacts.md', 'utf8');
  assert.equal(withContacts(text, readReport().rows, readContacts()), text);
});

test('the matrix in docs/stability.md is that of the numbers, and none of its promises breaks', () => {
  const text = readFileSync('docs/stability.md', 'utf8');
  const numbers = readStability();
  assert.equal(withMatrix(text, numbers), text);
  assert.equal(readFileSync('docs/pictures/stability.svg', 'utf8'), `${matrixPicture(numbers)}\n`);
  assert.deepEqual(promiseCount(numbers).broken, []);
});
