import { expect } from 'chai';
import { type X3DRigidBodyElement, explain } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { drawn, drawnAt, show } from '../../scene.js';

describe('the world in a page', () => {
  const scene = `
    <transform translation="0 3 0"><shape><sphere radius="0.5"></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>
    <x3d-rigid-body-collection id="c" default></x3d-rigid-body-collection>`;

  it('raycast tells the element that is hit, and null of nothing', async () => {
    const { x3d, world } = await show(scene, '#c');
    world.paused = true;
    world.reset();
    const hit = world.raycast([0, 10, 0], [0, -10, 0]) as { element: Element; position: number[] };
    expect(hit.element).to.equal(x3d.querySelector('#ball'));
    expect(hit.position[1]).to.be.closeTo(3.5, 1e-3);
    expect(world.raycast([5, 10, 0], [5, -10, 0])).to.equal(null);
  });

  it('snapshot and restore take what is drawn and what elements say along', async () => {
    const { x3d, world } = await show(scene, '#c');
    world.paused = true;
    world.reset();
    world.advance(0.5);
    const snapshot = world.snapshot();
    const ball = x3d.querySelector<X3DRigidBodyElement>('#ball')!;
    const before = ball.position;
    const runs = [1, 2].map(() => {
      world.restore(snapshot);
      expect(ball.position).to.eql(before);
      world.advance(0.5);
      return ball.position;
    });
    expect(runs[0]).to.eql(runs[1]);
    world.restore(snapshot);
    expect(world.time).to.be.closeTo(0.5, 1e-9);
    await drawn();
    expect(drawnAt(x3d.querySelector('transform')!)[1]).to.be.closeTo(before[1]!, 1e-4);
  });

  it('a problem of the world shows at its collection until it is settled', async () => {
    const { x3d, world } = await show(scene, '#c');
    const collection = x3d.querySelector('#c')!;
    claim('[something]');
    world.report({ code: 'something', severity: 'info', message: 'said' });
    expect(collection.matches(':state(problem)')).to.equal(true);
    world.settle(world, undefined, 'something');
    expect(collection.matches(':state(problem)')).to.equal(false);
  });

  it('explain says why a body sleeps', async () => {
    const { x3d, world } = await show(
      `<x3d-rigid-body-collection id="c" autodisable="true" disablelinearspeed="1" disableangularspeed="1">
        <x3d-rigid-body id="b" useglobalgravity="false"></x3d-rigid-body></x3d-rigid-body-collection>`,
      '#c',
    );
    world.paused = true;
    const body = x3d.querySelector<X3DRigidBodyElement>('#b')!;
    world.advance(0.5);
    expect(explain(body).sleeps).to.match(/^autoDisable/);
    body.wake();
    expect(explain(body).sleeps).to.equal(undefined);
  });
});
