import { expect } from 'chai';
import { sendKeys } from '@web/test-runner-commands';
import { camera, draggable, listen, names, pixelOf, position } from './hand.js';
import { show, until, wait } from '../../../scene.js';
import { on, THREADS, type Thread } from '../../../threads.js';

const box = '<shape><box size="1 1 1"></box></shape>';
const body = (name: string, x: number, attributes = ''): string =>
  `<transform translation="${x} 0 0">${box}<x3d-rigid-body ${name} ${attributes}></x3d-rigid-body></transform>`;

async function stage(mode = 'teleport', thread: Thread = 'main') {
  const { x3d, world } = await show(
    `<viewpoint position="0 0 10" orientation="0 1 0 0"></viewpoint>
    <x3d-rigid-body-collection default gravity="0 0 0" draggable-body drag-mode="${mode}" thread="${thread}"></x3d-rigid-body-collection>
    ${body('id="b1" title="The crate"', -2)}${body('id="b2"', 0)}${body('', 2)}`,
    '#b2',
  );
  // Where Tab goes on to: behind the last thing of a page the focus would leave it.
  document.body.append(document.createElement('button'));
  await draggable(x3d);
  await world.ask('stats');
  const root = x3d.querySelector('.x3d-physics-handles')!.shadowRoot!;
  return { x3d, world, root, events: listen(x3d), crate: world.node('b1')! };
}

const focused = (root: ShadowRoot): string | null | undefined =>
  root.activeElement?.getAttribute('aria-label');
const pressed = (root: ShadowRoot): string | null | undefined =>
  root.activeElement?.getAttribute('aria-pressed');
const said = (root: ShadowRoot): string => root.querySelector('[role=status]')!.textContent!;

/** Tab, until it reaches the bodies of the scene. */
async function tabIn(root: ShadowRoot): Promise<void> {
  (document.activeElement as HTMLElement | null)?.blur();
  for (let i = 0; i < 6 && !root.activeElement; i++) await sendKeys({ press: 'Tab' });
}

const press = async (...keys: string[]): Promise<void> => {
  for (const key of keys) await sendKeys({ press: key });
};

