import { expect } from 'chai';
import { sendKeys } from '@web/test-runner-commands';
import { deformableTags, ropeTags } from '../../../../../elements/bridge/index.js';
import { until } from '../../../scene.js';
import { on, THREADS } from '../../../threads.js';
import { camera, far, mouse, names, pointUnder } from './hand.js';
import { box, CAMERA, collection, dragTo, stage } from './scenes.js';

// What comes late would have worlds wait for it.
await Promise.all([deformableTags.load(), ropeTags.load()]);

afterEach(() => mouse.up());

const LOOK = '<shape><appearance><material></material></appearance></shape>';

/** A metre wide and high around the origin, held by its upper corners; it hangs still. */
const cloth = (attributes = 'draggable-body') =>
  `${LOOK}<x3d-cloth id="b" size="2 2" subdivision="8 8" mass="0.5" damping="4" fixedIndex="72 80" ${attributes}></x3d-cloth>`;
const rope = (attributes = 'draggable-body') =>
  `${LOOK}<x3d-rope id="b" points="0 1 0 0 -1 0" segments="10" mass="0.2" damping="4" fixedIndex="0" ${attributes}></x3d-rope>`;
const cube = (attributes = 'draggable-body') =>
  `${box('s')}<x3d-soft-body id="b" mass="1" damping="4" youngsModulus="20000" ${attributes}></x3d-soft-body>`;

const of = (content: string, rest = '') => `${CAMERA}${rest}<transform>${content}</transform>`;
const points = (node: { get(field: string): unknown }): number[][] =>
  node.get('positions') as number[][];
/** Of some of its points, the middle. */
const middle = (node: { get(field: string): unknown }, ...numbers: number[]): number[] => {
  const all = points(node).filter((_, i) => numbers.length === 0 || numbers.includes(i));
  return [0, 1, 2].map((k) => all.reduce((sum, point) => sum + point[k]!, 0) / all.length);
};

describe('ropes, cloth and soft bodies in the hand', () => {
  for (const thread of THREADS)
    for (const [what, content, from, to, numbers, gravity] of [
      ['a cloth', cloth(), [0.5, -0.75, 0], [0.5, -0.2, 0], [15], '0 -9.8 0'],
      [
        'a rope, beside it by a few pixels',
        rope(),
        [0.05, -0.6, 0],
        [0.9, -0.2, 0],
        [8],
        '0 -9.8 0',
      ],
      ['a soft body', cube(), [0.2, 0.2, 0.5], [1.5, 0.7, 0.5], [], '0 0 0'],
    ] as const)
      it(`the mouse drags ${what}, and not the camera${on(thread)}`, async () => {
        const { x3d, world, element, events, body } = await stage(
          of(content, collection(`gravity="${gravity}" thread="${thread}"`)),
        );
        const seen = camera(x3d);
        const before = middle(body, ...numbers);
        const { end } = await dragTo(x3d, [...from], [...to]);
        const goal = pointUnder(x3d, end, from[2]);
        const there = before.map((value, k) => value + goal[k]! - from[k]!);
        // What is taken beside its middle turns.
        const near = numbers.length > 0 ? 0.3 : 0.8;
        await until(() => far(middle(body, ...numbers), there) < near);
        expect(names(events)).to.deep.equal(['bodydragstart', 'bodydrag']);
        expect(far(events.at(-1)!.detail.point, goal)).to.be.below(0.06);
        expect(element.matches(':state(dragging)')).to.be.true;
        await mouse.up();
        await until(() => events.at(-1)!.type === 'bodydragend');
        expect(events.at(-1)!.detail).to.include({
          reason: 'released',
          by: 'mouse',
          mode: 'spring',
        });
        expect(element.matches(':state(dragging)')).to.be.false;
        expect(camera(x3d)).to.equal(seen);
        const falls = numbers.length > 0;
        if (falls) await until(() => far(middle(body, ...numbers), there) > 0.35);
        expect(world.problems).to.deep.equal([]);
      });

  it('those of a collection that says so are dragged, and what hangs before a body hides it', async () => {
    const { x3d, events, body } = await stage(
      of(
        `${LOOK}<x3d-cloth id="b" size="2 2" subdivision="8 8" fixedIndex="72 80"></x3d-cloth>`,
        `${collection('draggable-body')}<transform translation="0 0 -2">${box('t')}<x3d-rigid-body fixed id="a"></x3d-rigid-body></transform>`,
      ),
    );
    await dragTo(x3d, [0, -0.3, 0], [0.5, -0.3, 0]);
    expect(names(events)).to.deep.equal(['bodydragstart', 'bodydrag']);
    expect((body as any).draggable).to.be.true;
  });

  it('a rope that nobody may drag hides what is behind it, and is not dragged', async () => {
    const { x3d, events } = await stage(
      of(
        `${LOOK}<x3d-rope id="b" points="0 1 0 0 -1 0" radius="0.1" fixedIndex="0"></x3d-rope>`,
        `${collection('gravity="0 0 0"')}<transform translation="0 0 -2">${box('t')}<x3d-rigid-body draggable-body id="a"></x3d-rigid-body></transform>`,
      ),
    );
    const seen: Event[] = [];
    x3d.addEventListener('bodydragstart', (event) => seen.push(event));
    await dragTo(x3d, [0, 0, 0], [0.5, 0, 0]);
    expect([...seen, ...events]).to.deep.equal([]);
  });

  it('by keys: Enter takes hold, arrows move it', async () => {
    const { x3d, events, body } = await stage(of(cube(), collection('gravity="0 0 0"')));
    const box = x3d.querySelector('.x3d-physics-handles')!;
    const button = box.shadowRoot!.querySelector('button')!;
    button.focus();
    await sendKeys({ press: 'Enter' });
    for (let i = 0; i < 8; i++) await sendKeys({ press: 'ArrowRight' });
    await until(() => middle(body)[0]! > 0.5);
    await sendKeys({ press: 'Enter' });
    expect(names(events)).to.deep.equal(['bodydragstart', 'bodydrag', 'bodydragend']);
    expect(button.getAttribute('aria-label')).to.equal('b');
  });

  it('a script takes hold of it, too', async () => {
    const { element, body } = await stage(of(cloth(), collection('')));
    const drag = (element as any).drag([0.5, -0.5, 0]);
    drag.move([0.5, 0.5, 1]);
    await until(() => far(drag.point, [0.5, 0.5, 1]) < 0.1);
    expect(far(middle(body, 24), [0.5, 0.5, 1])).to.be.below(0.5);
    drag.end();
    expect(drag.held).to.be.false;
  });
});
