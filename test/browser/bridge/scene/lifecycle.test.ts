import { expect } from 'chai';
import { drawn, drawnAt, nextFrame, place, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';

const ball = `<transform id="t" translation="0 3 0"><shape><sphere></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`;

describe('an x3d', () => {
  it('moved within one task goes on with its world, and is drawn again', async () => {
    const { x3d, world } = await show(ball, '#ball');
    world.paused = true;
    world.advance(1);
    const y = (world.node('ball')!.get('position') as number[])[1];
    const box = document.createElement('div');
    document.body.append(box);
    box.append(x3d);
    const transform = x3d.querySelector('#t')!;
    // x3dom lets go of it at once and reads it anew, on a slow machine later.
    await nextFrame();
    await until(() => '_x3domNode' in transform && Math.abs(drawnAt(transform)[1]! - y!) < 1e-5);
    expect(worldOf(x3d.querySelector('#ball')!)).to.equal(world);
    expect((world.node('ball')!.get('position') as number[])[1]).to.equal(y);
    expect(x3d.querySelectorAll('canvas').length).to.equal(1);
    x3d.querySelector('#ball')!.setAttribute('mass', '4');
    world.step(0);
    expect(world.node('ball')!.get('mass')).to.equal(4);
  });

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

  it('has worlds of its own beside another', async () => {
    document.body.innerHTML = `<x3d id="a" width="100px" height="100px"><scene>${ball}</scene></x3d><x3d id="b" width="100px" height="100px"><scene>${ball}</scene></x3d>`;
    const [a, b] = ['#a', '#b'].map((id) => worldOf(document.querySelector(`${id} #ball`)!)!);
    expect(a).not.to.equal(b);
    await Promise.all([a.ready, b.ready]);
    expect([a.stats.bodies, b.stats.bodies]).to.eql([1, 1]);
  });

  it('built node by node, as a framework does, starts', async () => {
    document.body.innerHTML = '';
    const x3d = document.createElement('x3d');
    document.body.append(x3d);
    await wait(30);
    const scene = document.createElement('scene');
    x3d.append(scene);
    await wait(30);
    const collection = document.createElement('x3d-rigid-body-collection');
    scene.append(collection);
    await wait(30);
    collection.innerHTML = '<x3d-rigid-body id="b" position="0 2 0"></x3d-rigid-body>';
    const world = worldOf(collection)!;
    await world.ready;
    world.step(0);
    expect(world.stats.bodies).to.equal(1);
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
    const [time, from] = [world!.time, performance.now()];
    for (let i = 0; i < 20; i++) {
      x1!.style.cssText = i % 2 ? '' : 'position: absolute; left: -5000px';
      await wait(70);
    }
    await nextFrame();
    const passed = (performance.now() - from) / 1000;
    // A frame and a step at either end; each return used to cost a frame, 0.17 s of these.
    expect(world!.time + dropped - time).to.be.closeTo(passed, 0.06);
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
      await until(() => runs.time > ran + 1, 10_000);
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