describe('dragging by keyboard', () => {
  it('reaches every body: by Tab the first, by arrow keys the others', async () => {
    const { root } = await stage();
    await tabIn(root);
    expect(focused(root)).to.equal('The crate');
    await press('ArrowRight');
    expect(focused(root)).to.equal('b2');
    await press('ArrowDown', 'ArrowDown');
    expect(focused(root)).to.equal('Body 3');
    await press('Home');
    expect(focused(root)).to.equal('The crate');
  });

  for (const thread of THREADS)
    it(`takes hold, moves in the plane before the viewer and away, and lets go${on(thread)}`, async () => {
      const { x3d, root, events, crate } = await stage('teleport', thread);
      const seen = camera(x3d);
      const scrolled = window.scrollY;
      await tabIn(root);
      await press('Enter');
      expect(pressed(root)).to.equal('true');
      expect(said(root)).to.equal('The crate held');
      expect(crate.host).to.satisfy((element: Element) => element.matches(':state(dragging)'));
      // A fortieth of the picture's height: 8.28 m at the bodies' distance.
      const step = (2 * 10 * Math.tan(Math.PI / 8)) / 40;
      await press('ArrowRight', 'ArrowRight', 'ArrowUp');
      const [x, y, z] = position(crate);
      expect(x).to.be.closeTo(-2 + 2 * step, 0.01);
      expect(y).to.be.closeTo(step, 0.01);
      expect(z).to.be.closeTo(0, 0.001);
      await press('PageUp');
      expect(position(crate)[2]).to.be.closeTo(-step, 0.01);
      await press('PageDown');
      expect(position(crate)[2]).to.be.closeTo(0, 0.02);
      await press('Enter');
      expect(pressed(root)).to.equal('false');
      expect(said(root)).to.equal('The crate released');
      expect(names(events)).to.deep.equal(['bodydragstart', 'bodydrag', 'bodydragend']);
      expect(events[0]!.detail.by).to.equal('keyboard');
      expect(camera(x3d)).to.equal(seen);
      expect(window.scrollY).to.equal(scrolled);
    });

  it('puts back with Escape, and lets go when the focus leaves', async () => {
    const { root, events, crate } = await stage('kinematic');
    await tabIn(root);
    await press('Enter', 'ArrowUp', 'Escape');
    expect(position(crate)[1]).to.be.closeTo(0, 1e-5);
    expect(events.at(-1)!.detail.reason).to.equal('cancelled');
    await press('Enter', 'ArrowUp', 'Tab');
    expect(events.at(-1)!.detail.reason).to.equal('released');
    expect(position(crate)[1]).to.be.above(0.1);
  });

  for (const thread of THREADS)
    it(`moves by a spring, too${on(thread)}`, async () => {
      const { root, crate } = await stage('spring', thread);
      await tabIn(root);
      await press('Enter', 'ArrowUp', 'ArrowUp');
      await until(() => position(crate)[1]! > 0.35);
    });

  it('shows which body has the focus, around it, while it moves', async () => {
    const { x3d, root, crate } = await stage();
    await tabIn(root);
    await press('Enter', 'ArrowUp', 'ArrowUp', 'ArrowRight');
    const middle = (): number => {
      const { left, width } = root.activeElement!.getBoundingClientRect();
      return left + width / 2;
    };
    await until(() => Math.abs(middle() - pixelOf(x3d, position(crate))[0]) < 3);
    const { left, top, width, height } = root.activeElement!.getBoundingClientRect();
    const [x, y] = pixelOf(x3d, position(crate));
    expect(Math.abs(left + width / 2 - x)).to.be.below(3);
    expect(Math.abs(top + height / 2 - y)).to.be.below(3);
    // Half the diagonal of a cube of 1 m.
    const [edge] = pixelOf(x3d, [position(crate)[0]! + 0.87, position(crate)[1]!, 0]);
    expect(Math.abs(width / 2 - (edge - x))).to.be.below(4);
  });

  it('takes no room and no pointer', async () => {
    const { x3d } = await stage();
    const box = x3d.querySelector('.x3d-physics-handles')!;
    const { left, top, width, height } = x3d.querySelector('canvas')!.getBoundingClientRect();
    expect(width).to.equal(300);
    expect(height).to.equal(200);
    expect(document.elementFromPoint(left + 150, top + 100)).to.equal(x3d.querySelector('canvas'));
    expect(getComputedStyle(box).pointerEvents).to.equal('none');
  });

  it('keeps the focus when the world starts again, and passes it on when the body goes', async () => {
    const { x3d, world, root } = await stage();
    await tabIn(root);
    world.reset();
    await wait(50);
    expect(focused(root)).to.equal('The crate');
    x3d.querySelector('#b1')!.remove();
    await until(() => focused(root) === 'b2');
  });
});

describe('names of bodies to drag', () => {
  it('are written once each, however many come or go, together or one by one, and kept in order', async () => {
    const { x3d, root } = await stage();
    const scene = x3d.querySelector('scene')!;
    const written = new MutationObserver(() => {});
    written.observe(root, { subtree: true, attributeFilter: ['aria-label'] });
    const labels = (): (string | null)[] =>
      [...root.querySelectorAll('button')].map((button) => button.getAttribute('aria-label'));
    const count = 40;
    for (let i = 0; i < count; i++) scene.insertAdjacentHTML('beforeend', body('', i));
    await until(() => labels().length === 3 + count);
    for (let i = 0; i < 5; i++) {
      scene.insertAdjacentHTML('beforeend', body('', i));
      await until(() => labels().length === 4 + count + i);
    }
    await wait(0);
    const numbers = Array.from({ length: count + 6 }, (_, i) => `Body ${i + 3}`);
    expect(labels()).to.eql(['The crate', 'b2', ...numbers]);
    expect(written.takeRecords().length).to.be.at.most(count + 5);
    const bodies = [...x3d.querySelectorAll('transform')];
    for (const gone of bodies.slice(2, 12)) gone.remove();
    await until(() => labels().length === 38);
    await wait(0);
    expect(labels()).to.eql(['The crate', 'b2', ...numbers.slice(0, 36)]);
    expect(written.takeRecords().length).to.be.at.most(36);
    x3d.querySelector('#b2')!.setAttribute('title', 'The ball');
    root.querySelectorAll('button')[1]!.focus();
    expect(labels()[1]).to.equal('The ball');
  });
});
