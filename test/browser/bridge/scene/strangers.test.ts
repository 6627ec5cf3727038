import { expect } from 'chai';
import { claim } from '../../console.js';
import { show, until, wait } from '../../scene.js';

const ball = (inner: string): string =>
  `<transform translation="2 1 0"><shape><sphere radius="0.4"></sphere></shape>${inner}</transform>`;
const RUNS = ball('<x3d-rigid-body id="b"></x3d-rigid-body>');

/** Tags that there are not, and what is said of them. */
const TAGS: [tag: string, answer: string][] = [
  ['x3d-rigidbody', "<x3d-rigidbody> is no node; did you mean <x3d-rigid-body>, X3D's RigidBody?"],
  [
    'x3d-hinge-joint',
    "<x3d-hinge-joint> is no node; did you mean <x3d-single-axis-hinge-joint>, X3D's SingleAxisHingeJoint? it turns about axis through anchorPoint",
  ],
  [
    'HingeJoint',
    "<hingejoint> is no node; did you mean <SingleAxisHingeJoint>, X3D's SingleAxisHingeJoint? it turns about axis through anchorPoint",
  ],
  ['RigidBodie', "<rigidbodie> is no node; did you mean <RigidBody>, X3D's RigidBody?"],
  ['x3d-zeppelin', '<x3d-zeppelin> is no node'],
];

describe('a tag that nobody knows', () => {
  for (const [tag, answer] of TAGS) {
    it(`${tag} is told with what was meant, and the rest runs`, async () => {
      claim('is no node');
      const { x3d, world } = await show(`${ball(`<${tag} id="s"></${tag}>`)}${RUNS}`, '#b');
      await until(() => world.problems.length > 0);
      expect(world.stats.bodies).to.equal(1);
      expect(world.problems.map(({ code, message }) => [code, message])).to.eql([
        ['unknown-tag', answer],
      ]);
      expect(world.problems[0].element).to.equal(x3d.querySelector('#s'));
      x3d.querySelector('#s')!.remove();
      await until(() => world.problems.length === 0);
    });
  }

  it('is none that others made: custom elements, nodes of x3dom, instances of prototypes', async () => {
    customElements.define('x3d-of-mine', class extends HTMLElement {});
    const { x3d, world } = await show(
      `<ProtoDeclare name="PhysicsThing"><ProtoBody><Group></Group></ProtoBody></ProtoDeclare>
        <x3d-of-mine></x3d-of-mine><collision></collision><ProtoInstance name="PhysicsThing"></ProtoInstance>${RUNS}`,
      '#b',
    );
    await until(() => x3d.querySelector('physicsthing') !== null);
    await wait(50);
    expect(world.problems).to.eql([]);
  });

  it('an attribute of another engine is told with what to write, and what that does', async () => {
    claim('write fixed="true": a fixed body that is moved', 'every body moves that is not fixed');
    const { world } = await show(
      ball('<x3d-rigid-body id="b" kinematic></x3d-rigid-body>') +
        ball('<x3d-rigid-body id="c" type="dynamic"></x3d-rigid-body>').replace('2 1 0', '5 1 0'),
      '#b',
    );
    expect(world.problems.map(({ code }) => code)).to.eql([
      'unknown-attribute',
      'unknown-attribute',
    ]);
  });
});
