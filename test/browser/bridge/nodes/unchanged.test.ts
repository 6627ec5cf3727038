import { expect } from 'chai';
import { X3DRigidBodyElement } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { held } from './held.js';

const BALL = `<x3d-rigid-body-collection><x3d-rigid-body id="ball" position="0 5 0" angularVelocity="0 0 1">
  <x3d-collidable-shape><shape><sphere radius="0.5"></sphere></shape></x3d-collidable-shape>
</x3d-rigid-body></x3d-rigid-body-collection>`;

describe('a value equal to the one last asked for', () => {
  for (const [spelling, markup] of bothSpellings(BALL)) {
    it(`${spelling}: an attribute is no edit, and that is told once where the body has moved on`, async () => {
      claim('unchanged-value');
      const { world, find, at } = await held(markup);
      const ball = find('#ball');
      const write = (text: string): void => {
        Element.prototype.setAttribute.call(ball, 'position', text);
        world.step(0);
      };
      world.reset();
      write('0 5 0');
      expect(world.problems).to.eql([]);
      world.advance(0.5);
      const fallen = at();
      for (const text of ['0 5 0', '0, 5, 0', '0 5 0', '0 5.0 0']) write(text);
      expect(at()).to.eql(fallen);
      const [problem, ...others] = world.problems;
      expect([others.length, problem!.code, problem!.severity]).to.eql([
        0,
        'unchanged-value',
        'info',
      ]);
      expect([problem!.element, problem!.attribute]).to.eql([ball, 'position']);
      expect(problem!.message).to.contain('teleport() moves it');
      Element.prototype.setAttribute.call(ball, 'angularVelocity', '0 0 1');
      Element.prototype.setAttribute.call(ball, 'mass', '1');
      world.step(0);
      expect(world.problems.length).to.equal(1);
      write('0 6 0');
      expect(at()).to.eql([0, 6, 0]);
      expect(world.problems).to.eql([]);
    });
  }

  it('a property that is rendered a thousand times is told once; teleport moves, velocities included', async () => {
    claim('unchanged-value');
    const { world, find, at } = await held(BALL);
    const ball = find('#ball') as X3DRigidBodyElement & { position: number[] };
    for (let i = 0; i < 1000; i++) {
      ball.position = [0, 5, 0];
      if (i % 100 === 0) world.step();
    }
    expect(at()[1]).to.be.below(5);
    expect(world.problems.map(({ code }) => code)).to.eql(['unchanged-value']);
    ball.teleport([1, 5, 0], [0, 1, 0, 0], {
      linearVelocity: [2, 0, 0],
      angularVelocity: [0, 0, 0],
    });
    world.advance(0.5);
    expect(at()[0]).to.be.closeTo(2, 1e-3);
    ball.teleport([0, 0, 0]);
    world.step();
    expect(at()[0]).to.be.closeTo(2 * world.timeStep, 1e-4);
  });
});
