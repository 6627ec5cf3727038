import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hashAfterSteps, SMOKE } from '../../../lab/stability/smoke.js';

for (const [id, hash] of Object.entries(SMOKE))
  test(`${id} comes to the bits that it has everywhere`, async () => {
    assert.equal(await hashAfterSteps(id), hash);
  });
