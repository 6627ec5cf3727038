import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cases } from '../../../lab/cases/index.js';
import { brokenRungs } from '../../../lab/draw/judge.js';
import { pagesOf, readBeside } from '../../../lab/draw/report.js';
import { engines } from '../../../lab/engines/index.js';
import { readReport } from '../../../lab/run/report.js';
import type { Row } from '../../../lab/run/row.js';
import { level, run, thrown, row } from '../../lab/runs.js';

test('a case comes to the same bits every time, in each engine', async () => {
  for (const { id } of engines)
    assert.deepEqual((await run(thrown, id)).hash, (await run(thrown, id)).hash, id);
});

test('the report has every case, and what it draws of one does not hang on the others', () => {
  const report = readReport();
  const pages = pagesOf(report, readBeside());
  for (const { id } of cases) assert.ok(pages.has(`${id}.html`), id);
  const drawn = pagesOf(report, readBeside());
  for (const [name, text] of pages) assert.equal(drawn.get(name), text, name);
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
