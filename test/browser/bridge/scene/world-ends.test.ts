import { expect } from 'chai';
import { nextFrame, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { append, ball, collection, outcome } from './collections.js';

describe('a world', () => {
  it('that ended takes what is asked of it without a word and without moving', async () => {
    const { x3d, world } = await show(collection());
    world.step(1);
    const snapshot = world.snapshot();
    x3d.querySelector('x3d-rigid-body-collection')!.remove();
    await wait(0);
    expect(await outcome(world)).to.equal('ready');
    expect(world.step(5)).to.equal(0);
    expect(world.advance(1)).to.equal(0);
    expect(world.raycast([0, 9, 0], [0, -9, 0])).to.equal(null);
    expect(world.stats).to.include({ bodies: 0, awake: 0, joints: 0, contacts: 0 });
    world.paused = true;
    world.paused = false;
    world.reset();
    world.restore(snapshot);
    world.accuracy = 'fine';
    expect(world.node('nobody')).to.equal(undefined);
    expect(world.problems).to.eql([]);
    await nextFrame();
    expect(world.started).to.equal(false);
  });

  it('shared, ends with the last of its collections', async () => {
    const { x3d, world } = await show(
      collection('id="a" shared-world="w"') +
        collection('id="b" shared-world="w"', ball('position="9 0 0"')),
    );
    x3d.querySelector('#a')!.remove();
    await wait(0);
    world.step(0);
    expect([world.started, world.stats.bodies]).to.eql([true, 1]);
    x3d.querySelector('#b')!.remove();
    await wait(0);
    expect(world.started).to.equal(false);
    const again = worldOf(append(x3d, collection('shared-world="w"')))!;
    expect(again).not.to.equal(world);
    expect(await outcome(again)).to.equal('ready');
  });

  it('whose last collection a listener takes away during a step ends after that step', async () => {
    const { x3d, world } = await show(collection());
    world.paused = true;
    const element = x3d.querySelector('x3d-rigid-body-collection')!;
    for (const type of ['beforestep', 'afterstep'])
      element.addEventListener(type, () => element.remove(), { once: true });
    world.step(3);
    expect(world.started).to.equal(true);
    await wait(0);
    expect(world.started).to.equal(false);
  });

  it('with nodes that script added lives as long as those', async () => {
    const { x3d, world } = await show(collection());
    const own = world.add('RigidBody', { position: [0, 5, 0] });
    x3d.querySelector('x3d-rigid-body-collection')!.remove();
    await wait(0);
    world.step(0);
    expect([world.started, world.stats.bodies]).to.eql([true, 1]);
    own.remove();
    await until(() => !world.started);
  });
});
