import { test } from 'node:test';
import { Cap } from '../../../../../physics-core/effects/particles/emit/cap.js';
import { Draws } from '../../../../../physics-core/effects/particles/emit/draws.js';
import { close } from '../../../helpers.js';

const COUNT = 40_000;

/** Means over many directions of each share and of its square. */
function meansOf(cap: Cap): { mean: number[]; square: number[] } {
  const draws = new Draws(3);
  const out = new Float64Array(3);
  const mean = [0, 0, 0];
  const square = [0, 0, 0];
  for (let n = 0; n < COUNT; n++) {
    cap.draw(draws.of(n), out, 0);
    close(Math.hypot(...out), 1, 1e-12);
    for (let i = 0; i < 3; i++) {
      mean[i]! += out[i]! / COUNT;
      square[i]! += out[i]! ** 2 / COUNT;
    }
  }
  return { mean, square };
}

for (const angle of [1e-3, 0.3, Math.PI / 2, 2.5])
  test(`directions lie evenly in a cap of ${angle} rad`, () => {
    const { mean } = meansOf(new Cap().take(0, -3, 0, angle));
    const fall = 1 - Math.cos(angle);
    // A share of the axis is as likely as another.
    close(1 + mean[1]!, fall / 2, 0.01 * fall);
    close([mean[0]!, mean[2]!], [0, 0], 0.01);
  });

test('what has no axis goes anywhere, and so does all within half a turn of one', () => {
  for (const cap of [new Cap().take(0, 0, 0, 0), new Cap().take(1, 2, -2, Math.PI)]) {
    const { mean, square } = meansOf(cap);
    close(mean, [0, 0, 0], 0.01);
    close(square, [1 / 3, 1 / 3, 1 / 3], 0.01);
  }
});

test('no angle is the axis itself, whichever way it points and however long it is', () => {
  const out = new Float64Array(3);
  const axes: [number, number, number][] = [
    [0, 0, 1],
    [0, 0, -1],
    [1, 2, -2],
    [-4e100, 0, 3e100],
    [4e-200, 0, -3e-200],
  ];
  for (const axis of axes) {
    new Cap().take(...axis, 0).draw(new Draws(1).of(1), out, 0);
    const length = Math.hypot(...axis);
    close(
      [...out],
      axis.map((share) => share / length),
      1e-15,
    );
  }
});
