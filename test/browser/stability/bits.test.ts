import { expect } from 'chai';
import { hashAfterSteps, SMOKE } from '../../../lab/stability/smoke.js';

describe('hard cases', () => {
  for (const [id, hash] of Object.entries(SMOKE))
    it(`${id} comes to the bits that it has in Node`, async () => {
      expect(await hashAfterSteps(id)).to.equal(hash);
    });
});
