import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { effectsPage, PAGE } from '../../tools/docs/effects/page.js';

test('docs/effects.md has the effects as they are: npm run write -- effects writes it', async () => {
  assert.equal(readFileSync(PAGE, 'utf8'), await effectsPage());
});
