import { expect } from 'chai';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { wait } from '../../scene.js';
import { held } from './held.js';

describe('problems of an element', () => {
  const BODY = `<transform><shape><box></box></shape><x3d-rigid-body id="b" mass="-3"></x3d-rigid-body></transform>`;

  for (const [spelling, markup] of bothSpellings(BODY)) {
    it(`${spelling}: stand while their cause does, whatever becomes of its geometry`, async () => {
      claim('mass="-3" is outside');
      const { world, find } = await held(markup);
      const codes = () => world.problems.map(({ code }) => code);
      expect(codes()).to.eql(['out-of-range']);
      const tag = spelling === 'plain' ? 'CollidableShape' : 'x3d-collidable-shape';
      find('#b').innerHTML = `<${tag}><shape><sphere></sphere></shape></${tag}>`;
      await wait(50);
      world.step();
      expect(codes()).to.eql(['out-of-range']);
      find('#b').replaceChildren();
      await wait(50);
      world.step();
      expect(codes()).to.eql(['out-of-range']);
      Element.prototype.setAttribute.call(find('#b'), 'mass', '3');
      world.step();
      expect(codes()).to.eql([]);
    });
  }

  for (const [spelling, markup] of bothSpellings(`
    <x3d-collidable-shape def="shape"><shape><box></box></shape></x3d-collidable-shape>
    <x3d-rigid-body-collection><x3d-collision-collection><x3d-collidable-shape use="shape"></x3d-collidable-shape></x3d-collision-collection>
      <x3d-rigid-body id="b"><geometry use="shape" containerfield="geometry"></geometry></x3d-rigid-body>
    </x3d-rigid-body-collection>`)) {
    it(`${spelling}: a USE whose tag is another than its DEF's is told, with the one to write`, async () => {
      claim('<geometry USE="shape"> in RigidBody');
      const { world, find } = await held(markup);
      const [problem] = world.problems.filter(({ code }) => code === 'misplaced');
      expect(problem!.message).to.match(
        /write <(x3d-collidable-shape|collidableshape) USE="shape">/,
      );
      find('#b').replaceChildren();
      await wait(50);
      world.step();
      expect(world.problems.map(({ code }) => code)).to.eql([]);
    });
  }

  it('without a name bring the element along to the console, with one they name it', async () => {
    const { info, warn, error } = console;
    const said: unknown[][] = [];
    Object.assign(console, { warn: (...parts: unknown[]) => void said.push(parts) });
    try {
      const { find } = await held(`<x3d-rigid-body-collection>
        <x3d-rigid-body mass="x" class="unnamed"></x3d-rigid-body><x3d-rigid-body def="named" mass="x"></x3d-rigid-body>
      </x3d-rigid-body-collection>`);
      expect(said.map(([, ...details]) => details)).to.eql([[find('.unnamed')], []]);
      expect(said[1]![0]).to.contain('RigidBody "named"');
    } finally {
      Object.assign(console, { info, warn, error });
    }
  });
});
