import { expect } from 'chai';
import { camera, draggable, listen, names, pixelOf, position, touch } from './hand.js';
import { nextFrame, show, until } from '../../../scene.js';
import { on, THREADS, type Thread } from '../../../threads.js';

const box = (id: string, x: number): string =>
  `<transform translation="${x} 0 0"><shape><box size="1 1 1"></box></shape><x3d-rigid-body id="${id}"></x3d-rigid-body></transform>`;

async function stage(thread: Thread = 'main') {
  const { x3d, world } = await show(
    `<viewpoint position="0 0 10" orientation="0 1 0 0"></viewpoint>
    <x3d-rigid-body-collection default gravity="0 0 0" draggable-body drag-mode="kinematic" thread="${thread}"></x3d-rigid-body-collection>
    ${box('b1', -2)}${box('b2', 2)}`,
    '#b1',
  );
  await draggable(x3d);
  await world.ask('stats');
  const [one, two] = [world.node('b1')!, world.node('b2')!];
  return { x3d, one, two, events: listen(x3d) };
}

const chromium = 'chrome' in window;

describe('dragging by touch', () => {
  for (const thread of THREADS)
    it(`moves a body with a finger, and neither the camera nor the page${on(thread)}`, async () => {
      const { x3d, one, events } = await stage(thread);
      document.body.style.height = '4000px';
      const seen = camera(x3d);
      const [x, y] = pixelOf(x3d, [-2, 0, 0.5]);
      await touch('start', [x, y]);
      for (let i = 1; i <= 6; i++) {
        await touch('move', [x, y + 8 * i]);
        await nextFrame();
      }
      expect(position(one)[1]).to.be.below(-1);
      await touch('end', ...(chromium ? [] : ([[x, y]] as [number, number][])));
      await until(() => events.at(-1)!.type === 'bodydragend');
      document.body.style.height = '';
      expect(names(events)).to.deep.equal(['bodydragstart', 'bodydrag', 'bodydragend']);
      // The finger of WebKitGTK's driver comes as a mouse.
      const by = /Chrom|Firefox/.test(navigator.userAgent) ? 'touch' : 'mouse';
      expect(events.at(-1)!.detail).to.include({ by, reason: 'released' });
      expect(camera(x3d)).to.equal(seen);
      expect(window.scrollY).to.equal(0);
    });

  // The other drivers have one finger only.
  if (!chromium) return;

  it('moves two bodies with two fingers', async () => {
    const { x3d, one, two, events } = await stage();
    const seen = camera(x3d);
    const [a, b] = [pixelOf(x3d, [-2, 0, 0.5]), pixelOf(x3d, [2, 0, 0.5])];
    await touch('start', a);
    await touch('start', a, b);
    await touch('move', [a[0], a[1] - 20], [b[0], b[1] + 20]);
    await until(() => position(one)[1]! > 0.5 && position(two)[1]! < -0.5);
    await touch('end');
    await until(() => events.filter(({ type }) => type === 'bodydragend').length === 2);
    expect(camera(x3d)).to.equal(seen);
  });

  for (const thread of THREADS)
    it(`puts back what a cancelled touch had moved${on(thread)}`, async () => {
      const { x3d, one, events } = await stage(thread);
      const [x, y] = pixelOf(x3d, [-2, 0, 0.5]);
      await touch('start', [x, y]);
      await touch('move', [x, y - 30]);
      await until(() => position(one)[1]! > 0.5);
      await touch('cancel');
      await until(() => events.at(-1)!.type === 'bodydragend');
      expect(events.at(-1)!.detail.reason).to.equal('cancelled');
      expect(position(one)[1]).to.be.closeTo(0, 1e-5);
    });
});
