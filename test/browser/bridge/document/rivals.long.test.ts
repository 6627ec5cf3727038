import { expect } from 'chai';
import { explain } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { drawn, drawnAt, show } from '../../scene.js';

// Two bodies in one place would push each other apart.

const sphere = '<shape><sphere radius="0.5"></sphere></shape>';

/** Of two bodies that stand for the Transform `t`, the first has x = 1 m/s, the second x = -1 m/s. */
const FORMS: Record<string, string> = {
  'inside the same Transform': `
    <transform id="t" translation="0 3 0">${sphere}
      <x3d-rigid-body id="a" linearvelocity="1 0 0"></x3d-rigid-body>
      <group><x3d-rigid-body id="b" linearvelocity="-1 0 0"></x3d-rigid-body></group>
    </transform>`,
  'by for, and inside': `
    <x3d-rigid-body id="a" for="t" linearvelocity="1 0 0"></x3d-rigid-body>
    <transform id="t" translation="0 3 0">${sphere}
      <x3d-rigid-body id="b" linearvelocity="-1 0 0"></x3d-rigid-body></transform>`,
  'by for, both': `
    <transform id="t" translation="0 3 0">${sphere}</transform>
    <x3d-rigid-body id="a" for="t" linearvelocity="1 0 0"></x3d-rigid-body>
    <x3d-rigid-body id="b" for="t" linearvelocity="-1 0 0"></x3d-rigid-body>`,
  'by for, of Shapes in one Transform': `
    <transform id="t" translation="0 3 0"><shape id="s1"><sphere radius="0.5"></sphere></shape>
      <shape id="s2"><box></box></shape></transform>
    <x3d-rigid-body id="a" for="s1" linearvelocity="1 0 0"></x3d-rigid-body>
    <x3d-rigid-body id="b" for="s2" linearvelocity="-1 0 0"></x3d-rigid-body>`,
  'one by the Transform that stands for it': `
    <transform id="t" def="T" translation="0 3 0">${sphere}
      <x3d-rigid-body id="a" linearvelocity="1 0 0"></x3d-rigid-body></transform>
    <group><transform use="T" id="u"></transform></group>
    <x3d-rigid-body id="b" for="u" linearvelocity="-1 0 0"></x3d-rigid-body>`,
  'one by a collidable with for': `
    <transform id="t" translation="0 3 0">${sphere}
      <x3d-rigid-body id="a" linearvelocity="1 0 0"></x3d-rigid-body></transform>
    <x3d-rigid-body id="b" linearvelocity="-1 0 0"><x3d-collidable-shape for="t"></x3d-collidable-shape></x3d-rigid-body>`,
  'both by the older dialect': `
    <x3d-rigid-body id="a" linearvelocity="1 0 0"><x3d-collidable-shape>${sphere}<transform use="T" containerfield="transform"></transform></x3d-collidable-shape></x3d-rigid-body>
    <x3d-rigid-body id="b" linearvelocity="-1 0 0"><x3d-collidable-shape>${sphere}<transform use="T" containerfield="transform"></transform></x3d-collidable-shape></x3d-rigid-body>
    <transform id="t" def="T" translation="0 3 0">${sphere}</transform>`,
};

const collection = (inner: string): string =>
  `<x3d-rigid-body-collection id="c" default gravity="0 0 0"></x3d-rigid-body-collection>${inner}`;

const x = (element: Element): number => drawnAt(element)[0]!;

describe('two bodies that stand for one Transform', () => {
  for (const [form, markup] of Object.entries(FORMS))
    for (const [spelling, each] of bothSpellings(collection(markup)))
      it(`${form}, ${spelling} tags: the first moves it, the second waits, says so, and takes over`, async () => {
        claim('RigidBody "a" moves it, RigidBody "b" waits until that has gone [already-owned]');
        const { x3d, world } = await show(each, '#c');
        const [t, a, b] = ['#t', '#a', '#b'].map((name) => x3d.querySelector(name)!);
        world.paused = true;
        world.reset();
        expect(world.stats.bodies).to.equal(1);
        expect(world.problems.map(({ code, element }) => [code, element])).to.eql([
          ['already-owned', b],
        ]);
        expect(explain(b!)).to.deep.include({ running: false, waits: ['RigidBody "a" to go'] });
        world.advance(1);
        await drawn();
        expect(x(t!)).to.be.closeTo(1, 1e-3);
        a!.remove();
        world.step(0);
        expect([world.stats.bodies, world.problems.length]).to.eql([1, 0]);
        expect(explain(b!)).to.deep.include({
          running: true,
          waits: ['the world, which is paused'],
        });
        world.advance(0.5);
        await drawn();
        expect(x(t!)).to.be.closeTo(0.5, 1e-3);
      });

  it('a duplicate, as somebody makes it in devtools, does nothing to the first', async () => {
    const { x3d, world } = await show(
      collection(FORMS['inside the same Transform']!),
      '#c',
    ).finally(() => claim('already-owned'));
    x3d.querySelector('#b')!.remove();
    world.paused = true;
    world.reset();
    world.advance(1);
    const a = x3d.querySelector('#a')!;
    const before = world.node('a')!.get('position');
    claim('two bodies stand for <transform> "t": RigidBody "a" moves it, RigidBody "a" waits');
    const copy = a.cloneNode(true) as Element;
    a.after(copy);
    world.step(0);
    expect(world.stats.bodies).to.equal(1);
    expect(world.problems.map(({ element }) => element)).to.eql([copy]);
    expect(world.node(a)!.get('position')).to.eql(before);
    copy.remove();
    world.step(0);
    expect(world.problems).to.eql([]);
  });

  it('change places with their elements: the first in the document moves it', async () => {
    claim('RigidBody "b" waits', 'RigidBody "a" waits');
    const { x3d, world } = await show(collection(FORMS['by for, both']!), '#c');
    world.paused = true;
    const [a, b] = ['#a', '#b'].map((name) => x3d.querySelector(name)!);
    a!.before(b!);
    world.step(0);
    expect([world.node(a), world.node(b)].map((node) => !!node)).to.eql([false, true]);
    expect(world.problems.map(({ element }) => element)).to.eql([a]);
  });

  it('a body around another takes the Shapes under that when it goes, and gives them back', async () => {
    const { x3d, world } = await show(
      collection(`<transform id="outer"><x3d-rigid-body id="a" mass="1"></x3d-rigid-body>${sphere}
        <transform id="inner" translation="3 0 0">${sphere}<x3d-rigid-body id="b"></x3d-rigid-body></transform>
      </transform>`),
      '#c',
    );
    world.paused = true;
    const parts = (): number => {
      const [shape] = world.node('a')!.get('geometry') as { get(name: string): unknown[] }[];
      return shape!.get('shape').length;
    };
    const b = x3d.querySelector('#b')!;
    expect(parts()).to.equal(1);
    b.remove();
    world.step(0);
    expect(parts()).to.equal(2);
    x3d.querySelector('#inner')!.append(b);
    world.step(0);
    expect(parts()).to.equal(1);
  });

  it('collidables of one body may stand for one Transform', async () => {
    const { x3d, world } = await show(
      collection(`<transform id="t" translation="0 3 0">${sphere}
        <x3d-rigid-body id="a" linearvelocity="1 0 0"><x3d-collidable-shape for="t"></x3d-collidable-shape></x3d-rigid-body></transform>`),
      '#c',
    );
    world.paused = true;
    world.reset();
    world.advance(1);
    await drawn();
    expect(x(x3d.querySelector('#t')!)).to.be.closeTo(1, 1e-3);
  });
});
