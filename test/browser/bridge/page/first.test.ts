import { expect } from 'chai';
import { worldOf, type X3DRigidBodyElement } from '../../../../elements/index.js';
import { drawnAt, nextFrame, show } from '../../scene.js';

const ballOnFloor = `
  <viewpoint position="0 2 10"></viewpoint>
  <x3d-rigid-body-collection>
    <x3d-rigid-body id="floor" fixed="true" position="0 -0.5 0">
      <x3d-collidable-shape><shape><box size="10 1 10"></box></shape></x3d-collidable-shape>
    </x3d-rigid-body>
    <x3d-rigid-body id="ball" position="0 3 0">
      <x3d-collidable-shape use="ballshape"></x3d-collidable-shape>
    </x3d-rigid-body>
  </x3d-rigid-body-collection>
  <x3d-collidable-shape def="ballshape"><shape><appearance><material></material></appearance><sphere radius="0.5"></sphere></shape></x3d-collidable-shape>`;

describe('ball on floor with custom tags', () => {
  it('falls and comes to rest on the floor', async () => {
    const { x3d, world } = await show(ballOnFloor);
    const ball = x3d.querySelector('#ball') as X3DRigidBodyElement & { position: number[] };
    expect(worldOf(ball)).to.equal(world);
    expect(ball.position[1]).to.be.closeTo(3, 0.3);
    world.advance(3);
    expect(ball.position[1]).to.be.closeTo(0.5, 0.02);
  });

  it('is drawn where it is', async () => {
    const { x3d, world } = await show(ballOnFloor);
    world.paused = true;
    world.advance(3);
    await nextFrame();
    await nextFrame();
    const shape = x3d.querySelector('[def=ballshape]')!;
    expect(drawnAt(shape)[1]).to.be.closeTo(0.5, 0.02);
  });
});
