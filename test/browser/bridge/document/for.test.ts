import { expect } from 'chai';
import { bothSpellings } from '../../forms.js';
import { drawn, drawnAt, show, position } from '../../scene.js';

describe('for on a collidable', () => {
  for (const [spelling, markup] of bothSpellings(`
    <transform id="t" translation="1 2 3"><shape><sphere radius="0.5"></sphere></shape></transform>
    <transform id="u" translation="9 8 7"><shape><box></box></shape></transform>
    <x3d-rigid-body-collection id="c"><x3d-rigid-body id="b">
      <x3d-collidable-shape id="s" for="t"></x3d-collidable-shape></x3d-rigid-body></x3d-rigid-body-collection>`))
    it(`${spelling} tags: changed at run time moves its body to the new Transform`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      world.reset();
      expect(position(world, 'b')).to.eql([1, 2, 3]);
      x3d.querySelector('#s')!.setAttribute('for', 'u');
      world.step(0);
      expect(position(world, 'b')).to.eql([9, 8, 7]);
      const [shape] = world.node('b')!.get('geometry') as {
        get(name: string): { type: string }[];
      }[];
      expect(shape!.get('shape')[0]!.type).to.equal('Box');
      world.advance(0.5);
      await drawn();
      expect(drawnAt(x3d.querySelector('#u')!)[1]).to.be.closeTo(position(world, 'b')[1]!, 0.05);
      expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.closeTo(2, 1e-5);
    });
});
