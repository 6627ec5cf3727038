import { expect } from 'chai';
import { mouse } from '../outward/dragging/hand.js';
import { drawn, place, until, wait } from '../../scene.js';
import { FrameTime, inView, step, taken } from '../../time.js';
import { worldOf } from '../../inside.js';
import { type X3D, box, floor, SCENE, atRest, count, NOTHING, CAUSES } from './at-rest.js';

afterEach(() => mouse.up());

describe('a world in which everything is asleep', () => {
  it('leaves nothing of x3dom that turns unseen and has the browser draw the page for ever', async () => {
    await atRest();
    const turning = document.getAnimations().filter(({ playState }) => playState === 'running');
    expect(turning.map(({ effect }) => (effect as KeyframeEffect).target?.className)).to.deep.equal(
      [],
    );
  });

  it('is at rest beside one that moves', async () => {
    const { x3d, world } = await atRest(
      SCENE.replace('default', '') +
        `<x3d-rigid-body-collection id="busy"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>`,
    );
    const busy = worldOf(x3d.querySelector('#busy')!)!;
    let told = 0;
    world.on('beforestep', () => told++);
    const stop = count(x3d, world);
    const [time, from] = [world.time, busy.time];
    await until(() => busy.time > from + 0.3);
    // That one has the page's frames, and no Transform that it moves.
    expect({ ...stop(), frames: 0, drawn: 0 }).to.deep.equal(NOTHING);
    expect([world.time, told]).to.eql([time, 0]);
  });

  for (const [cause, act] of Object.entries(CAUSES))
    it(`goes on without a jump in time after ${cause}`, async () => {
      const { x3d, world } = await atRest();
      const still = performance.now();
      await wait(300);
      expect(performance.now() - still).to.be.above(290);
      const time = cause === 'reset()' ? 0 : world.time;
      const stood = time + world.stepping.dropped;
      const frames = new FrameTime();
      await act(x3d, world);
      await until(() => taken(world) > stood);
      // It had stood for 0.3 s.
      expect(taken(world) - stood).to.be.at.most(frames.stop() + step(world));
      await until(() => world.time > time + 0.1);
    });

  it('is drawn anew where an edit of it changes what is to be seen, and moves no further', async () => {
    const { x3d, world } = await atRest(
      `<x3d-rigid-body-collection default></x3d-rigid-body-collection>${floor}`,
      '#c, x3d-rigid-body',
    );
    const stop = count(x3d, world);
    (x3d.querySelector('x3d-rigid-body') as any).teleport([0, 3, 0]);
    await drawn();
    await wait(300);
    const counts = stop();
    expect(counts.written).to.be.within(1, 3);
    expect(counts.drawn).to.be.within(1, 3);
    expect(world.stepping.needsFrame).to.equal(false);
  });
});

describe('what nobody sees', () => {
  it('runs on with run-hidden, and is drawn when it comes into view', async () => {
    const x3d = place(
      `<x3d-rigid-body-collection default run-hidden></x3d-rigid-body-collection>
       <transform>${box('1 1 1')}<x3d-rigid-body></x3d-rigid-body></transform>`,
    ) as X3D;
    const world = worldOf(x3d.querySelector('x3d-rigid-body')!)!;
    await world.ready;
    x3d.style.cssText = 'position: absolute; left: -5000px';
    await inView(x3d, false);
    await drawn();
    const stop = count(x3d, world);
    await until(() => world.stepsTaken > 60);
    await wait(100);
    expect(stop().drawn).to.equal(0);
    const again = count(x3d, world);
    x3d.style.cssText = '';
    await inView(x3d, true);
    expect(again().drawn).to.be.above(0);
  });
});
