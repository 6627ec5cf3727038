import { invertSymmetric, makeSemidefinite } from '../../../physics-core/base/symmetric.js';
import { close, fact } from '../helpers.js';

/** With these principal values along axes that stand askew. */
function askew(values: readonly number[]): Float64Array {
  const axes = [
    [2 / 3, 2 / 3, 1 / 3],
    [-2 / 3, 1 / 3, 2 / 3],
    [1 / 3, -2 / 3, 2 / 3],
  ];
  const m = new Float64Array(10);
  axes.forEach((axis, k) => {
    for (let i = 0; i < 9; i++) m[1 + i]! += values[k]! * axis[Math.floor(i / 3)]! * axis[i % 3]!;
  });
  return m;
}

fact('of a symmetric matrix what is negative goes, and the rest stays', () => {
  for (const values of [
    [3, -2, 1],
    [-1, -2, -3],
    [1e6, -1e6, 1],
    [2, 2, -2],
  ]) {
    const m = askew(values);
    makeSemidefinite(m, 1);
    close(
      [...m],
      [...askew(values.map((value) => Math.max(0, value)))],
      1e-9 * Math.abs(values[0]!),
      '',
    );
  }
});

fact('a symmetric matrix times its inverse is 1', () => {
  const inverse = new Float64Array(10);
  invertSymmetric(askew([4, 0.5, 20]), inverse, 1);
  close([...inverse], [...askew([0.25, 2, 0.05])], 1e-12, '');
});
