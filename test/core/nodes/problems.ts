import assert from 'node:assert/strict';
import type { World } from '../../../physics-core/inside.js';
import { claim, codes } from '../helpers.js';

export const only = (w: World, code: string) => {
  claim(w, code);
  const found = w.problems.filter((problem) => problem.code === code);
  assert.equal(found.length, 1, `one ${code} among ${codes(w).join(' ')}`);
  return found[0]!;
};
