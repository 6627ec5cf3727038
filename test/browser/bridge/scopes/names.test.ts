import { expect } from 'chai';
import { X3DRigidBodyElement } from '../../../../elements/index.js';
import { show } from '../../scene.js';
import { worldOf } from '../../inside.js';

describe('names', () => {
  it('world.node takes the id of an element with a DEF', async () => {
    const { world } = await show(
      `<x3d-rigid-body-collection id="c"><x3d-rigid-body id="i" def="D"></x3d-rigid-body>
        <x3d-rigid-body id="D" def="E"></x3d-rigid-body></x3d-rigid-body-collection>`,
      '#c',
    );
    expect(world.node('i')).to.equal(world.node('D'));
    expect((world.node('D')!.host as Element).id).to.equal('i');
    expect((world.node('E')!.host as Element).id).to.equal('D');
    expect(world.node('nobody')).to.equal(undefined);
  });

  it('worldOf nothing is undefined', () => {
    expect(worldOf(null)).to.equal(undefined);
    expect(worldOf(undefined)).to.equal(undefined);
  });

  it('a class of ours under another tag has its properties and simulates', async () => {
    class Mine extends X3DRigidBodyElement {}
    customElements.define('my-body', Mine);
    const mine = new Mine();
    Object.assign(mine, { mass: 3, position: [0, 4, 0], id: 'm' });
    expect(mine.mass).to.equal(3);
    const { x3d, world } = await show(
      '<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>',
      '#c',
    );
    world.paused = true;
    x3d.querySelector('#c')!.append(mine);
    world.step(0);
    expect(world.node('m')!.get('mass')).to.equal(3);
    mine.setAttribute('mass', '5');
    expect(world.node(mine)!.get('mass')).to.equal(5);
    x3d.remove();
  });
});
