import { expect } from 'chai';
import { claim } from '../../console.js';
import { worldOf } from '../../inside.js';
import { codes, position, show, until } from '../../scene.js';

const ball = (name: string, x: number): string =>
  `<x3d-rigid-body id="${name}" position="${x} 0 0"><x3d-collidable-shape><shape><sphere></sphere></shape></x3d-collidable-shape></x3d-rigid-body>`;

describe('the heap limit', () => {
  it('is told of once, however many bodies find no room, and the page lives', async () => {
    claim('has no room for');
    const { x3d, world } = await show(
      `<x3d-rigid-body-collection id="full">${ball('first', 0)}</x3d-rigid-body-collection>
       <x3d-rigid-body-collection id="other">${ball('free', 0)}</x3d-rigid-body-collection>`,
      '#full',
    );
    const full = x3d.querySelector('#full')!;
    const other = worldOf(x3d.querySelector('#other')!)!;
    await other.ready;
    world.paused = true;
    // The heap starts at 16 MB, the least limit; 24 MB more let it grow past that.
    const heap = world.engine.ammo as unknown as { _malloc(bytes: number): number };
    if (world.stats.heapBytes <= 16 * 2 ** 20) heap._malloc(24 * 2 ** 20);
    full.setAttribute('heap-limit', '16');
    for (let i = 1; i <= 100; i++) full.insertAdjacentHTML('beforeend', ball(`late${i}`, 3 * i));
    await until(() => codes(world).length > 0);
    world.step(0);
    expect(codes(world)).to.eql(['heap-exhausted']);
    expect([world.paused, world.stats.bodies]).to.eql([true, 1]);

    // The others go on, and this one as soon as it may.
    const [, height] = position(other, 'free');
    await until(() => position(other, 'free')[1]! < height! - 0.1);
    expect(codes(other)).to.eql([]);
    full.setAttribute('heap-limit', '2000');
    world.paused = false;
    await until(() => world.stats.bodies === 101);
    expect(codes(world)).to.eql([]);
  });
});
