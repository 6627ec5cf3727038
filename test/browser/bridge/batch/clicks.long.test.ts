import { expect } from 'chai';
import '../../console.js';
import { picture, showBatched } from './pictures.js';
import { heap, found } from './pick.js';

const picked = (x3d: Element, x: number, y: number): string => found(x3d, x, y)[0]!;

describe('bodies drawn in one call', () => {
  it('hear clicks at their own Shapes', async () => {
    const { x3d } = await showBatched(heap, 1);
    const heard: string[] = [];
    for (const shape of x3d.querySelectorAll('shape'))
      shape.addEventListener('click', () => heard.push(shape.id));
    picture(x3d);
    const canvas = x3d.querySelector('canvas')!;
    const { left, top } = canvas.getBoundingClientRect();
    const expected: string[] = [];
    for (const [x, y] of [
      [100, 60],
      [150, 100],
      [190, 130],
    ] as const) {
      const id = picked(x3d, x, y);
      if (id) expected.push(id);
      const init = { clientX: left + x, clientY: top + y, button: 0, buttons: 1, bubbles: true };
      for (const type of ['mousedown', 'mouseup']) canvas.dispatchEvent(new MouseEvent(type, init));
    }
    expect(expected.length).to.be.at.least(2);
    expect(heard).to.eql(expected);
  });

  it('that may not be picked are not', async () => {
    const { x3d } = await showBatched(heap.replaceAll('<shape', '<shape ispickable="false"'), 1);
    picture(x3d);
    expect(picked(x3d, 150, 100)).to.equal('');
  });
});
