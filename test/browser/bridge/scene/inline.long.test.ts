import { expect } from 'chai';
import { claim } from '../../console.js';
import { nextFrame, place, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';

const ball = `<transform id="t" translation="0 3 0"><shape><sphere></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`;

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

  it('that is missing holds nothing up for long, and is told', async () => {
    claim('inline-load-failed');
    const { world } = await show(
      `<inline url="/nowhere.x3d"></inline><RigidBodyCollection><RigidBody></RigidBody></RigidBodyCollection>`,
    );
    expect(world.stats.bodies).to.equal(1);
    await until(() => world.problems.length > 0);
    expect(world.problems.map(({ code }) => code)).to.eql(['inline-load-failed']);
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
