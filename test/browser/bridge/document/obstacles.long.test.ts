import { expect } from 'chai';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { drawn, drawnAt, place, show, position, until, wait } from '../../scene.js';
import { explain } from '../../../../elements/index.js';
import { worldOf } from '../../inside.js';

const ball = (at: string): string => `
  <x3d-rigid-body id="ball" position="${at}">
    <x3d-collidable-shape id="ballshape"><shape><sphere radius="0.5"></sphere></shape></x3d-collidable-shape>
  </x3d-rigid-body>`;

/** A table that no body holds, 1 m thick, its upper side at the Transforms' height + 0.5 m. */
const table = `
  <transform id="outer" translation="0 1 0"><transform id="t" translation="3 0 0">
    <x3d-collidable-shape def="table" id="table"><shape><box size="4 1 4"></box></shape></x3d-collidable-shape>
  </transform></transform>`;

describe('a collidable without a body', () => {
  for (const [spelling, markup] of bothSpellings(`${table}
    <x3d-rigid-body-collection id="c">${ball('3 3 0')}</x3d-rigid-body-collection>
    <x3d-collision-collection id="k">
      <x3d-collidable-shape use="table"></x3d-collidable-shape><x3d-collidable-shape use="ballshape"></x3d-collidable-shape>
    </x3d-collision-collection>`)) {
    it(`${spelling} tags: stands where it is drawn, and others rest on it`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      world.reset();
      world.advance(3);
      expect(position(world, 'ball')[1]).to.be.closeTo(2, 0.01);
      expect(world.stats.bodies).to.equal(1);
      await drawn();
      const at = drawnAt(x3d.querySelector('#table')!);
      expect([at[0], at[1]]).to.eql([3, 1]);
    });

    it(`${spelling} tags: follows edits of its own place and of every Transform above`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      const at = (): number[] => world.node('table')!.get('translation') as number[];
      const set = (selector: string, name: string, value: string): void => {
        x3d.querySelector(selector)!.setAttribute(name, value);
        // x3dom hears of it in a microtask.
      };
      world.step(0);
      expect(at()).to.eql([3, 1, 0]);
      set('#outer', 'translation', '0 2 0');
      await drawn();
      expect(at()).to.eql([3, 2, 0]);
      set('#t', 'translation', '5 0 0');
      await drawn();
      expect(at()).to.eql([5, 2, 0]);
      set('#table', 'translation', '1 0 0');
      await drawn();
      expect(at()).to.eql([6, 2, 0]);
      expect(drawnAt(x3d.querySelector('#table')!).slice(0, 2)).to.eql([6, 2]);
      x3d.querySelector('#table')!.removeAttribute('translation');
      await drawn();
      expect(at()).to.eql([5, 2, 0]);
      (
        x3d.querySelector('#table') as unknown as { setFieldValue(n: string, v: string): void }
      ).setFieldValue('translation', '0 0 7');
      await drawn();
      expect(at()).to.eql([5, 2, 7]);
      expect(
        (
          x3d.querySelector('#table') as unknown as { getFieldValue(n: string): { z: number } }
        ).getFieldValue('translation').z,
      ).to.equal(7);
    });

    it(`${spelling} tags: makes way when it goes, and comes back`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      world.reset();
      world.advance(3);
      const listed = x3d.querySelector('[use=table], [USE=table]')!;
      const list = listed.parentElement!;
      listed.remove();
      world.advance(0.5);
      expect(position(world, 'ball')[1]).to.be.below(1.5);
      x3d.querySelector('#ball')!.setAttribute('position', '3 4 0');
      list.append(listed);
      world.advance(3);
      expect(position(world, 'ball')[1]).to.be.closeTo(2, 0.01);
    });
  }

  for (const [spelling, markup] of bothSpellings(`${table}
    <x3d-rigid-body-collection id="c">${ball('3 3 0')}
      <x3d-collision-collection id="k" collidables="*"></x3d-collision-collection>
    </x3d-rigid-body-collection>`))
    it(`${spelling} tags: is among all that a list names by *, as long as it does`, async () => {
      claim('not-in-collider', 'unused-collidable');
      const { x3d, world } = await show(markup, '#c');
      const list = x3d.querySelector('#k')!;
      world.paused = true;
      world.reset();
      world.advance(2);
      expect(position(world, 'ball')[1]).to.be.closeTo(2, 0.01);
      expect(worldOf(x3d.querySelector('#table'))).to.equal(world);
      list.removeAttribute('collidables');
      world.advance(0.5);
      expect(world.node('table')).to.equal(undefined);
      expect(position(world, 'ball')[1]).to.be.below(1.5);
      x3d.querySelector('#ball')!.setAttribute('position', '3 4 0');
      list.setAttribute('collidables', '*');
      world.advance(2);
      expect(position(world, 'ball')[1]).to.be.closeTo(2, 0.01);
      list.remove();
      world.advance(0.5);
      expect(position(world, 'ball')[1]).to.be.below(1.5);
      await wait(30);
    });

  it('in a Transform that a body moves says that it stays', async () => {
    claim('does not move with it');
    const { world } = await show(
      `<x3d-rigid-body-collection id="c"><x3d-collision-collection collidables="*"></x3d-collision-collection>
        </x3d-rigid-body-collection>
      <x3d-rigid-body-collection default></x3d-rigid-body-collection>
      <transform><shape><box></box></shape><x3d-rigid-body id="b"></x3d-rigid-body>
        <x3d-collidable-shape id="s"><shape><box></box></shape></x3d-collidable-shape></transform>`,
      '#c',
    );
    const [problem] = world.problems;
    expect([problem!.code, (problem!.element as Element).id]).to.eql(['misplaced', 's']);
  });

  it('belongs to the world whose list of all stands in its own scope', async () => {
    const world = (id: string, list: string): string =>
      `<x3d-rigid-body-collection id="${id}">${list}</x3d-rigid-body-collection>`;
    const all = '<x3d-collision-collection collidables="*"></x3d-collision-collection>';
    const { x3d } = await show(table + world('a', '') + world('b', all) + world('d', all), '#b');
    expect(worldOf(x3d.querySelector('#table'))).to.equal(worldOf(x3d.querySelector('#b')));
  });

  for (const [spelling, markup] of bothSpellings(`
    <transform id="scaled" translation="0 1 0" scale="2 0.5 1">
      <x3d-collidable-offset def="shelf" id="shelf" translation="1 0 0">
        <x3d-collidable-shape def="board" id="board" translation="1 2 0"><shape><box size="2 1 4"></box></shape></x3d-collidable-shape>
      </x3d-collidable-offset>
    </transform>
    <x3d-rigid-body-collection id="c">${ball('4 4 0')}</x3d-rigid-body-collection>
    <x3d-collision-collection id="k" collidables="*"></x3d-collision-collection>`))
    it(`${spelling} tags: in an offset has the scale above that, in its place and its size`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      world.reset();
      await drawn();
      // Drawn at 2·(1 + 1), 1 + 0.5·2: its upper side is 0.25 m above its middle.
      expect(drawnAt(x3d.querySelector('#board')!).slice(0, 2)).to.eql([4, 2]);
      world.advance(2);
      expect(position(world, 'ball')[1]).to.be.closeTo(2.75, 0.01);
      const top = (x: number) => world.raycast([x, 5, 0], [x, 0, 0]);
      expect(top(5.9)?.element).to.equal(x3d.querySelector('#shelf'));
      expect(top(6.1)).to.equal(null);
      x3d.querySelector('#scaled')!.setAttribute('scale', '1 1 1');
      await drawn();
      world.step(1);
      expect(top(2.9)?.position[1]).to.be.closeTo(3.5, 1e-5);
      expect(top(3.1)).to.equal(null);
    });

  it('listed nowhere takes part in nothing, and says so', async () => {
    claim('unused-collidable');
    const { world } = await show(
      `${table}<x3d-rigid-body-collection id="c">${ball('3 3 0')}</x3d-rigid-body-collection>`,
      '#c',
    );
    world.paused = true;
    world.advance(2);
    expect(position(world, 'ball')[1]).to.be.below(0);
    await until(() => world.problems.length > 0);
    const [problem] = world.problems;
    expect([problem!.code, (problem!.element as Element).id]).to.eql([
      'unused-collidable',
      'table',
    ]);
    const told = explain(problem!.element as Element).problems;
    expect(told.map(({ code }) => code)).to.eql(['unused-collidable']);
    expect(problem!.message).to.equal(
      'CollidableShape "table" is in no RigidBody and no CollisionCollection, and collides with nothing',
    );
  });

  for (const [what, use] of [
    [
      'a body',
      `<x3d-rigid-body id="user" fixed="true"><x3d-collidable-shape use="table"></x3d-collidable-shape></x3d-rigid-body>`,
    ],
    [
      'a list',
      `<x3d-collision-collection id="user"><x3d-collidable-shape use="table"></x3d-collidable-shape></x3d-collision-collection>`,
    ],
    [
      'a list of all',
      `<x3d-collision-collection id="user" collidables="*"></x3d-collision-collection>`,
    ],
    [
      'a space of a list',
      `<x3d-collision-collection id="user"><x3d-collision-space><x3d-collidable-shape use="table"></x3d-collidable-shape></x3d-collision-space></x3d-collision-collection>`,
    ],
    [
      'an offset of a body',
      `<x3d-rigid-body id="user" fixed="true"><x3d-collidable-offset><x3d-collidable-shape use="table"></x3d-collidable-shape></x3d-collidable-offset></x3d-rigid-body>`,
    ],
  ] as const)
    it(`is used as soon as ${what} has it, wherever that stands, and unused without`, async () => {
      const bodies = ball('3 3 0') + (use.includes('rigid-body') ? use : '');
      const lists = use.includes('rigid-body') ? '' : use;
      const { x3d, world } = await show(
        `${table}<x3d-rigid-body-collection id="c">${bodies}</x3d-rigid-body-collection>${lists}`,
        '#c',
      );
      world.paused = true;
      await wait(30);
      expect(world.problems).to.eql([]);
      const user = x3d.querySelector('#user')!;
      const parent = user.parentElement!;
      user.remove();
      claim('unused-collidable');
      await until(() => world.problems.length > 0);
      expect(world.problems.map(({ code }) => code)).to.eql(['unused-collidable']);
      parent.append(user);
      world.step(0);
      expect(world.problems).to.eql([]);
    });

  it('in an offset or in a space by itself is told of once', async () => {
    claim(
      'CollidableOffset "o" is in no RigidBody',
      'CollisionSpace "s" is in no CollisionCollection',
    );
    const { world } = await show(
      `<x3d-collidable-offset id="o"><x3d-collidable-shape><shape><box></box></shape></x3d-collidable-shape></x3d-collidable-offset>
      <x3d-collision-space id="s"><x3d-collidable-shape><shape><box></box></shape></x3d-collidable-shape></x3d-collision-space>
      <MetadataSet><x3d-collidable-shape></x3d-collidable-shape></MetadataSet>
      <x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>`,
      '#c',
    );
    world.paused = true;
    await until(() => world.problems.length > 1);
    await wait(30);
    expect(world.problems.length).to.equal(2);
  });

  it('that a body takes later in the same task is not told of', async () => {
    const { x3d, world } = await show(
      '<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>',
      '#c',
    );
    world.paused = true;
    const scene = x3d.querySelector('scene')!;
    scene.insertAdjacentHTML(
      'beforeend',
      '<x3d-collidable-shape id="late"><shape><box></box></shape></x3d-collidable-shape>',
    );
    const body = document.createElement('x3d-rigid-body');
    body.geometry = [x3d.querySelector('#late')!];
    // As by a framework that renders in turns.
    await Promise.resolve();
    world.step(0);
    x3d.querySelector('#c')!.append(body);
    await wait(30);
    expect(world.problems).to.eql([]);
  });
});

