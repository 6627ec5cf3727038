import { expect } from 'chai';
import { EXACT_BITS, exactBits } from '../../core/base/exact-bits.js';

describe('sines, arcs, exponentials and lengths', () => {
  it('have the bits that they have in Node', () => {
    expect(exactBits()).to.equal(EXACT_BITS);
  });
});
