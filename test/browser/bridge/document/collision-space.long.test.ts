import { expect } from 'chai';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { held } from '../nodes/held.js';

const SPACE = `<x3d-rigid-body-collection id="c">
  <x3d-collision-collection><x3d-collision-space id="space" collidables="*"></x3d-collision-space></x3d-collision-collection>
  <x3d-rigid-body fixed position="0 -0.5 0"><x3d-collidable-shape><shape><box size="9 1 9"></box></shape></x3d-collidable-shape></x3d-rigid-body>
  <x3d-rigid-body id="ball" position="0 0.5 0"><x3d-collidable-shape><shape><sphere radius="0.5"></sphere></shape></x3d-collidable-shape></x3d-rigid-body>
</x3d-rigid-body-collection>`;

describe('a CollisionSpace of *', () => {
  for (const [spelling, markup] of bothSpellings(SPACE)) {
    it(`${spelling}: holds every collidable of its world, and none when it is disabled`, async () => {
      claim('not-in-collider', 'not-in-collider');
      const { world, find, at } = await held(markup);
      world.reset();
      world.advance(0.5);
      expect(at()[1]).to.be.closeTo(0.5, 0.01);
      expect(world.problems).to.eql([]);
      Element.prototype.setAttribute.call(find('#space'), 'enabled', 'false');
      world.advance(0.5);
      expect(at()[1]).to.be.below(0);
    });

    it(`${spelling}: has as obstacle a collidable without a body`, async () => {
      const obstacle = `<x3d-collidable-shape translation="5 -0.5 0"><shape><box size="1 1 1"></box></shape></x3d-collidable-shape>`;
      const free =
        spelling === 'plain'
          ? obstacle.replaceAll('x3d-collidable-shape', 'CollidableShape')
          : obstacle;
      const { world, at } = await held(
        markup.replace('0 0.5 0', '5 0.5 0').replace(/fixed position="0 /, 'fixed position="-20 ') +
          free,
      );
      world.reset();
      world.advance(0.5);
      expect(at()[1]).to.be.closeTo(0.5, 0.01);
    });
  }
});

describe('collidables that names an element', () => {
  for (const [spelling, markup] of bothSpellings(SPACE)) {
    it(`${spelling}: is told of, and the children are listed`, async () => {
      claim('not-in-collider', 'not-in-collider', 'collidables="floor" is not "*"; its children');
      const { find, world } = await held(markup);
      Element.prototype.setAttribute.call(find('#space'), 'collidables', 'floor');
      world.advance(0.1);
      const [problem] = world.problems.filter(({ code }) => code === 'bad-value');
      expect(problem).to.include({
        attribute: 'collidables',
        value: 'floor',
        used: 'its children',
      });
      Element.prototype.setAttribute.call(find('#space'), 'collidables', '*');
      world.advance(0.1);
      expect(world.problems).to.eql([]);
    });
  }
});
