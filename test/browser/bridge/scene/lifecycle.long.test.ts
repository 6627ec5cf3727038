import { expect } from 'chai';
import { drawn, drawnAt, nextFrame, place, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { ball } from './lifecycle.js';

/** Until its `end`, which answers the seconds that the longest frame took: on a busy machine some take several. */
function longestFrame(): { end(): number } {
  let [longest, last] = [0, performance.now()];
  const look = (): void => {
    const now = performance.now();
    longest = Math.max(longest, (now - last) / 1000);
    last = now;
    request = requestAnimationFrame(look);
  };
  let request = requestAnimationFrame(look);
  return {
    end() {
      cancelAnimationFrame(request);
      return longest;
    },
  };
}

describe('an x3d', () => {
  it('may be removed and put back again and again', async () => {
    const { x3d } = await show(ball, '#ball');
    for (let i = 0; i < 3; i++) {
      x3d.remove();
      await wait(20);
      document.body.append(x3d);
      const world = worldOf(x3d.querySelector('#ball')!)!;
      await world.ready;
      await wait(30);
      world.paused = true;
      world.reset();
      expect(world.node('ball')!.get('position')).to.eql([0, 3, 0]);
      world.advance(0.5);
      await drawn();
      expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.closeTo(3 - 4.9 * 0.25, 0.05);
    }
    expect(x3d.querySelectorAll('canvas').length).to.equal(1);
  });

  it('whose WebGL context the browser took away can still be removed, and put back', async () => {
    const { x3d } = await show(ball, '#ball');
    await drawn();
    const canvas = x3d.querySelector('canvas')!;
    const context = (canvas.getContext('webgl2') ?? canvas.getContext('webgl'))!;
    (context.getExtension('WEBGL_lose_context') as WEBGL_lose_context).loseContext();
    await until(() => context.isContextLost());
    x3d.remove();
    await wait(20);
    document.body.append(x3d);
    await worldOf(x3d.querySelector('#ball')!)!.ready;
    await drawn();
    expect(x3d.querySelectorAll('canvas').length).to.equal(1);
    x3d.remove();
    await wait(20);
  });

  it('scrolled away stands still and goes on without a jump, unless run-hidden', async () => {
    const x3d = place(`
      <x3d-rigid-body-collection id="still"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>
      <x3d-rigid-body-collection id="runs" run-hidden><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>`);
    const [still, runs] = ['#still', '#runs'].map((id) => worldOf(x3d.querySelector(id)!)!);
    await Promise.all([still.ready, runs.ready]);
    x3d.style.cssText = 'position: absolute; left: -5000px';
    await wait(500);
    const [stood, ran] = [still.time, runs.time];
    await until(() => runs.time > ran + 0.5);
    expect(still.time).to.equal(stood);
    x3d.style.cssText = '';
    const back = performance.now();
    await until(() => still.time > stood);
    // What it was away for, half a second and more, is not caught up.
    expect(still.time - stood).to.be.below((performance.now() - back) / 1000 + 0.1);
  });

  it('misses no time when another scrolls in and out of view', async () => {
    document.body.innerHTML = [0, 1]
      .map((i) => `<x3d id="x${i}" width="50px" height="50px"><scene>${ball}</scene></x3d>`)
      .join('');
    const [x0, x1] = [...document.body.children] as HTMLElement[];
    const [world, other] = [x0, x1].map((x3d) => worldOf(x3d!.querySelector('#ball')!)!);
    await Promise.all([world!.ready, other!.ready]);
    let dropped = 0;
    world!.on('lag', (lag) => (dropped += (lag as { dropped: number }).dropped));
    await until(() => world!.time > 0.1);
    // What has passed since the frame before is to be in both times.
    await nextFrame();
    const [time, from] = [world!.time, performance.now()];
    const frames = longestFrame();
    for (let i = 0; i < 20; i++) {
      x1!.style.cssText = i % 2 ? '' : 'position: absolute; left: -5000px';
      await wait(70);
    }
    await nextFrame();
    const passed = (performance.now() - from) / 1000;
    // A frame and a step at either end; each of ten returns used to cost a frame.
    expect(world!.time + dropped - time).to.be.closeTo(passed, 0.03 + 2 * frames.end());
  });

  it('in a hidden page stands still, unless run-hidden', async () => {
    const x3d = place(`
      <x3d-rigid-body-collection id="still"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>
      <x3d-rigid-body-collection id="runs" run-hidden><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>`);
    const [still, runs] = ['#still', '#runs'].map((id) => worldOf(x3d.querySelector(id)!)!);
    await Promise.all([still.ready, runs.ready]);
    hide(true);
    try {
      await nextFrame();
      const [stood, ran] = [still.time, runs.time];
      await until(() => runs.time > ran + 1);
      expect(still.time).to.equal(stood);
      hide(false);
      const back = performance.now();
      await until(() => still.time > stood);
      expect(still.time - stood).to.be.below((performance.now() - back) / 1000 + 0.1);
    } finally {
      delete (document as { hidden?: boolean }).hidden;
    }
  });

  it('hidden for a moment goes on without a jump, and with run-hidden misses nothing', async () => {
    const x3d = place(`
      <x3d-rigid-body-collection id="still"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>
      <x3d-rigid-body-collection id="runs" run-hidden><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>`);
    const [still, runs] = ['#still', '#runs'].map((id) => worldOf(x3d.querySelector(id)!)!);
    await Promise.all([still.ready, runs.ready]);
    await until(() => still.time > 0.1);
    for (const away of [300, 1500])
      try {
        hide(true);
        const [stood, ran, from] = [still.time, runs.time, performance.now()];
        await wait(away);
        hide(false);
        expect(still.time).to.equal(stood);
        // A step, and the clock of frames.
        const hidden = (performance.now() - from) / 1000;
        expect(runs.time - ran).to.be.closeTo(hidden, 0.03);
        const back = performance.now();
        await until(() => still.time > stood);
        expect(still.time - stood).to.be.at.most((performance.now() - back) / 1000 + 1 / 60);
      } finally {
        delete (document as { hidden?: boolean }).hidden;
      }
  });

  it('in a hidden page asks for nothing at all, unless run-hidden', async () => {
    const { world } = await show(ball, '#ball');
    const { setTimeout } = window;
    let timers = 0;
    try {
      hide(true);
      await wait(1200);
      window.setTimeout = ((...args: Parameters<typeof setTimeout>) => {
        timers++;
        return setTimeout(...args);
      }) as typeof setTimeout;
      const time = world.time;
      await new Promise((resolve) => setTimeout(resolve, 1200));
      expect([timers, world.time]).to.eql([0, time]);
    } finally {
      window.setTimeout = setTimeout;
      delete (document as { hidden?: boolean }).hidden;
      document.dispatchEvent(new Event('visibilitychange'));
    }
  });
});

/** As the browser tells it. */
function hide(hidden: boolean): void {
  Object.defineProperty(document, 'hidden', { configurable: true, value: hidden });
  document.dispatchEvent(new Event('visibilitychange'));
}
