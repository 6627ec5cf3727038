import { expect } from 'chai';
import { claim } from '../console.js';
import { drawn, drawnAt, nextFrame, place, show, until, wait } from './scene.js';
import { worldOf } from '../inside.js';

const ball = `<transform id="t" translation="0 3 0"><shape><sphere></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`;

describe('an x3d', () => {
  it('moved within one task goes on with its world, and is drawn again', async () => {
    const { x3d, world } = await show(ball, '#ball');
    world.paused = true;
    world.advance(1);
    const y = (world.node('ball')!.get('position') as number[])[1];
    const box = document.createElement('div');
    document.body.append(box);
    box.append(x3d);
    const transform = x3d.querySelector('#t')!;
    // x3dom lets go of it at once and reads it anew, on a slow machine later.
    await nextFrame();
    await until(() => '_x3domNode' in transform && Math.abs(drawnAt(transform)[1]! - y!) < 1e-5);
    expect(worldOf(x3d.querySelector('#ball')!)).to.equal(world);
    expect((world.node('ball')!.get('position') as number[])[1]).to.equal(y);
    expect(x3d.querySelectorAll('canvas').length).to.equal(1);
    x3d.querySelector('#ball')!.setAttribute('mass', '4');
    world.step(0);
    expect(world.node('ball')!.get('mass')).to.equal(4);
  });

  it('may be removed and put back again and again', async () => {
    const { x3d } = await show(ball, '#ball');
    for (let i = 0; i < 3; i++) {
      x3d.remove();
      await wait(20);
      document.body.append(x3d);
      const world = worldOf(x3d.querySelector('#ball')!)!;
      await world.ready;
      await wait(30);
      world.paused = true;
      world.reset();
      expect(world.node('ball')!.get('position')).to.eql([0, 3, 0]);
      world.advance(0.5);
      await drawn();
      expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.closeTo(3 - 4.9 * 0.25, 0.05);
    }
    expect(x3d.querySelectorAll('canvas').length).to.equal(1);
  });

  it('whose WebGL context the browser took away can still be removed, and put back', async () => {
    const { x3d } = await show(ball, '#ball');
    await drawn();
    const canvas = x3d.querySelector('canvas')!;
    const context = (canvas.getContext('webgl2') ?? canvas.getContext('webgl'))!;
    (context.getExtension('WEBGL_lose_context') as WEBGL_lose_context).loseContext();
    await until(() => context.isContextLost());
    x3d.remove();
    await wait(20);
    document.body.append(x3d);
    await worldOf(x3d.querySelector('#ball')!)!.ready;
    await drawn();
    expect(x3d.querySelectorAll('canvas').length).to.equal(1);
    x3d.remove();
    await wait(20);
  });

  it('has worlds of its own beside another', async () => {
    document.body.innerHTML = `<x3d id="a" width="100px" height="100px"><scene>${ball}</scene></x3d><x3d id="b" width="100px" height="100px"><scene>${ball}</scene></x3d>`;
    const [a, b] = ['#a', '#b'].map((id) => worldOf(document.querySelector(`${id} #ball`)!)!);
    expect(a).not.to.equal(b);
    await Promise.all([a.ready, b.ready]);
    expect([a.stats.bodies, b.stats.bodies]).to.eql([1, 1]);
  });

  it('built node by node, as a framework does, starts', async () => {
    document.body.innerHTML = '';
    const x3d = document.createElement('x3d');
    document.body.append(x3d);
    await wait(30);
    const scene = document.createElement('scene');
    x3d.append(scene);
    await wait(30);
    const collection = document.createElement('x3d-rigid-body-collection');
    scene.append(collection);
    await wait(30);
    collection.innerHTML = '<x3d-rigid-body id="b" position="0 2 0"></x3d-rigid-body>';
    const world = worldOf(collection)!;
    await world.ready;
    world.step(0);
    expect(world.stats.bodies).to.equal(1);
  });

  it('scrolled away stands still and goes on without a jump, unless run-hidden', async () => {
    const x3d = place(`
      <x3d-rigid-body-collection id="still"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>
      <x3d-rigid-body-collection id="runs" run-hidden><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>`);
    const [still, runs] = ['#still', '#runs'].map((id) => worldOf(x3d.querySelector(id)!)!);
    await Promise.all([still.ready, runs.ready]);
    x3d.style.cssText = 'position: absolute; left: -5000px';
    await wait(500);
    const [stood, ran] = [still.time, runs.time];
    await until(() => runs.time > ran + 0.5);
    expect(still.time).to.equal(stood);
    x3d.style.cssText = '';
    const back = performance.now();
    await until(() => still.time > stood);
    // What it was away for, half a second and more, is not caught up.
    expect(still.time - stood).to.be.below((performance.now() - back) / 1000 + 0.1);
  });

  it('in a hidden page stands still, unless run-hidden', async () => {
    const x3d = place(`
      <x3d-rigid-body-collection id="still"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>
      <x3d-rigid-body-collection id="runs" run-hidden><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection>`);
    const [still, runs] = ['#still', '#runs'].map((id) => worldOf(x3d.querySelector(id)!)!);
    await Promise.all([still.ready, runs.ready]);
    const hide = (hidden: boolean): void => {
      Object.defineProperty(document, 'hidden', { configurable: true, value: hidden });
      document.dispatchEvent(new Event('visibilitychange'));
    };
    hide(true);
    try {
      await nextFrame();
      const [stood, ran] = [still.time, runs.time];
      await until(() => runs.time > ran + 1, 10_000);
      expect(still.time).to.equal(stood);
      hide(false);
      const back = performance.now();
      await until(() => still.time > stood);
      expect(still.time - stood).to.be.below((performance.now() - back) / 1000 + 0.1);
    } finally {
      delete (document as { hidden?: boolean }).hidden;
    }
  });
});

