import { expect } from 'chai';
import { claim } from '../../console.js';
import { show, wait } from '../../scene.js';

describe('nodes as properties', () => {
  it('name elements in the place of children, and give them back', async () => {
    claim('no-body', 'unused-collidable');
    const { x3d, world } = await show(
      `<x3d-collidable-shape id="s"><shape><sphere></sphere></shape></x3d-collidable-shape>
       <x3d-rigid-body-collection id="c"><x3d-rigid-body id="a"></x3d-rigid-body><x3d-rigid-body id="b" position="3 0 0"></x3d-rigid-body>
         <x3d-ball-joint id="j"></x3d-ball-joint></x3d-rigid-body-collection>`,
      '#c',
    );
    world.paused = true;
    // Told in a task of its own.
    await wait(0);
    const find = (id: string): never => x3d.querySelector(`#${id}`)! as never;
    const body = find('a') as { geometry: unknown };
    body.geometry = [find('s')];
    world.step(0);
    expect(body.geometry).to.eql([find('s')]);
    expect((world.node('a')!.get('geometry') as unknown[]).length).to.equal(1);
    const joint = find('j') as { body1: unknown; body2: unknown };
    Object.assign(joint, { body1: find('a'), body2: find('b') });
    world.step(0);
    expect([joint.body1, joint.body2]).to.eql([find('a'), find('b')]);
    expect(world.stats.joints).to.equal(1);
    expect(world.problems).to.eql([]);
    body.geometry = null;
    joint.body2 = null;
    world.step(0);
    expect(body.geometry).to.eql([]);
    expect(joint.body2).to.equal(null);
    x3d.remove();
  });

  it('name the bodies of a joint by text, too, as its attributes do', async () => {
    claim('no-body');
    const { x3d, world } = await show(
      `<x3d-rigid-body-collection id="c"><x3d-rigid-body id="a"></x3d-rigid-body><x3d-rigid-body def="b" position="3 0 0"></x3d-rigid-body>
         <x3d-ball-joint id="j"></x3d-ball-joint></x3d-rigid-body-collection>`,
      '#c',
    );
    world.paused = true;
    const joint = x3d.querySelector<HTMLElementTagNameMap['x3d-ball-joint']>('#j')!;
    Object.assign(joint, { body1: 'a', body2: 'b' });
    world.step(0);
    expect(joint.body1).to.equal(x3d.querySelector('#a'));
    expect(joint.body2).to.equal(x3d.querySelector('[def="b"]'));
    expect(world.stats.joints).to.equal(1);
  });
});
