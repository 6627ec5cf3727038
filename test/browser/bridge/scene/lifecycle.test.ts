import { expect } from 'chai';
import { drawnAt, nextFrame, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { ball } from './lifecycle.js';

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
});