describe('x3dom', () => {
  it('draws a USE that stands before its DEF', async () => {
    const { x3d } = await show(`
      <CollidableShape id="use" USE="late"></CollidableShape>
      <RigidBodyCollection><RigidBody DEF="b"><CollidableShape DEF="late"><Shape><Sphere></Sphere></Shape></CollidableShape></RigidBody></RigidBodyCollection>`);
    const node = (
      x3d.querySelector('[def=late]') as unknown as { _x3domNode: { _parentNodes: unknown[] } }
    )._x3domNode;
    expect(node._parentNodes.length).to.equal(1);
  });

  it('is not needed for the simulation to run from elements in the scene only', async () => {
    const { x3d, world } = await show(
      `<RigidBodyCollection><RigidBody DEF="b"></RigidBody></RigidBodyCollection>`,
    );
    expect(world.stats.bodies).to.equal(1);
    expect(getComputedStyle(x3d.querySelector('scene')!).display).to.equal('none');
  });

  it('a prototype holds bodies', async () => {
    const { x3d } = await show(
      `
      <ProtoDeclare name="Ball"><ProtoInterface><field name="at" type="SFVec3f" dataType="SFVec3f" accessType="initializeOnly" value="0 0 0"></field></ProtoInterface>
        <ProtoBody><RigidBodyCollection DEF="pc"><RigidBody DEF="pb" position="0 4 0"></RigidBody></RigidBodyCollection></ProtoBody></ProtoDeclare>
      <ProtoInstance name="Ball" DEF="one"></ProtoInstance>
      <x3d-rigid-body id="own"></x3d-rigid-body>`,
      '#own',
    );
    await wait(100);
    const instance = x3d.querySelector('ball');
    expect(instance).not.to.equal(null);
    const body = (
      instance as unknown as { _x3domNode: { protoBodyClone: Element } }
    )._x3domNode.protoBodyClone.querySelector('[def=pb]')!;
    const world = worldOf(body)!;
    await world.ready;
    expect(world.node(body)!.get('position')).to.have.property('1').closeTo(4, 0.5);
    expect(world.stats.bodies).to.equal(1);
  });
});

