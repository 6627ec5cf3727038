import { expect } from 'chai';
import { PARTICLE_BITS, particleBits } from '../../stability/particle-bits.js';

describe('particles among bodies', () => {
  it('come to the bits that they have in Node', async () => {
    expect(await particleBits()).to.equal(PARTICLE_BITS);
  });
});
