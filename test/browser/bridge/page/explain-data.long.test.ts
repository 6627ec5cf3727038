import { expect } from 'chai';
import { explain } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { held } from '../nodes/held.js';

describe('explain', () => {
  const ALL = `<x3d-rigid-body-collection def="world">
    <x3d-rigid-body id="a" position="0 0.5 0" mass="x"><x3d-collidable-shape def="shape"><shape><box size="1 1 1"></box></shape></x3d-collidable-shape></x3d-rigid-body>
    <x3d-rigid-body def="b" fixed position="0 -0.5 0"><x3d-collidable-shape><shape><box size="9 1 9"></box></shape></x3d-collidable-shape></x3d-rigid-body>
    <x3d-ball-joint body1="a" anchorPoint="0 3 0"></x3d-ball-joint>
    <x3d-collision-collection collidables="*"></x3d-collision-collection>
  </x3d-rigid-body-collection>`;

  for (const [spelling, markup] of bothSpellings(ALL)) {
    it(`${spelling}: is plain data of every node, with others by tag and name`, async () => {
      claim('mass="x" is');
      const { world, x3d, find } = await held(markup);
      (world.node('a') as unknown as { set(name: string, value: unknown): void }).set('forces', {
        a: 1,
      });
      claim('forces="{ a: 1 }" is');
      world.advance(0.3);
      for (const element of x3d.querySelectorAll('*')) {
        const told = explain(element);
        const text = JSON.stringify(told);
        expect(JSON.stringify(structuredClone(told))).to.equal(text);
        expect(JSON.parse(text)).to.have.all.keys(Object.keys(told));
        expect(text).not.to.contain('[object');
      }
      const { element, touches, bullet, problems } = explain(find('#a'));
      const tag = (name: string): string =>
        spelling === 'plain' ? name.replaceAll(/x3d|-/g, '') : name;
      expect(element).to.equal(`${tag('x3d-rigid-body')}[id="a"]`);
      expect(x3d.querySelector(touches![0]!)).to.equal(find(`${tag('x3d-rigid-body')}[def=b]`));
      expect(bullet!.joints).to.eql([tag('x3d-ball-joint')]);
      expect(problems.map(({ element: of, code }) => [of, code])).to.eql([
        [element, 'bad-value'],
        [element, 'bad-value'],
      ]);
    });
  }
});
