import { expect } from 'chai';
import { explain, X3DRigidBodyElement } from '../../../elements/index.js';
import { claim } from '../console.js';
import { drawn, drawnAt, place, show, until, wait } from './scene.js';
import { worldOf } from '../inside.js';

const both = (markup: string): string[] => [
  markup,
  markup
    .replaceAll('x3d-rigid-body-collection', 'RigidBodyCollection')
    .replaceAll('x3d-rigid-body', 'RigidBody')
    .replaceAll('x3d-collidable-shape', 'CollidableShape'),
];
const spelling = (markup: string): string => (markup.includes('x3d-') ? 'custom' : 'plain');
const position = (world: { node(name: string): unknown }, name: string): number[] =>
  (world.node(name) as { get(field: string): number[] }).get('position');
const codes = (world: { problems: { code: string }[] }): string[] =>
  world.problems.map(({ code }) => code);

describe('attributes that are no fields', () => {
  for (const markup of both(`
    <transform id="t" translation="1 2 3"><shape><sphere></sphere></shape></transform>
    <transform id="u" translation="9 8 7"><shape><sphere></sphere></shape></transform>
    <x3d-rigid-body-collection id="c"><x3d-rigid-body id="b"></x3d-rigid-body></x3d-rigid-body-collection>`)) {
    it(`${spelling(markup)} tags: for at run time gives the body the place of its Transform`, async () => {
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

    it(`${spelling(markup)} tags: a body with a pose of its own takes the Transform along`, async () => {
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

    it(`${spelling(markup)} tags: for nobody is reported in its own world only, until it is there`, async () => {
      claim('waits for "nope"');
      const { x3d, world } = await show(markup.replace('id="b"', 'id="b" for="nope"'), '#c');
      world.paused = true;
      const body = x3d.querySelector('#b')!;
      let ready = 0;
      x3d.addEventListener('physicsready', () => ready++);
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

    it(`${spelling(markup)} tags: unknown ones are reported, shared-world and default are followed`, async () => {
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
      await wait(30);
      const shared = worldOf(body)!;
      expect(shared).not.to.equal(world);
      collection.removeAttribute('shared-world');
      collection.setAttribute('default', '');
      await wait(30);
      expect(worldOf(body)).not.to.equal(shared);
      x3d
        .querySelector('scene')!
        .insertAdjacentHTML('beforeend', '<x3d-rigid-body id="free"></x3d-rigid-body>');
      await wait(30);
      expect(worldOf(x3d.querySelector('#free')!)).to.equal(worldOf(body));
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
    await wait(30);
    expect(body.world).not.to.equal(world);
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

describe('names', () => {
  it('world.node takes the id of an element with a DEF', async () => {
    const { world } = await show(
      `<x3d-rigid-body-collection id="c"><x3d-rigid-body id="i" def="D"></x3d-rigid-body>
        <x3d-rigid-body id="D" def="E"></x3d-rigid-body></x3d-rigid-body-collection>`,
      '#c',
    );
    expect(world.node('i')).to.equal(world.node('D'));
    expect((world.node('D')!.host as Element).id).to.equal('i');
    expect((world.node('E')!.host as Element).id).to.equal('D');
    expect(world.node('nobody')).to.equal(undefined);
  });

  it('worldOf nothing is undefined', () => {
    expect(worldOf(null)).to.equal(undefined);
    expect(worldOf(undefined)).to.equal(undefined);
  });

  it('a class of ours under another tag has its properties and simulates', async () => {
    class Mine extends X3DRigidBodyElement {}
    customElements.define('my-body', Mine);
    const mine = new Mine();
    Object.assign(mine, { mass: 3, position: [0, 4, 0], id: 'm' });
    expect(mine.mass).to.equal(3);
    const { x3d, world } = await show(
      '<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>',
      '#c',
    );
    world.paused = true;
    x3d.querySelector('#c')!.append(mine);
    world.step(0);
    expect(world.node('m')!.get('mass')).to.equal(3);
    mine.setAttribute('mass', '5');
    expect(world.node(mine)!.get('mass')).to.equal(5);
    x3d.remove();
  });
});

describe('shared-world at an Inline', () => {
  it('may change at run time, and the Inline is in the world of its own collection', async () => {
    const { x3d, world } = await show(`
      <x3d-rigid-body-collection id="c" shared-world="w"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>
      <inline url="/test/pages/settling-crate.x3d"></inline>`);
    const inline = x3d.querySelector('inline')!;
    await until(() => worldOf(inline) !== world);
    const own = worldOf(inline)!;
    await own.ready;
    world.paused = own.paused = true;
    expect([world.stats.bodies, own.stats.bodies]).to.eql([1, 2]);
    inline.setAttribute('shared-world', 'w');
    world.step(0);
    expect(worldOf(inline)).to.equal(world);
    expect([world.stats.bodies, own.stats.bodies]).to.eql([3, 0]);
    inline.removeAttribute('shared-world');
    own.step(0);
    expect(worldOf(inline)).to.equal(own);
    expect([world.stats.bodies, own.stats.bodies]).to.eql([1, 2]);
  });
});

describe('what has nothing to collide with yet', () => {
  for (const [title, markup] of [
    [
      'a collidable without a Shape',
      '<x3d-rigid-body><x3d-collidable-shape id="at"></x3d-collidable-shape></x3d-rigid-body>',
    ],
    [
      'a Transform without a Shape',
      '<transform id="at"><x3d-rigid-body id="b"></x3d-rigid-body></transform>',
    ],
  ])
    for (const each of both(
      `<x3d-rigid-body-collection id="c">${markup}</x3d-rigid-body-collection>`,
    )) {
      it(`${title}, ${spelling(each)} tags: says so until it comes`, async () => {
        claim('waiting-for-geometry');
        const { x3d, world } = await show(each, '#c');
        world.paused = true;
        expect(world.problems.map(({ code, severity }) => [code, severity])).to.eql([
          ['waiting-for-geometry', 'info'],
        ]);
        x3d
          .querySelector('#at')!
          .insertAdjacentHTML('beforeend', '<shape><sphere></sphere></shape>');
        world.step(0);
        expect(world.problems).to.eql([]);
      });
    }

  it('one Shape of two without a geometry is told of, whichever it is', async () => {
    const shapes = ['<shape id="at"></shape>', '<shape><sphere></sphere></shape>'];
    for (const markup of [shapes.join(''), shapes.toReversed().join('')]) {
      claim('waiting-for-geometry');
      const { x3d, world } = await show(
        `<transform>${markup}<x3d-rigid-body id="b"></x3d-rigid-body></transform>`,
        '#b',
      );
      world.paused = true;
      expect(world.problems.map(({ code, used }) => [code, used])).to.eql([
        ['waiting-for-geometry', 'its other Shapes'],
      ]);
      x3d.querySelector('#at')!.insertAdjacentHTML('beforeend', '<box></box>');
      world.step(0);
      expect(world.problems).to.eql([]);
    }
  });

  it('a body without any collidable is legal', async () => {
    const { world } = await show(
      '<x3d-rigid-body-collection id="c"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>',
      '#c',
    );
    expect(world.problems).to.eql([]);
  });

  it('a collidable directly in a collection is misplaced, and works by USE all the same', async () => {
    claim('misplaced');
    const { x3d, world } = await show(
      `<x3d-rigid-body-collection id="c">
        <x3d-collidable-shape def="s"><shape><sphere></sphere></shape></x3d-collidable-shape>
        <x3d-rigid-body id="b"><x3d-collidable-shape use="s"></x3d-collidable-shape></x3d-rigid-body>
      </x3d-rigid-body-collection>`,
      '#c',
    );
    expect(codes(world)).to.eql(['misplaced']);
    expect((world.node('b')!.get('geometry') as unknown[]).length).to.equal(1);
    x3d.querySelector('scene')!.append(x3d.querySelector('[def=s]')!);
    world.step(0);
    expect(world.problems).to.eql([]);
  });
});

describe('reports', () => {
  it('make no world: the console and the page hear of what lives in none', async () => {
    claim('unknown-attribute');
    const x3d = place('<x3d-collidable-shape id="s" colour="red"></x3d-collidable-shape>');
    const heard: string[] = [];
    x3d.addEventListener('physicsproblem', (event) =>
      heard.push(`${(event.target as Element).id} ${(event as CustomEvent).detail.code}`),
    );
    let ready = 0;
    x3d.addEventListener('physicsready', () => ready++);
    await until(() => heard.length > 0);
    await wait(100);
    expect([heard, ready]).to.eql([['s unknown-attribute'], 0]);
  });

  it('of what stands outside any x3d show as a state, until it is put in', async () => {
    claim('misplaced');
    document.body.innerHTML = '<x3d-rigid-body></x3d-rigid-body>';
    const body = document.querySelector('x3d-rigid-body')!;
    await wait(20);
    expect(body.matches(':state(problem)')).to.equal(true);
    const { x3d } = await show('<x3d-rigid-body-collection></x3d-rigid-body-collection>');
    x3d.querySelector('x3d-rigid-body-collection')!.append(body);
    await wait(20);
    expect(body.matches(':state(problem)')).to.equal(false);
  });

  it('of the world itself fire at its collection', async () => {
    const { x3d, world } = await show(
      '<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>',
      '#c',
    );
    const heard: unknown[] = [];
    x3d.addEventListener('physicsproblem', (event) =>
      heard.push([(event.target as Element).id, (event as CustomEvent).detail.code]),
    );
    claim('[something]');
    world.report({ code: 'something', severity: 'info', message: 'said' });
    expect(heard).to.eql([['c', 'something']]);
  });
});
