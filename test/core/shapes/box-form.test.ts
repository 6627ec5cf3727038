import { BoxForm } from '../../../physics-core/shapes/forms/box.js';
import { close, fact, random } from '../helpers.js';

/** Directions of all kinds, along axes and edges too, where several corners or faces are as good. */
function* directions(): Generator<[number, number, number]> {
  for (const x of [-1, 0, 1])
    for (const y of [-1, 0, 1]) for (const z of [-1, 0, 1]) yield [x, y, z];
  const next = random(7);
  for (let i = 0; i < 500; i++) yield [next() - 0.5, next() - 0.5, next() - 0.5];
}

const along = (of: Float64Array, at: number, d: readonly number[]): number =>
  of[at]! * d[0]! + of[at + 1]! * d[1]! + of[at + 2]! * d[2]!;

fact('no corner of a box is farther along a direction than the one that it finds', () => {
  const form = new BoxForm([0.5, 1, 2]);
  const out = new Float64Array(3);
  for (const d of directions()) {
    form.support(Float64Array.from(d), out);
    let most = -Infinity;
    for (let i = 0; i < 24; i += 3) most = Math.max(most, along(form.points, i, d));
    close(along(out, 0, d), most, 1e-12);
  }
});

fact(
  'no face of a box looks more along a direction than the one that it finds, and its corners lie on it',
  () => {
    const form = new BoxForm([0.5, 1, 2]);
    const normal = new Float64Array(3);
    const corners = new Float64Array(12);
    const half = [0.5, 1, 2];
    for (const d of directions()) {
      const number = form.facing(...d, normal);
      close(along(normal, 0, d), Math.max(...d.map(Math.abs)), 1e-12);
      close(form.face(number, corners), 4, 0);
      const out = half.reduce((sum, size, k) => sum + size * Math.abs(normal[k]!), 0);
      for (let i = 0; i < 12; i += 3) close(along(corners, i, [...normal]), out, 1e-12);
    }
  },
);
