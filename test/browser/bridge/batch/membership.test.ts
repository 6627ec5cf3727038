import { expect } from 'chai';
import { drawn, until } from '../../scene.js';
import {
  bodies,
  colored,
  covered,
  difference,
  draws,
  drawPlainly,
  picture,
  showBatched,
} from './pictures.js';
import { COUNT, boxes, find } from './members.js';

describe('bodies drawn in one call', () => {
  it('are eight at least, and four stay together', async () => {
    const shown = await showBatched(
      bodies(8, (i) => `${colored(i)}<box size="1 1 1"></box>`),
      1,
    );
    const { x3d } = shown;
    const counts: number[] = [];
    for (let i = 0; i < 6; i++) {
      find(shown, `#t${i}`).remove();
      await drawn();
      counts.push(draws(x3d));
    }
    expect(counts).to.eql([1, 1, 1, 1, 3, 2]);
  });

  it('are seen where the simulation takes them', async () => {
    const { x3d, world, collection } = await showBatched(boxes, 1);
    const before = picture(x3d);
    collection.setAttribute('enabled', 'true');
    world.paused = true;
    world.advance(0.3);
    await drawn();
    const together = picture(x3d);
    expect(difference(before, together).any).to.be.above(3000);
    await drawPlainly(collection, true);
    expect(difference(together, picture(x3d)).any).to.equal(0);
  });
});

describe('bodies of unlike looks', () => {
  it('are left to x3dom', async () => {
    const unlike = bodies(COUNT, (i) => `${colored(i)}<cone height="${1 + i / 100}"></cone>`);
    const { x3d, world } = await showBatched(unlike, COUNT);
    await until(() => world.stats.batches === 0);
    await drawn();
    expect(draws(x3d)).to.equal(COUNT);
    expect(covered(picture(x3d))).to.be.above(500);
  });
});
