import { expect } from 'chai';
import type { X3DRigidBodyElement } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { place, show, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';

const world = (x3d: Element, selector: string) => worldOf(x3d.querySelector(selector)!)!;

describe('worlds', () => {
  it('each collection is one, unless they share a name', async () => {
    const { x3d } = await show(`
      <RigidBodyCollection id="a"><RigidBody id="ab"></RigidBody></RigidBodyCollection>
      <RigidBodyCollection id="b"></RigidBodyCollection>
      <x3d-rigid-body-collection id="c" shared-world="w" gravity="0 -1 0"><x3d-rigid-body id="cb"></x3d-rigid-body></x3d-rigid-body-collection>
      <RigidBodyCollection id="d" shared-world="w" gravity="0 -2 0"><RigidBody id="db"></RigidBody></RigidBodyCollection>
      <x3d-rigid-body id="free"></x3d-rigid-body>
      <x3d-rigid-body-collection id="default" default gravity="0 1 0"></x3d-rigid-body-collection>`);
    expect(world(x3d, '#a')).not.to.equal(world(x3d, '#b'));
    expect(world(x3d, '#ab')).to.equal(world(x3d, '#a'));
    expect(world(x3d, '#c')).to.equal(world(x3d, '#d'));
    expect(world(x3d, '#free')).to.equal(world(x3d, '#default'));
    await world(x3d, '#free').ready;
    await world(x3d, '#c').ready;
    for (const each of ['#free', '#c']) {
      world(x3d, each).paused = true;
      world(x3d, each).reset();
      world(x3d, each).advance(1);
    }
    const velocity = (selector: string): number =>
      (
        world(x3d, selector).node(x3d.querySelector(selector))!.get('linearVelocity') as number[]
      )[1];
    expect(velocity('#free')).to.be.closeTo(1, 0.01);
    expect(velocity('#cb')).to.be.closeTo(-1, 0.01);
    expect(velocity('#db')).to.be.closeTo(-2, 0.01);
  });

  it('the world object is there before the start, and ready once', async () => {
    const x3d = place(`<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>`);
    const collection = x3d.querySelector('x3d-rigid-body-collection')!;
    let ready = 0;
    collection.addEventListener('physicsready', () => ready++);
    const before = worldOf(collection)!;
    expect(before.step(1)).to.equal(0);
    expect(await before.ready).to.equal(before);
    await wait(20);
    expect(ready).to.equal(1);
    expect(collection.world).to.equal(before);
  });

  it('shared-world at an Inline joins its collections with those of the page', async () => {
    const x3d = place(`
      <RigidBodyCollection id="c" shared-world="w"><RigidBody DEF="page"></RigidBody></RigidBodyCollection>
      <inline url="/test/pages/settling-crate.x3d" shared-world="w"></inline>`);
    await world(x3d, '#c').ready;
    expect(world(x3d, '#c').stats.bodies).to.equal(3);
  });

  it('a body moved in the tree within one task keeps its pose and velocity', async () => {
    const { x3d } = await show(`
      <x3d-rigid-body-collection id="a"><x3d-rigid-body id="b" position="0 9 0"></x3d-rigid-body></x3d-rigid-body-collection>
      <x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>`);
    const first = world(x3d, '#a');
    await world(x3d, '#c').ready;
    first.paused = world(x3d, '#c').paused = true;
    first.advance(1);
    const body = x3d.querySelector<X3DRigidBodyElement>('#b')!;
    const [position, velocity] = [body.position, body.linearVelocity];
    x3d.querySelector('#a')!.append(body);
    expect(body.position).to.eql(position);
    x3d.querySelector('#c')!.append(body);
    expect(body.position[1]).to.be.closeTo(position[1], 1e-5);
    expect(body.linearVelocity[1]).to.be.closeTo(velocity[1], 1e-5);
    expect(world(x3d, '#b')).to.equal(world(x3d, '#c'));
    expect(first.stats.bodies).to.equal(0);
    body.remove();
    await wait(20);
    x3d.querySelector('#c')!.append(body);
    expect(body.position).to.eql([0, 9, 0]);
  });
});

describe('references', () => {
  it('work forwards, late, and again when a match comes or goes', async () => {
    claim('unknown-reference');
    const { x3d, world: w } = await show(`
      <x3d-rigid-body-collection id="c">
        <x3d-ball-joint id="j" body1="late" body2="b" anchorpoint="0 0 0"></x3d-ball-joint>
        <x3d-rigid-body id="b"></x3d-rigid-body>
      </x3d-rigid-body-collection>`);
    w.paused = true;
    expect(w.stats.joints).to.equal(0);
    expect(w.problems.map(({ code }) => code)).to.eql(['unknown-reference']);
    const late = document.createElement('x3d-rigid-body');
    late.id = 'late';
    x3d.querySelector('#c')!.append(late);
    w.step(0);
    expect(w.stats.joints).to.equal(1);
    expect(w.problems).to.eql([]);
    claim('unknown-reference');
    late.id = 'other';
    w.step(0);
    expect(w.stats.joints).to.equal(0);
    late.id = 'late';
    w.step(0);
    expect(w.stats.joints).to.equal(1);
    claim('unknown-reference');
    late.remove();
    w.step(0);
    expect(w.stats.joints).to.equal(0);
  });

  it('a collidable used twice belongs to the first body, then to the second', async () => {
    claim('already-owned');
    const { x3d, world: w } = await show(`
      <x3d-rigid-body-collection id="c">
        <x3d-rigid-body id="a"><x3d-collidable-shape use="s"></x3d-collidable-shape></x3d-rigid-body>
        <x3d-rigid-body id="b"><x3d-collidable-shape use="s"></x3d-collidable-shape></x3d-rigid-body>
      </x3d-rigid-body-collection>
      <x3d-collidable-shape def="s"><shape><sphere></sphere></shape></x3d-collidable-shape>`);
    w.paused = true;
    expect(w.problems.map(({ code }) => code)).to.eql(['already-owned']);
    const geometry = (id: string): unknown[] => w.node(id)!.get('geometry') as unknown[];
    expect([geometry('a').length, geometry('b').length]).to.eql([1, 0]);
    x3d.querySelector('#a')!.remove();
    w.step(0);
    expect(geometry('b').length).to.equal(1);
    expect(w.problems).to.eql([]);
  });

  it('the last DEF wins and duplicates are reported', async () => {
    claim('duplicate-def');
    const { x3d, world: w } = await show(`
      <RigidBodyCollection>
        <RigidBody DEF="b" position="1 0 0"></RigidBody><RigidBody DEF="b" position="2 0 0"></RigidBody>
        <BallJoint DEF="j"><RigidBody USE="b" containerField="body1"></RigidBody></BallJoint>
      </RigidBodyCollection>`);
    expect((w.node('j')!.get('body1') as { host: Element }).host).to.equal(
      x3d.querySelectorAll('[def=b]')[1],
    );
    expect(w.problems.map(({ code }) => code)).to.include('duplicate-def');
  });
});
