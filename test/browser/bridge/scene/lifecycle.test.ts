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

  it('in a hidden page stands still, unless run-hidden', async () => {
    const x3d = place(`
      <x3d-rigid-body-collection id="still"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>
      <x3d-rigid-body-collection id="runs" run-hidden><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>`);
    const [still, runs] = ['#still', '#runs'].map((id) => worldOf(x3d.querySelector(id)!)!);
    await Promise.all([still.ready, runs.ready]);
    const hide = (hidden: boolean): void => {
      Object.defineProperty(document, 'hidden', { configurable: true, value: hidden });
      document.dispatchEvent(new Event('visibilitychange'));
    };
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
});
