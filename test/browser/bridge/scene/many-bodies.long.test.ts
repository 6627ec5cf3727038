import { expect } from 'chai';
import { nextFrame, show } from '../../scene.js';
import { worldOf } from '../../inside.js';

const ball = `<transform id="t" translation="0 3 0"><shape><sphere></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`;

describe('many bodies', () => {
  it('appended one by one make only their own objects', async () => {
    const { x3d } = await show(ball, '#ball');
    const world = worldOf(x3d.querySelector('#ball')!)!;
    world.paused = true;
    world.step(0);
    const scene = x3d.querySelector('scene')!;
    const made: number[] = [];
    const { patched, destroyed } = world.stats;
    for (let i = 0; i < 600; i++) {
      const before = world.stats.created;
      scene.insertAdjacentHTML(
        'beforeend',
        `<transform translation="${i * 3} 9 0"><shape><box></box></shape><x3d-rigid-body></x3d-rigid-body></transform>`,
      );
      world.step(0);
      made.push(world.stats.created - before);
    }
    expect(world.stats.bodies).to.equal(601);
    expect(new Set(made).size).to.equal(1);
    expect(world.stats).to.include({ patched, destroyed });
  });

  it('with joints, added and removed 300 times, leave the world and the heap as they were', async () => {
    const { x3d, world } = await show(ball, '#ball');
    world.paused = true;
    const scene = x3d.querySelector('scene')!;
    const cycle = (i: number): void => {
      scene.insertAdjacentHTML(
        'beforeend',
        `<transform id="added" translation="1 3 ${i % 7}">
          <shape><indexedfaceset coordindex="0 2 1 -1 0 1 3 -1 0 3 2 -1 1 2 3 -1"><coordinate point="0 0 0, 1 0 0, 0 1 0, 0 0 1"></coordinate></indexedfaceset></shape>
          <x3d-rigid-body id="swinging"></x3d-rigid-body>
        </transform>
        <x3d-ball-joint id="joint" body1="ball" body2="swinging" anchorpoint="1 3 0"></x3d-ball-joint>`,
      );
      world.step(2);
      expect([world.stats.bodies, world.stats.joints]).to.eql([2, 1]);
      // Either may go first.
      if (i % 2) x3d.querySelector('#joint')!.remove();
      x3d.querySelector('#added')!.remove();
      x3d.querySelector('#joint')?.remove();
      world.step(0);
      expect([world.stats.bodies, world.stats.joints]).to.eql([1, 0]);
    };
    const cycles = async (count: number): Promise<void> => {
      for (let i = 0; i < count; i++) cycle(i);
      await nextFrame();
    };
    // A block taken for good: where nothing leaks, those before and after the cycles lie as far apart as two at once.
    const heap = world.engine.ammo as unknown as { _malloc(bytes: number): number };
    const take = (): number => heap._malloc(65536);
    // The first rounds fill holes.
    for (let i = 0; i < 3; i++) {
      await cycles(100);
      take();
    }
    const [first, second] = [take(), take()];
    await cycles(100);
    take();
    const size = [[...world.nodes].length, world.stats.heapBytes];
    const before = take();
    await cycles(300);
    expect(take() - before).to.equal(second! - first!);
    expect([[...world.nodes].length, world.stats.heapBytes]).to.eql(size);
  });
});
