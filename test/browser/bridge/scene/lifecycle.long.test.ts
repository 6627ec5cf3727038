import { expect } from 'chai';
import { drawn, drawnAt, nextFrame, place, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { FrameTime, inView, step, taken } from '../../time.js';
import { ball } from './lifecycle.js';

const AWAY = 'position: absolute; left: -5000px';

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
    x3d.style.cssText = AWAY;
    await inView(x3d, false);
    const [stood, ran] = [taken(still), runs.time];
    await until(() => runs.time > ran + 0.5);
    expect(taken(still)).to.equal(stood);
    x3d.style.cssText = '';
    const frames = new FrameTime();
    await until(() => taken(still) > stood);
    // What it was away for, half a second and more, is not caught up.
    expect(taken(still) - stood).to.be.at.most(frames.stop() + step(still));
  });

  it('misses no time when another scrolls in and out of view', async () => {
    document.body.innerHTML = [0, 1]
      .map((i) => `<x3d id="x${i}" width="50px" height="50px"><scene>${ball}</scene></x3d>`)
      .join('');
    const [x0, x1] = [...document.body.children] as HTMLElement[];
    const [world, other] = [x0, x1].map((x3d) => worldOf(x3d!.querySelector('#ball')!)!);
    await Promise.all([world!.ready, other!.ready]);
    await until(() => world!.time > 0.1);
    const frames = new FrameTime();
    await nextFrame();
    // Between two frames both have seen the same ones.
    await wait(0);
    const [time, from] = [taken(world!), frames.passed];
    for (let i = 0; i < 20; i++) {
      x1!.style.cssText = i % 2 ? '' : AWAY;
      await inView(x1!, i % 2 > 0);
    }
    await wait(0);
    // Each of ten returns used to cost a frame.
    expect(taken(world!) - time).to.be.closeTo(frames.stop() - from, step(world!));
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
      const [stood, ran] = [taken(still), runs.time];
      await until(() => runs.time > ran + 1);
      expect(taken(still)).to.equal(stood);
      hide(false);
      const frames = new FrameTime();
      await until(() => taken(still) > stood);
      expect(taken(still) - stood).to.be.at.most(frames.stop() + step(still));
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
        const from = hide(true);
        const [stood, ran] = [taken(still), taken(runs)];
        await wait(away);
        const hidden = hide(false) - from;
        expect(taken(still)).to.equal(stood);
        // A page that gets no turn for two seconds was asleep.
        const [least, most] = [Math.min(hidden, 2) - step(runs), hidden + step(runs)];
        expect(taken(runs) - ran).to.be.within(least, most);
        const frames = new FrameTime();
        await until(() => taken(still) > stood);
        expect(taken(still) - stood).to.be.at.most(frames.stop() + step(still));
      } finally {
        delete (document as { hidden?: boolean }).hidden;
      }
  });

  it('shown again while a frame has begun, takes no time twice', async () => {
    const { world } = await show(
      '<x3d-rigid-body-collection run-hidden><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>',
    );
    const { requestAnimationFrame } = window;
    let frame: FrameRequestCallback = () => {};
    try {
      await until(() => world.time > 0.1);
      hide(true);
      await drawn();
      window.requestAnimationFrame = (callback) => {
        frame = callback;
        return 1;
      };
      const shown = hide(false);
      const time = taken(world);
      for (const [after, passed] of [
        [-0.04, 0],
        [0.02, 0.02],
        [0.04, 0.04],
      ] as const) {
        frame((shown + after) * 1000);
        expect(taken(world) - time).to.be.closeTo(passed, step(world));
      }
    } finally {
      window.requestAnimationFrame = requestAnimationFrame;
      requestAnimationFrame(frame);
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

/** As the browser tells it, in no time; answers when, in seconds. */
function hide(hidden: boolean): number {
  Object.defineProperty(document, 'hidden', { configurable: true, value: hidden });
  const now = performance.now();
  performance.now = () => now;
  document.dispatchEvent(new Event('visibilitychange'));
  delete (performance as { now?: unknown }).now;
  return now / 1000;
}
