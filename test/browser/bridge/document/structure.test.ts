import { expect } from 'chai';
import type { X3DRigidBodyElement } from '../../../../elements/index.js';
import { show, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { append, ball, collection } from '../scene/collections.js';

describe('a CollisionCollection outside any collection', () => {
  const bouncing = `<x3d-collision-collection id="k" collidables="*" bounce="1" appliedparameters="BOUNCE"></x3d-collision-collection>`;
  const drop = collection(
    '',
    `<x3d-rigid-body fixed="true" position="0 -0.5 0"><x3d-collidable-shape><shape><box size="9 1 9"></box></shape></x3d-collidable-shape></x3d-rigid-body>` +
      ball('class="ball" position="0 3 0"'),
  );

  /** How high the ball stands a second and a half after it was let go: 3 m up it has bounced once. */
  async function height(x3d: Element): Promise<number> {
    const body = x3d.querySelector<X3DRigidBodyElement>('.ball')!;
    const world = worldOf(body)!;
    await world.ready;
    world.paused = true;
    world.reset();
    world.advance(1.27);
    return body.position[1]!;
  }

  for (const where of ['before', 'after'])
    it(`${where} the collection, speaks for the collection that comes in the place of another`, async () => {
      const { x3d } = await show(where === 'before' ? bouncing + drop : drop + bouncing);
      expect(await height(x3d)).to.be.greaterThan(2.5);
      for (let i = 0; i < 2; i++) {
        x3d.querySelector('x3d-rigid-body-collection')!.remove();
        if (i) await wait(0);
        append(x3d, drop);
        expect(await height(x3d), `replaced ${i}`).to.be.greaterThan(2.5);
      }
      x3d.querySelector('#k')!.remove();
      expect(await height(x3d)).to.be.below(1.2);
    });

  it('takes the obstacles that it lists, and a sensor of them, along to the next collection', async () => {
    const falls = collection('', ball('class="ball" position="0 3 0"'));
    const { x3d } = await show(`${falls}
      <x3d-collision-collection def="K"><x3d-collidable-shape translation="0 -0.5 0"><shape><box size="9 1 9"></box></shape></x3d-collidable-shape></x3d-collision-collection>
      <x3d-collision-sensor id="sensor"><x3d-collision-collection use="K"></x3d-collision-collection></x3d-collision-sensor>`);
    const worlds = [];
    for (let i = 0; i < 3; i++) {
      const world = worldOf(x3d.querySelector('.ball'))!;
      await world.ready;
      worlds.push(world);
      expect(worldOf(x3d.querySelector('#sensor'))).to.equal(world);
      world.paused = true;
      world.reset();
      world.advance(3);
      const [, y] = world.node(x3d.querySelector('.ball'))!.get('position') as number[];
      expect(y, `round ${i}`).to.be.closeTo(1, 0.02);
      x3d.querySelector('x3d-rigid-body-collection')!.remove();
      await wait(0);
      append(x3d, falls);
    }
    expect(worlds.map(({ started }) => started)).to.eql([false, false, false]);
  });

  it('speaks for whatever collection is the only one, whichever came first', async () => {
    const { x3d } = await show(bouncing, '#k');
    append(x3d, drop);
    expect(await height(x3d)).to.be.greaterThan(2.5);
    const other = append(x3d, collection());
    expect(await height(x3d)).to.be.below(1.2);
    other.remove();
    expect(await height(x3d)).to.be.greaterThan(2.5);
  });
});
