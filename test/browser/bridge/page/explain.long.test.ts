import { expect } from 'chai';
import { explain } from '../../../../elements/index.js';
import { open, worldIn } from '../../page.js';
import { show, until } from '../../scene.js';
import type { World } from '../../inside.js';
import { SCENE } from './explained.js';

describe('explain', () => {
  it('works for plain tags, from the classic script', async () => {
    const page = await open('plain.html');
    const world = await worldIn(page);
    world.paused = true;
    world.advance(2);
    const { X3DPhysics } = page as unknown as {
      X3DPhysics: { explain(element: Element): ReturnType<typeof explain> };
    };
    const ball = page.document.querySelector('RigidBody[DEF="ball"]')!;
    const { bullet, touches, running } = X3DPhysics.explain(ball);
    expect(running).to.equal(true);
    expect(touches!.map((each) => page.document.querySelector(each)!.localName)).to.eql([
      'rigidbody',
    ]);
    expect(touches![0]).to.contain('"floor"');
    expect(bullet!.state).to.equal('awake');
  });
});

describe('User Timing', () => {
  const measured = async (world: World, run: () => void): Promise<string[]> => {
    const names = new Set<string>();
    const observer = new PerformanceObserver((list) => {
      for (const { name } of list.getEntries()) names.add(name);
    });
    observer.observe({ type: 'measure' });
    run();
    const { time } = world;
    await until(() => world.time > time + 0.1);
    for (const { name } of observer.takeRecords()) names.add(name);
    observer.disconnect();
    return [...names].filter((name) => name.startsWith('x3d-physics')).sort();
  };

  it('has a measure for each phase of a frame while world.profile is true, and keeps none', async () => {
    const { world } = await show(SCENE);
    world.on('beforestep', () => {});
    expect(await measured(world, () => {})).to.eql([]);
    const phases = ['events', 'read', 'step', 'write'].map((phase) => `x3d-physics ${phase}`);
    expect(await measured(world, () => (world.profile = true))).to.eql(phases);
    expect(performance.getEntriesByType('measure').length).to.equal(0);
    expect(await measured(world, () => (world.profile = false))).to.eql([]);
  });
});