describe('an Inline', () => {
  it('exports names to joints of the page, fires events at its element, and goes with it', async () => {
    const x3d = place(`
      <RigidBodyCollection id="c" shared-world="w"><BallJoint DEF="j" anchorPoint="0.1 3 0" body1="fromInline"></BallJoint></RigidBodyCollection>
      <inline DEF="file" url="/test/pages/ball.x3d" shared-world="w"></inline>
      <import inlineDEF="file" importedDEF="theBall" AS="fromInline"></import>`);
    const events: CustomEvent[] = [];
    x3d.addEventListener('physicsready', (event) => events.push(event as CustomEvent));
    const world = worldOf(x3d.querySelector('#c')!)!;
    await world.ready;
    world.paused = true;
    expect(events.map((event) => (event.target as Element).localName)).to.eql([
      'rigidbodycollection',
      'inline',
    ]);
    expect(events[1].detail.element.localName).to.equal('RigidBodyCollection');
    expect(world.stats.joints).to.equal(1);
    expect(world.stats.bodies).to.equal(2);
    const inner = events[1].detail.element as Element;
    inner.querySelector('[DEF=ball]')!.setAttribute('mass', '7');
    world.step(0);
    expect(world.node('ball')!.get('mass')).to.equal(7);
    // x3dom itself stumbles over an Inline that goes within a second of its coming.
    await wait(1100);
    claim('waits for body1 "fromInline"');
    x3d.querySelector('inline')!.remove();
    world.step(0);
    expect([world.stats.bodies, world.stats.joints]).to.eql([0, 0]);
  });

  it('that is missing holds nothing up for long', async () => {
    const { world } = await show(
      `<inline url="/nowhere.x3d"></inline><RigidBodyCollection><RigidBody></RigidBody></RigidBodyCollection>`,
    );
    expect(world.stats.bodies).to.equal(1);
  });

  it('that never answers holds nothing up for more than ten seconds, and is reported', async () => {
    const requests = (globalThis as unknown as { x3dom: { RequestManager: object } }).x3dom
      .RequestManager as { addRequest(request: unknown): void };
    const { addRequest } = requests;
    requests.addRequest = () => {};
    try {
      claim('longer for Inline /never.x3d');
      const x3d = place(`<inline url="/never.x3d"></inline>${ball}`);
      const world = worldOf(x3d.querySelector('#ball')!)!;
      let ready = false;
      void world.ready.then(() => (ready = true));
      await wait(1000);
      expect(ready).to.equal(false);
      // Ten seconds pass.
      const now = performance.now.bind(performance);
      performance.now = () => now() + 10_000;
      try {
        await world.ready;
      } finally {
        delete (performance as { now?: unknown }).now;
      }
      expect(world.problems.map(({ code }) => code)).to.eql(['waiting-for-document']);
      world.paused = true;
      world.reset();
      world.advance(1);
      expect((world.node('ball')!.get('position') as number[])[1]).to.be.closeTo(3 - 4.9, 0.05);
    } finally {
      requests.addRequest = addRequest;
    }
  });

  it('appended later joins', async () => {
    const { x3d } = await show(`<RigidBodyCollection></RigidBodyCollection>`);
    const ready = new Promise<CustomEvent>((resolve) =>
      x3d.addEventListener('physicsready', (event) => resolve(event as CustomEvent)),
    );
    x3d
      .querySelector('scene')!
      .insertAdjacentHTML('beforeend', '<inline url="/test/pages/ball.x3d"></inline>');
    const { detail } = await ready;
    expect(worldOf(detail.element)!.stats.bodies).to.equal(2);
    await nextFrame();
  });
});

describe('many bodies', () => {
  it('appended one by one make only their own objects', async () => {
    const { x3d } = await show(ball, '#ball');
    const world = worldOf(x3d.querySelector('#ball')!)!;
    world.paused = true;
    world.step(0);
    const scene = x3d.querySelector('scene')!;
    const made: number[] = [];
    const { patched, destroyed } = world.stats;
    for (let i = 0; i < 600; i++) {
      const before = world.stats.created;
      scene.insertAdjacentHTML(
        'beforeend',
        `<transform translation="${i * 3} 9 0"><shape><box></box></shape><x3d-rigid-body></x3d-rigid-body></transform>`,
      );
      world.step(0);
      made.push(world.stats.created - before);
    }
    expect(world.stats.bodies).to.equal(601);
    expect(new Set(made).size).to.equal(1);
    expect(world.stats).to.include({ patched, destroyed });
  });

  it('with joints, added and removed 300 times, leave the world and the heap as they were', async () => {
    const { x3d, world } = await show(ball, '#ball');
    world.paused = true;
    const scene = x3d.querySelector('scene')!;
    const cycle = (i: number): void => {
      scene.insertAdjacentHTML(
        'beforeend',
        `<transform id="added" translation="1 3 ${i % 7}">
          <shape><indexedfaceset coordindex="0 2 1 -1 0 1 3 -1 0 3 2 -1 1 2 3 -1"><coordinate point="0 0 0, 1 0 0, 0 1 0, 0 0 1"></coordinate></indexedfaceset></shape>
          <x3d-rigid-body id="swinging"></x3d-rigid-body>
        </transform>
        <x3d-ball-joint id="joint" body1="ball" body2="swinging" anchorpoint="1 3 0"></x3d-ball-joint>`,
      );
      world.step(2);
      expect([world.stats.bodies, world.stats.joints]).to.eql([2, 1]);
      // Either may go first.
      if (i % 2) x3d.querySelector('#joint')!.remove();
      x3d.querySelector('#added')!.remove();
      x3d.querySelector('#joint')?.remove();
      world.step(0);
      expect([world.stats.bodies, world.stats.joints]).to.eql([1, 0]);
    };
    const cycles = async (count: number): Promise<void> => {
      for (let i = 0; i < count; i++) cycle(i);
      await nextFrame();
    };
    // A block taken for good: where nothing leaks, those before and after the cycles lie as far apart as two at once.
    const heap = world.engine.ammo as unknown as { _malloc(bytes: number): number };
    const take = (): number => heap._malloc(65536);
    // The first rounds fill holes.
    for (let i = 0; i < 3; i++) {
      await cycles(100);
      take();
    }
    const [first, second] = [take(), take()];
    await cycles(100);
    take();
    const size = [[...world.nodes].length, world.stats.heapBytes];
    const before = take();
    await cycles(300);
    expect(take() - before).to.equal(second! - first!);
    expect([[...world.nodes].length, world.stats.heapBytes]).to.eql(size);
  });
});
