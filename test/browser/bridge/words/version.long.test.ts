import { expect } from 'chai';
import { claim } from '../../console.js';
import { place, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';

describe('the version of a document', () => {
  const axis = (world: { node(name: string): unknown }): number[] =>
    (world.node('h') as { asked(field: string): number[] }).asked('axis');

  it('of an Inline is that of its file', async () => {
    const x3d = place('<inline url="/test/pages/version3.x3d"></inline>');
    const ready = new Promise<CustomEvent>((resolve) =>
      x3d.addEventListener('physicsready', (event) => resolve(event as CustomEvent)),
    );
    claim('axis');
    const { detail } = await ready;
    expect(axis(worldOf(detail.element)!)).to.eql([0, 0, 0]);
    await wait(1100);
  });
});
