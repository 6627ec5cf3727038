import { expect } from 'chai';
import { dragTo } from '../outward/dragging/scenes.js';
import { draggable, mouse } from '../outward/dragging/hand.js';
import { place, show, until, wait } from '../../scene.js';
import { worldOf, type World } from '../../inside.js';

interface X3D extends HTMLElement {
  runtime: { canvas: { doc: { needRender: unknown } } };
}

interface Drawn extends Element {
  _x3domNode: { invalidateVolume(): void };
}

const box = (size: string) => `<shape><box size="${size}"></box></shape>`;

const floor = `<transform id="floor">${box('9 1 9')}<x3d-rigid-body fixed="true"></x3d-rigid-body></transform>`;

/** A box of 1 m on a floor, before a camera. */
const SCENE = `<navigationinfo transitiontime="0"></navigationinfo><viewpoint position="0 1 10" orientation="0 1 0 0"></viewpoint>
  <x3d-rigid-body-collection id="c" default draggable-body></x3d-rigid-body-collection>${floor}
  <transform id="t" translation="0 1 0">${box('1 1 1')}<x3d-rigid-body id="stone" def="stone"></x3d-rigid-body></transform>
  <PositionInterpolator def="way" key="0 1" keyValue="0 0 0 0 4 0"></PositionInterpolator>
  <ROUTE fromNode="way" fromField="value_changed" toNode="stone" toField="set_linearVelocity"></ROUTE>`;

/** Everything in it asleep, after the library's two seconds, and drawn. */
async function atRest(content = SCENE, selector = '#stone') {
  const { x3d, world } = await show(content, selector);
  world.advance(6);
  await until(() => world.stats.awake === 0 && !world.stepping.needsFrame);
  await wait(100);
  return { x3d: x3d as X3D, world };
}

/** What a page at rest is to be spared, counted until `stop`. x3dom has a loop of its own, which took the browser's function before. */
function count(x3d: X3D, world: World) {
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

const NOTHING = { frames: 0, drawn: 0, written: 0, steps: 0, attributes: 0 };

const stone = (x3d: Element): any => x3d.querySelector('#stone');

/** What has a world at rest go on. */
const CAUSES: Record<string, (x3d: Element, world: World) => unknown> = {
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

afterEach(() => mouse.up());

describe('a world in which everything is asleep', () => {
  it('takes no step, asks for no frame, writes nothing and has nothing drawn', async () => {
    const { x3d, world } = await atRest();
    const stop = count(x3d, world);
    const { time } = world;
    await wait(500);
    expect(stop()).to.deep.equal(NOTHING);
    expect(world.time).to.equal(time);
  });

  it('leaves nothing of x3dom that turns unseen and has the browser draw the page for ever', async () => {
    await atRest();
    const turning = document.getAnimations().filter(({ playState }) => playState === 'running');
    expect(turning.map(({ effect }) => (effect as KeyframeEffect).target?.className)).to.deep.equal(
      [],
    );
  });

  it('is at rest beside one that moves', async () => {
    const { x3d, world } = await atRest(
      SCENE.replace('default', '') +
        `<x3d-rigid-body-collection id="busy"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>`,
    );
    const busy = worldOf(x3d.querySelector('#busy')!)!;
    let told = 0;
    world.on('beforestep', () => told++);
    const stop = count(x3d, world);
    const [time, from] = [world.time, busy.time];
    await until(() => busy.time > from + 0.3);
    // That one has the page's frames, and no Transform that it moves.
    expect({ ...stop(), frames: 0, drawn: 0 }).to.deep.equal(NOTHING);
    expect([world.time, told]).to.eql([time, 0]);
  });

  for (const [cause, act] of Object.entries(CAUSES))
    it(`goes on without a jump in time after ${cause}`, async () => {
      const { x3d, world } = await atRest();
      const still = performance.now();
      await wait(300);
      const stood = cause === 'reset()' ? 0 : world.time;
      const from = performance.now();
      await act(x3d, world);
      await until(() => world.time > stood);
      // A frame: some browsers round their clocks. It had stood for 0.3 s.
      expect(world.time - stood).to.be.at.most((performance.now() - from) / 1000 + 1 / 60);
      expect(from - still).to.be.above(290);
      await until(() => world.time > stood + 0.1);
    });

  it('goes on when something that moves touches it, and wakes what is touched', async () => {
    const { x3d, world } = await atRest();
    const woken: number[] = [];
    stone(x3d).addEventListener('wake', () => woken.push(world.time));
    CAUSES['a new body']!(x3d, world);
    expect(stone(x3d).sleeping).to.equal(true);
    await until(() => woken.length > 0);
    expect(stone(x3d).sleeping).to.equal(false);
  });

  it('is drawn anew where an edit of it changes what is to be seen, and moves no further', async () => {
    const { x3d, world } = await atRest(
      `<x3d-rigid-body-collection default></x3d-rigid-body-collection>${floor}`,
      '#c, x3d-rigid-body',
    );
    const stop = count(x3d, world);
    (x3d.querySelector('x3d-rigid-body') as any).teleport([0, 3, 0]);
    await wait(300);
    const counts = stop();
    expect(counts.written).to.be.within(1, 3);
    expect(counts.drawn).to.be.within(1, 3);
    expect(world.stepping.needsFrame).to.equal(false);
  });
});

describe('what nobody sees', () => {
  it('runs on with run-hidden, and is drawn when it comes into view', async () => {
    const x3d = place(
      `<x3d-rigid-body-collection default run-hidden></x3d-rigid-body-collection>
       <transform>${box('1 1 1')}<x3d-rigid-body></x3d-rigid-body></transform>`,
    ) as X3D;
    const world = worldOf(x3d.querySelector('x3d-rigid-body')!)!;
    await world.ready;
    x3d.style.cssText = 'position: absolute; left: -5000px';
    await wait(300);
    const stop = count(x3d, world);
    await until(() => world.stepsTaken > 60);
    await wait(100);
    expect(stop().drawn).to.equal(0);
    const again = count(x3d, world);
    x3d.style.cssText = '';
    await wait(200);
    expect(again().drawn).to.be.above(0);
  });
});
