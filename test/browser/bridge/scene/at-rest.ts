import { dragTo } from '../outward/dragging/scenes.js';
import { draggable } from '../outward/dragging/hand.js';
import { drawn, show, until, wait } from '../../scene.js';
import { type World } from '../../inside.js';

export interface X3D extends HTMLElement {
  runtime: { canvas: { doc: { needRender: unknown } } };
}

interface Drawn extends Element {
  _x3domNode: { invalidateVolume(): void };
}

export const box = (size: string) => `<shape><box size="${size}"></box></shape>`;

export const floor = `<transform id="floor">${box('9 1 9')}<x3d-rigid-body fixed="true"></x3d-rigid-body></transform>`;

/** A box of 1 m on a floor, before a camera. */
export const SCENE = `<navigationinfo transitiontime="0"></navigationinfo><viewpoint position="0 1 10" orientation="0 1 0 0"></viewpoint>
  <x3d-rigid-body-collection id="c" default draggable-body></x3d-rigid-body-collection>${floor}
  <transform id="t" translation="0 1 0">${box('1 1 1')}<x3d-rigid-body id="stone" def="stone"></x3d-rigid-body></transform>
  <PositionInterpolator def="way" key="0 1" keyValue="0 0 0 0 4 0"></PositionInterpolator>
  <ROUTE fromNode="way" fromField="value_changed" toNode="stone" toField="set_linearVelocity"></ROUTE>`;

/** Everything in it asleep, after the library's two seconds, and drawn. */
export async function atRest(content = SCENE, selector = '#stone') {
  const { x3d, world } = await show(content, selector);
  world.advance(6);
  await until(() => world.stats.awake === 0 && !world.stepping.needsFrame);
  // However long the frame takes that draws it last.
  await drawn();
  await wait(100);
  return { x3d: x3d as X3D, world };
}

/** What a page at rest is to be spared, counted until `stop`. x3dom has a loop of its own, which took the browser's function before. */
export function count(x3d: X3D, world: World) {
  const { doc } = x3d.runtime.canvas;
  const counts = { frames: 0, drawn: 0, written: 0, steps: 0, attributes: 0 };
  const stops: (() => void)[] = [];
  const instead = (object: object, name: string, value: PropertyDescriptor): void => {
    const own = Object.getOwnPropertyDescriptor(object, name);
    Object.defineProperty(object, name, { configurable: true, ...value });
    stops.push(() => {
      if (own) Object.defineProperty(object, name, own);
      else delete (object as Record<string, unknown>)[name];
    });
  };
  const { requestAnimationFrame } = window;
  instead(window, 'requestAnimationFrame', {
    value: (callback: FrameRequestCallback) => {
      counts.frames++;
      return requestAnimationFrame.call(window, callback);
    },
  });
  let { needRender } = doc;
  instead(doc, 'needRender', {
    get: () => needRender,
    set: (value: unknown) => {
      if (value && !needRender) counts.drawn++;
      needRender = value;
    },
  });
  for (const transform of x3d.querySelectorAll<Drawn>('transform')) {
    const node = transform._x3domNode;
    const invalidate = node.invalidateVolume.bind(node);
    instead(node, 'invalidateVolume', {
      value: () => {
        counts.written++;
        invalidate();
      },
    });
  }
  const observer = new MutationObserver((records) => (counts.attributes += records.length));
  observer.observe(x3d, { subtree: true, attributes: true });
  const before = world.stepsTaken;
  return () => {
    counts.steps = world.stepsTaken - before;
    observer.disconnect();
    for (const stop of stops) stop();
    return counts;
  };
}

export const NOTHING = { frames: 0, drawn: 0, written: 0, steps: 0, attributes: 0 };

export const stone = (x3d: Element): any => x3d.querySelector('#stone');

/** What has a world at rest go on. */
export const CAUSES: Record<string, (x3d: Element, world: World) => unknown> = {
  'an edit': (x3d) => stone(x3d).setAttribute('linearvelocity', '0 2 0'),
  'an edit of a Transform that a body moves': (x3d) =>
    x3d.querySelector('#t')!.setAttribute('translation', '0 3 0'),
  'a ROUTE': (x3d) => (x3d.querySelector('[def=way]') as any).setFieldValue('set_fraction', 0.5),
  'a push': (x3d) => stone(x3d).applyImpulse([0, 2, 0]),
  'wake()': (x3d) => stone(x3d).wake(),
  'what it stood on gone': (x3d) => x3d.querySelector('#floor')!.remove(),
  'a floor that moves': (x3d) =>
    x3d.querySelector('#floor')!.setAttribute('translation', '0 0.1 0'),
  'a new body': (x3d) =>
    x3d
      .querySelector('scene')!
      .insertAdjacentHTML(
        'beforeend',
        `<transform translation="0 2 0">${box('1 1 1')}<x3d-rigid-body></x3d-rigid-body></transform>`,
      ),
  'reset()': (_, world) => world.reset(),
  'a drag': async (x3d) => {
    await draggable(x3d);
    await dragTo(x3d, [0, 1, 0.5], [1, 2, 0.5]);
  },
};
