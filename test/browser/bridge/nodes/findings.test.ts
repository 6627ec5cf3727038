import { expect } from 'chai';
import { claim } from '../../console.js';
import { show, codes } from '../../scene.js';
import { bothSpellings } from '../../forms.js';

describe('what has nothing to collide with yet', () => {
  for (const [title, markup] of [
    [
      'a collidable without a Shape',
      '<x3d-rigid-body-collection><x3d-rigid-body id="b"><x3d-collidable-shape id="at"></x3d-collidable-shape></x3d-rigid-body></x3d-rigid-body-collection>',
    ],
    [
      'a Transform without a Shape',
      '<transform id="at"><x3d-rigid-body id="b"></x3d-rigid-body></transform>',
    ],
  ])
    for (const [spelling, each] of bothSpellings(markup)) {
      it(`${title}, ${spelling} tags: says so until it comes`, async () => {
        claim('waiting-for-geometry');
        const { x3d, world } = await show(each, '#b');
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
