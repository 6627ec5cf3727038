import { expect } from 'chai';
import { bothSpellings } from '../../forms.js';
import { show, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { type PageWorld, append, ball, collection, outcome } from './collections.js';

describe('a world', () => {
  for (const attributes of ['', 'shared-world="w"'])
    for (const [spelling, markup] of bothSpellings(collection(attributes)))
      it(`${spelling} tags ${attributes}: ends with its last collection, and gives back what it had of Bullet`, async () => {
        const { x3d, world: first } = await show('<group></group>' + ball('id="stays"'), '#stays');
        first.paused = true;
        // A block taken for good: where nothing leaks, it lies where the one before could have lain.
        const heap = first.engine.ammo as unknown as { _malloc(bytes: number): number };
        const take = (): number => heap._malloc(65536);
        const worlds: PageWorld[] = [];
        const cycles = async (count: number): Promise<void> => {
          for (let i = 0; i < count; i++) {
            const added = append(x3d, markup);
            const world = worldOf(added)!;
            await world.ready;
            world.step(2);
            worlds.push(world);
            added.remove();
            await wait(0);
            expect(worldOf(added)).to.equal(undefined);
          }
        };
        await cycles(5);
        take();
        const [one, two] = [take(), take()];
        await cycles(10);
        take();
        const before = take();
        await cycles(10);
        expect(take() - before).to.equal(two! - one!);
        expect(new Set(worlds).size).to.equal(25);
        expect(worlds.filter(({ started }) => started)).to.eql([]);
        expect(first.started).to.equal(true);
        expect(first.stats.bodies).to.equal(1);
      });

  it('goes on while its last body is put back within the task, stepped meanwhile or not', async () => {
    for (const steps of [0, 3]) {
      const { x3d, world } = await show(collection('', ball('id="b" position="0 9 0"')));
      world.paused = true;
      const time = world.time;
      for (const selector of ['#b', 'x3d-rigid-body-collection']) {
        const element = x3d.querySelector(selector)!;
        const parent = element.parentElement!;
        element.remove();
        world.step(steps);
        parent.append(element);
        await wait(0);
        expect(worldOf(element), selector).to.equal(world);
        world.step(1);
        expect(world.stats.bodies, selector).to.equal(1);
      }
      expect(world.time).to.be.closeTo(time + (2 * steps + 2) * world.timeStep, 1e-9);
    }
  });

  it('of a collection put back later is another one, from its markup, and physicsready fires again', async () => {
    const { x3d, world } = await show(collection('id="c"', ball('id="b" position="0 9 0"')));
    world.paused = true;
    world.advance(1);
    const element = x3d.querySelector('#c')!;
    const parent = element.parentElement!;
    element.remove();
    await wait(0);
    expect(worldOf(element)).to.equal(undefined);
    let ready = 0;
    element.addEventListener('physicsready', () => ready++);
    parent.append(element);
    const again = worldOf(element)!;
    expect(again).not.to.equal(world);
    expect(await outcome(again)).to.equal('ready');
    again.paused = true;
    again.reset();
    again.advance(1);
    expect((again.node('b')!.get('position') as number[])[1]).to.be.closeTo(9 - 4.9, 0.05);
    await wait(0);
    expect(ready).to.equal(1);
    expect(world.stats.bodies).to.equal(0);
  });

  it('the default one, is the <x3d>’s own: it outlives its bodies, and who holds it goes on', async () => {
    const { x3d, world } = await show(ball('id="b"'), '#b');
    world.paused = true;
    x3d.querySelector('#b')!.remove();
    await wait(20);
    append(x3d, ball('id="c" position="0 9 0"'));
    expect(worldOf(x3d.querySelector('#c'))).to.equal(world);
    world.advance(1);
    expect((world.node('c')!.get('position') as number[])[1]).to.be.closeTo(9 - 4.9, 0.05);
    x3d.remove();
    await wait(0);
    expect(world.started).to.equal(false);
  });

  it('that loses its collection to another world ends', async () => {
    const apart = ball('position="9 0 0"');
    const { x3d, world } = await show(
      collection('id="a"') + collection('id="b" shared-world="w"', apart),
    );
    x3d.querySelector('#a')!.setAttribute('shared-world', 'w');
    await wait(0);
    const shared = worldOf(x3d.querySelector('#b'))!;
    expect(world.started).to.equal(false);
    expect(worldOf(x3d.querySelector('#a'))).to.equal(shared);
    await shared.ready;
    expect(shared.stats.bodies).to.equal(2);
  });
});
