import { expect } from 'chai';
import { show, until } from '../../scene.js';
import { worldOf } from '../../inside.js';

describe('shared-world at an Inline', () => {
  it('may change at run time, and the Inline is in the world of its own collection', async () => {
    const { x3d, world } = await show(`
      <x3d-rigid-body-collection id="c" shared-world="w"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>
      <inline url="/test/pages/settling-crate.x3d"></inline>`);
    const inline = x3d.querySelector('inline')!;
    await until(() => worldOf(inline) !== world);
    const own = worldOf(inline)!;
    await own.ready;
    world.paused = own.paused = true;
    expect([world.stats.bodies, own.stats.bodies]).to.eql([1, 2]);
    inline.setAttribute('shared-world', 'w');
    world.step(0);
    expect(worldOf(inline)).to.equal(world);
    expect([world.stats.bodies, own.stats.bodies]).to.eql([3, 0]);
    inline.removeAttribute('shared-world');
    own.step(0);
    expect(worldOf(inline)).to.equal(own);
    expect([world.stats.bodies, own.stats.bodies]).to.eql([1, 2]);
  });
});
