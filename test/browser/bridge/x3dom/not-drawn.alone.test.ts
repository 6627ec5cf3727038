import { expect } from 'chai';
import { shapes } from '../../../../elements/bridge/x3dom/shapes/shapes.js';
import { claim } from '../../console.js';
import { codes, position, show } from '../../scene.js';

describe('geometry that nobody can draw', () => {
  it('collides all the same, and is told once', async () => {
    shapes.load = () => Promise.reject(new Error('not there'));
    claim('not-drawn');
    const { x3d, world } = await show(
      `<transform translation="-5 0 -5"><shape><elevationgrid xDimension="2" zDimension="2" xSpacing="10" zSpacing="10" height="0 0 0 0"></elevationgrid></shape><x3d-rigid-body id="b" fixed></x3d-rigid-body></transform>
       <transform translation="0 1 0.5"><shape><sphere radius="0.2"></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`,
      '#b',
    );
    world.paused = true;
    world.reset();
    world.advance(2);
    expect(position(world, 'ball')[1]).to.be.closeTo(0.2, 0.02);
    expect(codes(world)).to.eql(['not-drawn']);
    expect(world.problems[0].element).to.equal(x3d.querySelector('#b'));
  });
});
