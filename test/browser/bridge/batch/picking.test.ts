import { expect } from 'chai';
import '../../console.js';
import { bodies, colored, drawPlainly, picture, showBatched } from './pictures.js';

const heap = bodies(60, (i) => `${colored(i)}<box size="1.2 1.2 1.2"></box>`);

interface Area {
  _pickingInfo: {
    pickObj: { _xmlNode: Element | null } | null;
    pickPos: { toString(): string } | null;
    pickNorm: { toString(): string } | null;
  };
}

/** The element that x3dom finds under a point of the picture, where on it and with which normal. */
function found(x3d: Element, x: number, y: number): string[] {
  const { doc } = (
    x3d as unknown as {
      runtime: {
        canvas: {
          doc: {
            ctx: { pickValue(area: Area, x: number, y: number, button: number): boolean };
            _viewarea: Area;
          };
        };
      };
    }
  ).runtime.canvas;
  if (!doc.ctx.pickValue(doc._viewarea, x, y, 1)) return [''];
  const { pickObj, pickPos, pickNorm } = doc._viewarea._pickingInfo;
  const id = pickObj?._xmlNode?.id;
  // Where there is nothing the last answer is left.
  return id ? [id, String(pickPos), String(pickNorm)] : [''];
}

const picked = (x3d: Element, x: number, y: number): string => found(x3d, x, y)[0]!;

/** From 0 to 1, the same in every run. */
function* numbers(seed: number): Generator<number, never> {
  for (let state = seed; ;) {
    state = (state * 16807) % 2147483647;
    yield state / 2147483647;
  }
}

describe('bodies drawn in one call', () => {
  it('are found by x3dom each under its own points, in the same place and with the same normal: 200 at random', async () => {
    const { x3d, collection } = await showBatched(heap, 1);
    const random = numbers(7);
    const points = Array.from({ length: 200 }, () => [
      Math.floor(random.next().value * 300),
      Math.floor(random.next().value * 200),
    ]);
    const pickAll = () => points.map(([x, y]) => found(x3d, x!, y!));
    picture(x3d);
    const together = pickAll();
    await drawPlainly(collection, true);
    picture(x3d);
    const byThemselves = pickAll();
    expect(new Set(together.map(([id]) => id)).size).to.be.above(20);
    expect(together).to.eql(byThemselves);
  });

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
