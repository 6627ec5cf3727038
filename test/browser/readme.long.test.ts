import { expect } from 'chai';
import './console.js';
import { openText, worldIn } from './page.js';

describe('README.md', () => {
  it('its first example: the box falls and comes to rest on the floor', async () => {
    const readme = await (await fetch('/README.md')).text();
    const [, example] = readme.match(/```html\n(<!doctype html>[^]*?)```/)!;
    const scripts: Record<string, string> = {
      'x3dom.js': '/node_modules/x3dom/x3dom.js',
      'x3d-physics.single.js': '/dist/x3d-physics.single.js',
    };
    const html = example!.replace(/src="([^"]+)"/g, (_, name) => `src="${scripts[name]}"`);
    const world = await worldIn(await openText(html));
    world.paused = true;
    world.reset();
    const [box] = [...world.nodes].filter(({ type }) => type.name === 'RigidBody');
    const height = (): number => (box!.get('position') as number[])[1]!;
    expect(height()).to.equal(6);
    world.advance(0.5);
    expect(height()).to.be.closeTo(6 - 0.5 * 9.8 * 0.25, 0.03);
    world.advance(5);
    // The floor's upper side lies at 0, the box is 1 m wide and lies on one of its sides.
    expect(height()).to.be.closeTo(0.5, 0.01);
    expect(Math.hypot(...(box!.get('linearVelocity') as number[]))).to.be.below(0.01);
    expect(world.problems).to.eql([]);
  });
});
