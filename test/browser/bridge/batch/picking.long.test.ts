import { expect } from 'chai';
import '../../console.js';
import { drawPlainly, picture, showBatched } from './pictures.js';
import { heap, found } from './pick.js';

/** From 0 to 1, the same in every run. */
function* numbers(seed: number): Generator<number, never> {
  for (let state = seed; ;) {
    state = (state * 16807) % 2147483647;
    yield state / 2147483647;
  }
}

describe('bodies drawn in one call', () => {
  it('are found by x3dom each under its own points, in the same place and with the same normal: 200 at random', async () => {
    const { x3d, collection } = await showBatched(heap, 1);
    const random = numbers(7);
    const points = Array.from({ length: 200 }, () => [
      Math.floor(random.next().value * 300),
      Math.floor(random.next().value * 200),
    ]);
    const pickAll = () => points.map(([x, y]) => found(x3d, x!, y!));
    picture(x3d);
    const together = pickAll();
    await drawPlainly(collection, true);
    picture(x3d);
    const byThemselves = pickAll();
    expect(new Set(together.map(([id]) => id)).size).to.be.above(20);
    expect(together).to.eql(byThemselves);
  });
});