describe('CollisionSpace', () => {
  for (const [spelling, markup] of bothSpellings(`${table}
    <x3d-rigid-body-collection id="c">${ball('3 3 0')}
      <x3d-collision-collection id="k" containerfield="collider">
        <x3d-collision-space id="outerspace">
          <x3d-collision-space id="space"><x3d-collidable-shape use="table"></x3d-collidable-shape></x3d-collision-space>
          <x3d-collidable-shape use="ballshape"></x3d-collidable-shape>
        </x3d-collision-space>
      </x3d-collision-collection>
    </x3d-rigid-body-collection>`)) {
    it(`${spelling} tags: is a node of its own, and what is in it collides while it is enabled`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      world.reset();
      expect(world.node('space')!.type.name).to.equal('CollisionSpace');
      expect(worldOf(x3d.querySelector('#space'))).to.equal(world);
      world.advance(2);
      expect(position(world, 'ball')[1]).to.be.closeTo(2, 0.01);
      x3d.querySelector('#space')!.setAttribute('enabled', 'false');
      world.advance(0.5);
      expect(position(world, 'ball')[1]).to.be.below(1.5);
      x3d.querySelector('#space')!.removeAttribute('enabled');
      x3d.querySelector('#ball')!.setAttribute('position', '3 4 0');
      world.advance(2);
      expect(position(world, 'ball')[1]).to.be.closeTo(2, 0.01);
    });

    it(`${spelling} tags: spaces and members come and go`, async () => {
      claim('waiting-for-geometry');
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      const space = x3d.querySelector('#space')!;
      const members = (): string[] =>
        (world.step(0), world.node('space')!.get('collidables') as { name: string }[]).map(
          ({ name }) => name,
        );
      expect(members()).to.eql(['table']);
      const other = document.createElement(
        spelling === 'custom' ? 'x3d-collidable-shape' : 'CollidableShape',
      );
      other.id = 'late';
      space.append(other);
      expect(members()).to.eql(['table', 'late']);
      other.remove();
      expect(members()).to.eql(['table']);
      const list = space.parentElement!;
      space.remove();
      world.step(0);
      expect(world.node('space')).to.equal(undefined);
      expect((world.node('outerspace')!.get('collidables') as unknown[]).length).to.equal(1);
      list.append(space);
      expect(members()).to.eql(['table']);
      expect((world.node('outerspace')!.get('collidables') as unknown[]).length).to.equal(2);
    });
  }

  it('may list itself in a circle, and is told', async () => {
    claim('use-circle');
    const x3d = place(`
      <x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>
      <x3d-collision-collection><x3d-collision-space def="a"><x3d-collision-space def="b">
        <x3d-collision-space use="a"></x3d-collision-space></x3d-collision-space></x3d-collision-space></x3d-collision-collection>`);
    const world = worldOf(x3d.querySelector('#c'))!;
    await world.ready;
    world.step(1);
    expect(world.node('b')).not.to.equal(undefined);
  });
});
