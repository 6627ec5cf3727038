import { expect } from 'chai';
import { explain, X3DRigidBodyElement } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { show, wait } from '../../scene.js';

const BALL = `<x3d-rigid-body-collection><x3d-rigid-body id="ball" position="0 5 0" angularVelocity="0 0 1">
  <x3d-collidable-shape><shape><sphere radius="0.5"></sphere></shape></x3d-collidable-shape>
</x3d-rigid-body></x3d-rigid-body-collection>`;

async function held(markup: string) {
  const { x3d, world } = await show(markup);
  world.paused = true;
  const find = (selector: string): Element => x3d.querySelector(selector)!;
  const at = (name = 'ball') => world.node(name)!.get('position') as number[];
  return { x3d, world, find, at };
}

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

describe('problems of an element', () => {
  const BODY = `<x3d-rigid-body-collection><transform><shape><box></box></shape><x3d-rigid-body id="b" mass="-3"></x3d-rigid-body></transform></x3d-rigid-body-collection>`;

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
