import { expect } from 'chai';
import { claim } from '../../console.js';
import { place, until } from '../../scene.js';
import { worldOf, type World } from '../../inside.js';

/**
 * x3dom makes elements of a JSON file in the page's own document, and adds them to none: they are a file of their own
 * all the same.
 */
async function load(): Promise<{ world: World; rod: Element }> {
  const x3d = place('<inline url="/test/pages/leaning-rod.json"></inline>');
  const rod = (): Element | null => {
    const inline = x3d.querySelector('inline') as unknown as {
      _x3domNode?: { _childNodes: { _xmlNode: Element }[] };
    };
    return inline._x3domNode?._childNodes[0]?._xmlNode.querySelector('RigidBody[DEF]') ?? null;
  };
  await until(() => rod() !== null && worldOf(rod()!) !== undefined);
  const world = worldOf(rod()!)!;
  await world.ready;
  world.paused = true;
  world.reset();
  return { world, rod: rod()! };
}

const numbers = (world: World, name: string, field: string): number[] =>
  (world.node(name) as unknown as { asked(field: string): number[] }).asked(field);

describe('a JSON file in an Inline', () => {
  it('has its own UNIT statements and its own version', async () => {
    claim('axis');
    const { world } = await load();
    expect(world.stats.bodies).to.equal(1);
    // x3dom's reader keeps the last unit of a file alone.
    expect((world.node('rod')!.get('orientation') as number[])[3]).to.be.closeTo(Math.PI / 2, 1e-5);
    // X3D 3 gives a hinge no axis.
    expect(numbers(world, 'hinge', 'axis')).to.eql([0, 0, 0]);
  });

  it('is followed as it is edited', async () => {
    claim('axis');
    const { world, rod } = await load();
    rod.setAttribute('mass', '7');
    world.step(0);
    expect(world.node('rod')!.get('mass')).to.equal(7);
    expect(world.problems.map(({ code }) => code)).to.eql(['bad-value']);
  });
});
