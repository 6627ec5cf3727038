import { expect } from 'chai';
import { listen, mouse } from './hand.js';
import { until } from '../../../scene.js';
import { worldOf, type World } from '../../../inside.js';
import { on, THREADS } from '../../../threads.js';
import { one, stage, dragTo } from './scenes.js';

async function restoreNow(element: HTMLElement): Promise<void> {
  const world = worldOf(element)!;
  world.restore((await world.ask('snapshot')) as ReturnType<World['snapshot']>);
}

describe('a drag ends cleanly', () => {
  const ends: [what: string, act: (element: HTMLElement) => unknown, reason: string][] = [
    ['the element is removed', (element) => element.remove(), 'removed'],
    ['the world starts again', (element) => worldOf(element)!.reset(), 'reset'],
    ['a snapshot is restored', restoreNow, 'reset'],
    ['it is disabled', (element) => element.setAttribute('enabled', 'false'), 'disabled'],
    ['it may no longer be dragged', (e) => e.removeAttribute('draggable-body'), 'disabled'],
    ['the <x3d> goes', (element) => element.closest('x3d')!.remove(), 'removed'],
  ];
  for (const [what, act, reason] of ends)
    for (const thread of THREADS)
      it(`when ${what}${on(thread)}`, async () => {
        const { x3d, element, world } = await stage(one('draggable-body', thread));
        const events = listen(element);
        await dragTo(x3d, [0, 0, 0.5], [1, 0, 0.5]);
        await act(element);
        world.step(0);
        await until(() => events.at(-1)!.type === 'bodydragend');
        expect(events.at(-1)!.detail.reason).to.equal(reason);
        expect(element.matches(':state(dragging)')).to.be.false;
        await mouse.move([20, 20]);
        await mouse.up();
        expect(events.filter(({ type }) => type === 'bodydragend')).to.have.length(1);
      });

  it('and nothing of dragging is left in a page without draggable bodies', async () => {
    const { x3d, element } = await stage(one('draggable-body'));
    element.removeAttribute('draggable-body');
    await until(() => x3d.querySelector('.x3d-physics-handles') === null);
    element.setAttribute('draggable-body', '');
    await until(() => x3d.querySelector('.x3d-physics-handles') !== null);
  });
});
