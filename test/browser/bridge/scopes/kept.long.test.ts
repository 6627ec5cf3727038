import { expect } from 'chai';
import { claim } from '../../console.js';
import { codes, drawn, drawnAt, position, show, until } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { bothSpellings } from '../../forms.js';

const kept = (content: string): string =>
  `<WorldInfo title="t"><MetadataSet name="m" reference="r">${content}</MetadataSet></WorldInfo>`;

/** A ball that falls onto a floor whose upper side is at 0.1 m. */
const COLLECTION = `
  <x3d-rigid-body-collection def="c" containerfield="value">
    <x3d-rigid-body def="ball" position="0 1 0"><x3d-collidable-shape def="ballshape" containerfield="geometry"><shape containerfield="shape"><sphere radius="0.3"></sphere></shape></x3d-collidable-shape></x3d-rigid-body>
    <x3d-rigid-body def="ground" fixed="true"><x3d-collidable-shape def="groundshape" containerfield="geometry"><shape containerfield="shape"><box size="8 0.2 8"></box></shape></x3d-collidable-shape></x3d-rigid-body>
  </x3d-rigid-body-collection>`;

describe('a node that is only kept', () => {
  for (const [spelling, markup] of bothSpellings(COLLECTION)) {
    it(`${spelling} tags: does not run in metadata, and runs whole while it is USEd`, async () => {
      const { x3d, world } = await show(
        `${kept(markup)}<x3d-rigid-body id="other"></x3d-rigid-body><x3d-collidable-shape use="ballshape"></x3d-collidable-shape>`,
        '#other',
      );
      expect(world.stats.bodies).to.equal(1);
      claim('unused-collidable');
      const scene = x3d.querySelector('scene')!;
      await until(() => world.problems.length > 0);
      expect(codes(world)).to.eql(['unused-collidable']);

      scene.insertAdjacentHTML(
        'beforeend',
        '<x3d-rigid-body-collection use="c" id="use"></x3d-rigid-body-collection>',
      );
      const collection = x3d.querySelector('[def=c]')!;
      const own = worldOf(collection)!;
      await own.ready;
      own.paused = true;
      own.advance(3);
      expect(own.stats.bodies).to.equal(2);
      expect(world.problems).to.eql([]);
      expect(position(own, 'ball')[1]).to.be.closeTo(0.4, 0.01);
      await drawn();
      expect(drawnAt(x3d.querySelector('[use=ballshape]')!)[1]).to.be.closeTo(0.4, 0.01);

      claim('unused-collidable');
      x3d.querySelector('#use')!.remove();
      await until(() => codes(world).length > 0);
      expect(own.stats.bodies).to.equal(0);
    });
  }
});

describe('a USE before its DEF', () => {
  it('that come together into a running scene are drawn, both', async () => {
    const { x3d, world } = await show('<x3d-rigid-body id="other"></x3d-rigid-body>', '#other');
    x3d.querySelector('scene')!.insertAdjacentHTML(
      'beforeend',
      `<transform id="first" translation="1 0 0"><shape use="s"></shape></transform>
       <transform id="second" translation="2 0 0"><shape def="s"><box></box></shape></transform>`,
    );
    await until(() => parentsOf(x3d, '[def=s]') === 2);
    expect(world.problems).to.eql([]);
  });
});

/** In how many places x3dom draws it. */
const parentsOf = (x3d: Element, selector: string): number =>
  (x3d.querySelector(selector) as unknown as { _x3domNode?: { _parentNodes: unknown[] } })
    ._x3domNode?._parentNodes.length ?? 0;

describe('a circle of USE', () => {
  const CRATE =
    '<transform translation="0 3 0"><shape><box></box></shape><x3d-rigid-body id="b"></x3d-rigid-body></transform>';
  const CIRCLES: Record<string, string> = {
    'a Group in itself': '<group def="g"><group use="g"></group></group>',
    'two Groups in each other':
      '<group def="g"><group use="h"></group></group><group def="h"><group use="g"></group></group>',
    'a Transform in itself that a body moves':
      '<transform def="g"><shape><box></box></shape><transform use="g"></transform><x3d-rigid-body></x3d-rigid-body></transform>',
    'an offset in itself':
      '<x3d-rigid-body><x3d-collidable-offset def="g"><x3d-collidable-offset use="g"></x3d-collidable-offset></x3d-collidable-offset></x3d-rigid-body>',
    'two offsets in each other':
      '<x3d-rigid-body><x3d-collidable-offset def="g"><x3d-collidable-offset use="h"></x3d-collidable-offset></x3d-collidable-offset></x3d-rigid-body><x3d-collidable-offset def="h"><x3d-collidable-offset use="g"></x3d-collidable-offset></x3d-collidable-offset>',
    'a space in itself':
      '<x3d-collision-collection><x3d-collision-space def="g"><x3d-collision-space use="g"></x3d-collision-space></x3d-collision-space></x3d-collision-collection>',
  };
  for (const [what, markup] of Object.entries(CIRCLES)) {
    it(`${what}: is told once, and the rest runs`, async () => {
      claim('use-circle');
      const { world } = await show(markup + CRATE, '#b');
      world.paused = true;
      world.reset();
      world.advance(1);
      expect(position(world, 'b')[1]).to.be.closeTo(3 - 4.9, 0.05);
      await drawn();
      expect(codes(world)).to.eql(['use-circle']);
    });
  }

  it('that an edit closes is told once, and the rest runs', async () => {
    const { x3d, world } = await show(
      `<group def="g"><group id="in"></group></group>${CRATE}`,
      '#b',
    );
    claim('use-circle');
    x3d.querySelector('#in')!.innerHTML = '<group use="g"></group>';
    await until(() => codes(world).length > 0);
    await drawn();
    expect(codes(world)).to.eql(['use-circle']);
  });

  it('two nodes of one DEF are told once: the later one is meant, and both run', async () => {
    claim('duplicate-def');
    const { world } = await show(
      `<x3d-rigid-body-collection id="c"><x3d-rigid-body def="a" position="0 1 0"></x3d-rigid-body><x3d-rigid-body def="a" position="0 2 0"></x3d-rigid-body>
        <x3d-ball-joint body1="a" anchorpoint="0 2 0"></x3d-ball-joint></x3d-rigid-body-collection>`,
    );
    world.paused = true;
    expect(codes(world)).to.eql(['duplicate-def']);
    expect(world.stats).to.include({ bodies: 2, joints: 1 });
  });
});
