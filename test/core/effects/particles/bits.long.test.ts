import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PARTICLE_BITS, particleBits } from '../../../stability/particle-bits.js';

test('particles among bodies come to the bits that they have everywhere', async () => {
  assert.equal(await particleBits(), PARTICLE_BITS);
});
