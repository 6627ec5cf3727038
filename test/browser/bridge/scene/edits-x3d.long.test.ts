import { expect } from 'chai';
import { worldOf } from '../../../../elements/index.js';
import { drawn, drawnAt, show, until, wait } from '../../scene.js';

const ball = `<transform id="t" translation="0 3 0"><shape><sphere></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`;

/** It starts from its markup, falls, is drawn where it falls, on one canvas. */
async function works(x3d: Element, height = 3): Promise<void> {
  const world = worldOf(x3d.querySelector('#ball')!)!;
  await world.ready;
  world.paused = true;
  world.reset();
  expect(world.node('ball')!.get('position')).to.eql([0, height, 0]);
  world.advance(0.5);
  const transform = x3d.querySelector('#t')!;
  const y = height - 4.9 * 0.25;
  await until(() => '_x3domNode' in transform && Math.abs(drawnAt(transform)[1]! - y) < 0.05);
  expect(world.stats.bodies).to.equal(1);
  expect(x3d.querySelectorAll('canvas').length).to.equal(1);
  expect(document.querySelectorAll('x3d').length).to.equal(1);
  const { runtime } = x3d as unknown as { runtime?: { canvas: { canvas: HTMLCanvasElement } } };
  expect(runtime!.canvas.canvas).to.equal(x3d.querySelector('canvas'));
}

describe('a whole x3d', () => {
  it('kept by a router that shows another page meanwhile works again, with what was edited in it', async () => {
    const { x3d } = await show(ball, '#ball');
    const kept = document.createDocumentFragment();
    for (let i = 0; i < 3; i++) {
      kept.append(x3d);
      document.body.innerHTML = '<p>another page</p>';
      await wait(20);
      x3d.querySelector('#t')!.setAttribute('translation', `0 ${4 + i} 0`);
      document.body.innerHTML = '<main></main>';
      document.querySelector('main')!.append(x3d);
      await works(x3d, 4 + i);
    }
  });

  it('cut and pasted as text works again, on a canvas of its own', async () => {
    const { x3d } = await show(ball, '#ball');
    await drawn();
    const text = x3d.outerHTML;
    x3d.remove();
    await wait(20);
    document.body.insertAdjacentHTML('beforeend', text);
    await works(document.querySelector('x3d')!);
  });

  it('edited as HTML, with its text put in its place in one task, works again', async () => {
    const { x3d } = await show(ball, '#ball');
    await drawn();
    x3d.outerHTML = x3d.outerHTML.replace('0 3 0', '0 6 0');
    await works(document.querySelector('x3d')!, 6);
  });

  it('cloned beside itself works beside it', async () => {
    const { x3d, world } = await show(ball, '#ball');
    world.paused = true;
    await drawn();
    const clone = x3d.cloneNode(true) as Element;
    document.body.append(clone);
    const other = worldOf(clone.querySelector('#ball')!)!;
    await other.ready;
    expect(other).not.to.equal(world);
    expect([world.stats.bodies, other.stats.bodies]).to.eql([1, 1]);
    await until(() => clone.querySelectorAll('canvas').length === 1);
    expect(x3d.querySelectorAll('canvas').length).to.equal(1);
    x3d.remove();
    await works(clone);
  });
});
