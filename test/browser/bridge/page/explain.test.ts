import { expect } from 'chai';
import { explain } from '../../../../elements/index.js';
import { open, worldIn } from '../../page.js';
import { claim } from '../../console.js';
import { show, until, wait } from '../../scene.js';
import type { World } from '../../inside.js';

const SCENE = `
  <x3d-rigid-body-collection id="collection">
    <x3d-rigid-body id="floor" fixed position="0 -0.5 0">
      <x3d-collidable-shape><shape><box size="10 1 10"></box></shape></x3d-collidable-shape>
    </x3d-rigid-body>
    <x3d-rigid-body id="stone" for="t" mass="2"></x3d-rigid-body>
    <x3d-ball-joint id="joint" body1="stone" anchorPoint="0 5 0"></x3d-ball-joint>
  </x3d-rigid-body-collection>
  <transform id="t" translation="0 0.5 0"><shape id="s"><box id="g" size="1 1 1"></box></shape></transform>`;

async function resting(content = SCENE) {
  const { x3d, world } = await show(content);
  world.paused = true;
  world.advance(0.25);
  const find = (id: string): Element => x3d.querySelector(`#${id}`)!;
  return { x3d, world, find };
}

describe('explain', () => {
  it('has what Bullet has and what it touches, nobody listening', async () => {
    const { world, find } = await resting();
    const { bullet, touches } = explain(find('stone'));
    expect(touches).to.eql(['x3d-rigid-body[id="floor"]']);
    expect(bullet!.state).to.equal('awake');
    expect(bullet!.mass).to.equal(2);
    expect((bullet!.shapes as { type: string }[]).map(({ type }) => type)).to.eql(['box']);
    expect(bullet!.joints).to.eql(['x3d-ball-joint[id="joint"]']);
    expect(explain(find('floor')).touches).to.eql(['x3d-rigid-body[id="stone"]']);
    expect(explain(find('joint')).bullet).to.have.keys('anchor', 'frame', 'gap', 'rows');
    expect(explain(find('collection')).bullet).to.deep.include({ level: 'standard', bodies: 2 });
    expect(explain(find('collection')).touches).to.equal(undefined);
    expect(world.effects.find(({ name }) => name === 'contact reading')!.active).to.equal(false);
  });

  it('of a Transform, a Shape and a geometry is that of the body that moves them', async () => {
    const { find } = await resting();
    for (const id of ['t', 's', 'g']) {
      const { element, type, bullet } = explain(find(id));
      const stone = 'x3d-rigid-body[id="stone"]';
      expect([element, type, bullet!.state]).to.eql([stone, 'RigidBody', 'awake']);
    }
    const nothing = explain(document.body);
    expect([nothing.type, nothing.bullet, nothing.touches]).to.eql([
      undefined,
      undefined,
      undefined,
    ]);
  });

  it('says what is simulated in the place of what was written', async () => {
    claim('concave-dynamic');
    const hollow = `<x3d-rigid-body-collection gravity="0 0 0"><x3d-rigid-body id="b" for="t"></x3d-rigid-body></x3d-rigid-body-collection>
      <transform id="t"><shape><indexedtriangleset index="0 1 2 0 2 3 0 3 1" solid="false">
        <coordinate point="0 0 0 1 0 0 0 1 0 0 0 1"></coordinate></indexedtriangleset></shape></transform>`;
    const { find } = await resting(hollow);
    const { bullet, approximations } = explain(find('b'));
    expect((bullet!.shapes as { type: string }[])[0]!.type).to.equal('hull');
    expect(approximations[0]).to.contain('convex hull');
  });

  it('says what it waits for: the world, its collection, its bodies, names', async () => {
    claim('unknown-reference');
    const { world, find } = await resting();
    expect(explain(find('stone')).waits).to.eql(['the world, which is paused']);
    world.paused = false;
    find('collection').setAttribute('enabled', 'false');
    world.step(0);
    expect(explain(find('stone')).waits).to.eql(['enabled of its collection']);
    find('collection').removeAttribute('enabled');
    find('stone').setAttribute('enabled', 'false');
    world.step(0);
    expect(explain(find('joint')).waits).to.eql(['its bodies']);
    expect(explain(find('stone')).bullet!.state).to.equal('taken out: not enabled');
    expect(find('joint').matches(':state(waiting)')).to.equal(false);
    find('joint').setAttribute('body2', 'later');
    await wait(0);
    expect(explain(find('joint')).waits).to.include('body2 "later"');
    expect(find('joint').matches(':state(waiting)')).to.equal(true);
    find('joint').removeAttribute('body2');
    await wait(0);
    expect(find('joint').matches(':state(waiting)')).to.equal(false);
  });

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
    await wait(50);
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
