import { expect } from 'chai';
import { explain } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { drawn, drawnAt, place, show, until, wait, position } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { bothSpellings } from '../../forms.js';

describe('attributes that are no fields', () => {
  for (const [spelling, markup] of bothSpellings(`
    <transform id="t" translation="1 2 3"><shape><sphere></sphere></shape></transform>
    <transform id="u" translation="9 8 7"><shape><sphere></sphere></shape></transform>
    <x3d-rigid-body-collection id="c"><x3d-rigid-body id="b"></x3d-rigid-body></x3d-rigid-body-collection>`)) {
    it(`${spelling} tags: for at run time gives the body the place of its Transform`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      world.reset();
      const body = x3d.querySelector('#b')!;
      for (const [name, at] of [
        ['t', [1, 2, 3]],
        ['u', [9, 8, 7]],
      ] as const) {
        body.setAttribute('for', name);
        world.step(0);
        expect(position(world, 'b')).to.eql(at);
      }
      world.advance(0.5);
      expect(position(world, 'b')[1]).to.be.below(7.5);
      await drawn();
      expect(drawnAt(x3d.querySelector('#u')!)[1]).to.be.closeTo(position(world, 'b')[1], 0.05);
      expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.closeTo(2, 1e-5);
      world.reset();
      expect(position(world, 'b')).to.eql([9, 8, 7]);
    });

    it(`${spelling} tags: a body with a pose of its own takes the Transform along`, async () => {
      const { x3d, world } = await show(
        markup.replace('id="b"', 'id="b" position="0 5 0" fixed="true"'),
        '#c',
      );
      world.paused = true;
      x3d.querySelector('#b')!.setAttribute('for', 't');
      world.step(0);
      expect(position(world, 'b')).to.eql([0, 5, 0]);
      await drawn();
      expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.closeTo(5, 1e-5);
    });

    it(`${spelling} tags: for nobody is reported in its own world only, until it is there`, async () => {
      claim('waits for "nope"');
      const { x3d, world } = await show(markup.replace('id="b"', 'id="b" for="nope"'), '#c');
      world.paused = true;
      const body = x3d.querySelector('#b')!;
      let ready = 0;
      x3d.addEventListener('physicsready', () => ready++);
      await until(() => world.problems.length > 0);
      await wait(30);
      expect(ready).to.equal(0);
      expect(
        world.problems.map(({ code, attribute, value, used }) => [code, attribute, value, used]),
      ).to.eql([['unknown-reference', 'for', 'nope', 'nothing']]);
      expect(explain(body).waits).to.include('for "nope"');
      x3d.querySelector('#u')!.id = 'nope';
      world.step(0);
      expect(position(world, 'b')).to.eql([9, 8, 7]);
      expect(world.problems).to.eql([]);
      expect(explain(body).waits).to.eql(['the world, which is paused']);
    });

    it(`${spelling} tags: unknown ones are reported, shared-world and default are followed`, async () => {
      claim('has no attribute mas;');
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      const body = x3d.querySelector('#b')!;
      body.setAttribute('mas', '3');
      world.step(0);
      const [problem] = world.problems;
      expect([problem.code, problem.value, problem.used]).to.eql([
        'unknown-attribute',
        '3',
        'nothing',
      ]);
      expect(problem.message).to.match(/^RigidBody "b" has/);
      body.removeAttribute('mas');
      world.step(0);
      expect(world.problems).to.eql([]);
      const collection = x3d.querySelector('#c')!;
      collection.setAttribute('shared-world', 'w');
      await until(() => worldOf(body) !== world);
      const shared = worldOf(body)!;
      collection.removeAttribute('shared-world');
      collection.setAttribute('default', '');
      await until(() => worldOf(body) !== shared);
      x3d
        .querySelector('scene')!
        .insertAdjacentHTML('beforeend', '<x3d-rigid-body id="free"></x3d-rigid-body>');
      await until(() => worldOf(x3d.querySelector('#free')!) === worldOf(body));
    });
  }

  it('are properties of custom elements', async () => {
    const { x3d, world } = await show(
      `<transform id="t" translation="1 2 3"><shape><sphere></sphere></shape></transform>
      <x3d-rigid-body-collection id="c"><x3d-rigid-body id="b"></x3d-rigid-body></x3d-rigid-body-collection>`,
      '#c',
    );
    world.paused = true;
    const body = x3d.querySelector('x3d-rigid-body')!;
    expect([body.for, body.getAttribute('for')]).to.eql(['', null]);
    body.for = 't';
    world.step(0);
    expect([body.for, body.getAttribute('for')]).to.eql(['t', 't']);
    expect(position(world, 'b')).to.eql([1, 2, 3]);
    const collection = x3d.querySelector('x3d-rigid-body-collection')!;
    expect([collection.default, collection.sharedWorld]).to.eql([false, '']);
    collection.sharedWorld = 'w';
    expect(collection.getAttribute('shared-world')).to.equal('w');
    await until(() => body.world !== world);
    collection.removeAttribute('shared-world');
    collection.default = true;
    expect([collection.default, collection.hasAttribute('default')]).to.eql([true, true]);
    collection.default = false;
    expect(collection.hasAttribute('default')).to.equal(false);
  });

  it('collidables is the word for all, and what there is', async () => {
    const { x3d, world } = await show(
      `<x3d-rigid-body-collection><x3d-collision-collection id="k"></x3d-collision-collection></x3d-rigid-body-collection>`,
    );
    world.paused = true;
    const colliders = x3d.querySelector('x3d-collision-collection')!;
    const read = (): unknown => (world.step(0), world.node('k')!.get('collidables'));
    expect([read(), colliders.collidables]).to.eql([[], []]);
    for (const nothing of ['', null]) {
      colliders.collidables = '*';
      expect([read(), colliders.collidables]).to.eql(['*', '*']);
      colliders.collidables = nothing;
      expect([read(), colliders.collidables]).to.eql([[], []]);
    }
  });

  it('set before the element is defined or attached take effect, too', async () => {
    const x3d = place(
      `<transform id="t" translation="1 2 3"><shape><sphere></sphere></shape></transform>`,
    );
    const body = Object.assign(document.createElement('x3d-rigid-body'), { for: 't', id: 'b' });
    x3d.querySelector('scene')!.append(body);
    const world = await worldOf(body)!.ready;
    world.paused = true;
    world.reset();
    expect(position(world, 'b')).to.eql([1, 2, 3]);
  });
});
