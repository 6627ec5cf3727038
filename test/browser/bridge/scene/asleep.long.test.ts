import { expect } from 'chai';
import { mouse } from '../outward/dragging/hand.js';
import { until, wait } from '../../scene.js';
import { atRest, count, NOTHING, stone, CAUSES } from './at-rest.js';

afterEach(() => mouse.up());

describe('a world in which everything is asleep', () => {
  it('takes no step, asks for no frame, writes nothing and has nothing drawn', async () => {
    const { x3d, world } = await atRest();
    const stop = count(x3d, world);
    const { time } = world;
    await wait(500);
    expect(stop()).to.deep.equal(NOTHING);
    expect(world.time).to.equal(time);
  });

  it('goes on when something that moves touches it, and wakes what is touched', async () => {
    const { x3d, world } = await atRest();
    const woken: number[] = [];
    stone(x3d).addEventListener('wake', () => woken.push(world.time));
    CAUSES['a new body']!(x3d, world);
    expect(stone(x3d).sleeping).to.equal(true);
    await until(() => woken.length > 0);
    expect(stone(x3d).sleeping).to.equal(false);
  });
});
