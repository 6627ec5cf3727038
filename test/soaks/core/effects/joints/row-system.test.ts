import { test } from 'node:test';
import type { Edge } from '../../../../../physics-core/solver/joints/forest.js';
import { RowSystem } from '../../../../../physics-core/solver/joints/row-system.js';
import { below } from '../../../../core/helpers.js';
import {
  GIVE,
  made,
  filled,
  solveAll,
  difference,
  chain,
} from '../../../../core/solver/joints/dense.js';

void test('one system serves graphs that grow, shrink and grow again', () => {
  const system = new RowSystem();
  for (const n of [2, 30, 3, 90, 1]) {
    made(n, chain(n), system);
    const dense = filled(system, n, () => 3);
    solveAll(system);
    below(difference(system, dense), GIVE, `of the value, ${n} bodies`);
  }
});

void test('a net of 8 by 8: velocities and impulses are those of the dense system', () => {
  const edges: Edge[] = [{ a: 0, b: -1 }];
  for (let i = 0; i < 8; i++)
    for (let k = 0; k < 8; k++) {
      if (k < 7) edges.push({ a: 8 * i + k, b: 8 * i + k + 1 });
      if (i < 7) edges.push({ a: 8 * i + k, b: 8 * i + k + 8 });
    }
  const system = made(64, edges);
  // 226 rows of 384 speeds.
  const dense = filled(system, 64, () => 2);
  solveAll(system);
  // Fifty loops give way together.
  below(difference(system, dense), 5 * GIVE, 'of the value');
});
