import { expect } from 'chai';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { drawn, drawnAt, show } from '../../scene.js';

type Fields = { get(field: string): number[] };

/** A rod that hangs on a ball joint 1 m from its middle; without gravity it stays wherever it is put. */
const rod = (attributes = ''): [string, string][] =>
  bothSpellings(`
    <x3d-rigid-body-collection default gravity="0 0 0"></x3d-rigid-body-collection>
    <transform id="outer"><transform id="t" translation="1 0 0"><shape><box size="1 0.2 0.2"></box></shape>
      <x3d-rigid-body id="rod" ${attributes}></x3d-rigid-body></transform></transform>
    <x3d-ball-joint id="joint" body1="rod" anchorPoint="0 0 0"></x3d-ball-joint>`);

describe('edits of one task', () => {
  const edits: [selector: string, name: string, value: string][] = [
    ['#t', 'translation', '1 5 0'],
    ['#joint', 'anchorPoint', '0 5 0'],
  ];
  const above: typeof edits = [['#outer', 'translation', '0 5 0'], edits[1]!];
  const orders: [string, typeof edits][] = [
    ['a Transform, then the joint', edits],
    ['the joint, then a Transform', [...edits].reverse()],
    ['the Transform above, then the joint', above],
    ['the joint, then the Transform above', [...above].reverse()],
  ];
  const cases = orders.flatMap(([order, list]) =>
    [false, true].map((stepped) => ({ order, list, stepped })),
  );
  for (const [spelling, markup] of rod())
    for (const { order, list, stepped } of cases)
      it(`${spelling} tags: ${order}${stepped ? ', then a step at once' : ''}: the joint is zeroed at the body's new pose`, async () => {
        const { x3d, world } = await show(markup);
        world.paused = true;
        world.advance(0.5);
        for (const [selector, name, value] of list)
          x3d.querySelector(selector)!.setAttribute(name, value);
        if (stepped) world.step(1);
        await drawn();
        world.advance(1);
        const [body, joint] = ['rod', 'joint'].map((name) => world.node(name) as unknown as Fields);
        const expected = { position: [1, 5, 0], body1AnchorPoint: [0, 5, 0] };
        for (const [k, value] of expected.position.entries())
          expect(body!.get('position')[k], 'position').to.be.closeTo(value, 1e-4);
        for (const [k, value] of expected.body1AnchorPoint.entries())
          expect(joint!.get('body1AnchorPoint')[k], 'anchor').to.be.closeTo(value, 1e-4);
      });
});

describe('an edit of a Transform', () => {
  for (const [spelling, markup] of rod())
    it(`${spelling} tags: acts for who looks in the same task, and what comes after it in that task stays`, async () => {
      const { x3d, world } = await show(markup.replace(/<(x3d-ball-joint|BallJoint).*$/s, ''));
      world.paused = true;
      world.advance(0.1);
      const transform = x3d.querySelector('#t')!;
      type Body = Fields & { teleport(to: number[]): void };
      const body = world.node('rod') as unknown as Body;
      const move = (to: string): void => transform.setAttribute('translation', to);
      move('4 5 6');
      expect(body.get('position')).to.eql([4, 5, 6]);
      body.teleport([7, 7, 7]);
      await drawn();
      expect(body.get('position')).to.eql([7, 7, 7]);
      expect(drawnAt(transform)).to.eql([7, 7, 7]);
      move('1 1 1');
      expect(body.get('position')).to.eql([1, 1, 1]);
      move('2 2 2');
      await drawn();
      expect(body.get('position')).to.eql([2, 2, 2]);
      expect(drawnAt(transform)).to.eql([2, 2, 2]);
      move('1 1 1');
      expect(body.get('position')).to.eql([1, 1, 1]);
      transform.setAttribute('rotation', '0 0 1 1');
      await drawn();
      expect(body.get('orientation')[3]).to.be.closeTo(1, 1e-6);
      // What was told early is forgotten: later edits are edits.
      move('3 3 3');
      await drawn();
      expect(body.get('position')).to.eql([3, 3, 3]);
    });
});

describe('a body that a Transform takes along', () => {
  for (const [spelling, markup] of rod('position="1 0 0"'))
    it(`${spelling} tags: takes the word it had before for no edit`, async () => {
      claim('unchanged-value');
      const { x3d, world } = await show(markup.replace(/<(x3d-ball-joint|BallJoint).*$/s, ''));
      world.paused = true;
      world.advance(0.1);
      const body = x3d.querySelector('#rod')!;
      const position = (): number[] => (world.node('rod') as unknown as Fields).get('position');
      x3d.querySelector('#t')!.setAttribute('translation', '4 5 6');
      await drawn();
      expect(position()).to.eql([4, 5, 6]);
      body.setAttribute('position', '1 0 0');
      world.step(0);
      expect(position()).to.eql([4, 5, 6]);
      body.setAttribute('position', '2 0 0');
      world.step(0);
      expect(position()).to.eql([2, 0, 0]);
    });
});
