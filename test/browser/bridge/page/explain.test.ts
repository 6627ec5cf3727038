import { expect } from 'chai';
import { explain } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { show, wait } from '../../scene.js';
import { SCENE } from './explained.js';

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
});
