import type { World } from '../../../../../physics-core/inside.js';
import assert from 'node:assert/strict';
import { chain } from '../../../../core/effects/drag/scenes.js';
import {
  above,
  addBody,
  addFloor,
  below,
  box,
  claim,
  close,
  counts,
  fact,
  position,
  velocity,
  world,
  type Body,
  type Vec3,
  WEIGHTLESS,
} from '../../../../core/helpers.js';

// ---- the other modes ---------------------------------------------------------------------------------------------------

fact(
  'a kinematic drag carries the body past all forces, pushes others, and throws it',
  async () => {
    const w = await world({ dragMode: 'kinematic', gravity: [0, -9.8, 0] });
    const hammer = addBody(w, { mass: 1, position: [0, 5, 0] });
    const block = addBody(w, { mass: 50, position: [2, 5, 0], useGlobalGravity: false });
    const drag = hammer.drag([0, 5, 0])!;
    for (let i = 1; i <= 60; i++) {
      drag.move([i / 40, 5, 0]);
      w.step(2);
      close(position(hammer), [i / 40, 5, 0], 1e-6, 'carried');
    }
    above(position(block)[0], 2.3, 'pushed to');
    drag.end();
    close(velocity(hammer), [1.5, 0, 0], 0.05, 'thrown');
    w.step(60);
    below(position(hammer)[1], 4.5, 'falls');
  },
);

fact('a teleport sets the body down at rest, and holds it there', async () => {
  const w = await world({ dragMode: 'teleport' });
  const body = addBody(w, { linearVelocity: [3, 0, 0] });
  w.step();
  const drag = body.drag(position(body))!;
  drag.move([0, 4, 0]);
  w.step(60);
  close(position(body), [0, 4, 0], 0.03, 'held');
  drag.end();
  close(velocity(body), [0, 0, 0], 1e-9, 'let go');
});

for (const dragMode of ['kinematic', 'teleport']) {
  fact(`what was held still in a ${dragMode} drag falls when it is let go`, async () => {
    const w = await world({ dragMode });
    const body = addBody(w, { position: [0, 5, 0] });
    const drag = body.drag([0, 5, 0])!;
    drag.move([0, 6, 0]);
    w.advance(1);
    close(position(body), [0, 6, 0], 1e-6, 'm, held');
    drag.end();
    w.advance(1);
    close(position(body)[1], 6 - 9.8 / 2, 1e-3, 'm, fallen');
  });

  fact(`what a ${dragMode} drag puts on a floor stands on it`, async () => {
    const w = await world({ dragMode });
    w.add('CollisionCollection', { collidables: '*', bounce: 0, frictionCoefficients: [0.5, 0.5] });
    addFloor(w);
    const body = addBody(w, { position: [0, 5, 0], geometry: [box(1)] });
    const drag = body.drag([0, 5, 0])!;
    drag.move([0, 0.5, 0]);
    w.advance(0.5);
    drag.end();
    w.advance(1);
    close(position(body), [0, 0.5, 0], 2e-3, 'm');
  });

  fact(
    `a joint that comes while a ${dragMode} drag lasts does not stop what it holds`,
    async () => {
      const w = await world({ dragMode });
      const [body, other] = [0, 0.9].map((x) =>
        addBody(w, { position: [x, 5, 0], geometry: [box(1)], useGlobalGravity: x === 0 }),
      ) as [Body, Body];
      const drag = body.drag([0, 5, 0])!;
      w.advance(0.2);
      claim(w, 'initial-overlap');
      const joint = w.add('BallJoint', { body1: body, body2: other, anchorPoint: [0.45, 5, 0] });
      w.advance(0.2);
      joint.remove();
      other.remove();
      drag.end();
      w.advance(0.5);
      above(5 - position(body)[1], 1.1, 'm, fallen');
    },
  );
}

for (const dragMode of ['kinematic', 'teleport'])
  fact(`what joints hold follows a body in a ${dragMode} drag`, async () => {
    const { w, links, gap } = await chain(2);
    w.set('dragMode', dragMode);
    w.step();
    const body = links[7]!;
    const drag = body.drag(position(body))!;
    for (let i = 1; i <= 60; i++) {
      drag.move([i / 60, -8 + i / 20, 0]);
      w.step(2);
    }
    w.advance(1);
    close(position(body), [1, -5, 0], 1e-5, 'held');
    below(gap(), 0.001, 'gap');
    drag.end();
    w.advance(1);
    below(gap(), 0.001, 'gap');
  });

for (const [dragMode, ends] of [
  ['spring', [1, 0, 0]],
  ['kinematic', [0, 0, 0]],
  ['teleport', [0, 0, 0]],
] as [string, Vec3][])
  fact(
    `a cancelled ${dragMode} drag leaves the body ${ends[0] ? 'where it is' : 'where it was grabbed'}`,
    async () => {
      const w = await world({ ...WEIGHTLESS, dragMode });
      const body = addBody(w);
      const reasons: string[] = [];
      const drag = body.drag([0, 0, 0], (reason) => reasons.push(reason))!;
      drag.move([1, 0, 0]);
      w.step(120);
      drag.cancel();
      w.step(10);
      close(position(body), ends, 0.001, 'left');
      close(velocity(body), [0, 0, 0], 0.001, 'at rest');
      assert.deepEqual(reasons, ['cancelled']);
    },
  );

// ---- what a drag is not ------------------------------------------------------------------------------------------------

for (const dragMode of ['spring', 'kinematic', 'teleport'])
  fact(`makes and unmakes nothing: ${dragMode}`, async () => {
    const { w, links } = await chain(2);
    w.set('dragMode', dragMode);
    w.step(10);
    const [body] = links.slice(-1) as [Body];
    const joints = [...body.joints];
    const known = () => ({
      ...counts(w),
      joints: w.stats.joints,
      bodies: w.stats.bodies,
      constraints: joints.map((joint) => joint.constraint),
      pointer: body.pointer,
      heap: w.stats.heapBytes,
    });
    const before = known();
    const drag = body.drag(position(body))!;
    for (let i = 0; i < 60; i++) {
      drag.move([i / 30, -8 + i / 30, 0]);
      w.step();
    }
    assert.deepEqual(known(), before);
    assert.equal(w.effects.find(({ name }) => name === 'dragging')!.active, true);
    drag.end();
    w.step(60);
    assert.deepEqual(known(), before);
    assert.equal(w.effects.find(({ name }) => name === 'dragging')!.active, false);
  });

fact('what was asleep wakes and stays awake while it is held, even at rest', async () => {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  const crate = addBody(w, { geometry: [box(1)], position: [0, 0.5, 0] });
  w.advance(4);
  assert.ok(crate.sleeping);
  const drag = crate.drag([0, 1, 0])!;
  w.advance(4);
  assert.ok(!crate.sleeping);
  drag.end();
  w.advance(4);
  assert.ok(crate.sleeping);
});

fact('a carried body meets what sleeps', async () => {
  const w = await world({ rest: 'auto', dragMode: 'kinematic' });
  addFloor(w);
  const pusher = addBody(w, { geometry: [box(1)], position: [0, 0.5, 0] });
  const sleeper = addBody(w, { geometry: [box(1)], position: [3, 0.5, 0] });
  w.advance(4);
  assert.ok(pusher.sleeping && sleeper.sleeping);
  const drag = pusher.drag([0, 0.5, 0])!;
  for (let i = 1; i <= 180; i++) {
    drag.move([i / 60, 0.5, 0]);
    w.frame(1 / 60);
  }
  above(position(sleeper)[0], 3.8, 'pushed to');
});

for (const [what, act, reason] of [
  ['it is removed', (body: Body) => body.remove(), 'removed'],
  ['it is disabled', (body: Body) => body.set('enabled', false), 'disabled'],
  ['it is fixed', (body: Body) => body.set('fixed', true), 'disabled'],
  ['the world starts again', (body: Body) => (body.world as World).reset(), 'reset'],
  [
    'a snapshot is restored',
    (body: Body) => (body.world as World).restore((body.world as World).snapshot()),
    'reset',
  ],
] as [string, (body: Body) => void, string][])
  for (const dragMode of ['spring', 'teleport'])
    fact(`a ${dragMode} drag is over once ${what}`, async () => {
      const w = await world({ ...WEIGHTLESS, draggableBody: true, dragMode });
      const body = addBody(w);
      addBody(w, { position: [0, 3, 0], linearVelocity: [1, 0, 0] });
      const reasons: string[] = [];
      const drag = body.drag([0, 0, 0], (why) => reasons.push(why))!;
      drag.move([0.1, 0, 0]);
      w.step(2);
      act(body);
      w.step(2);
      assert.deepEqual(reasons, [reason]);
      assert.ok(!drag.held);
      drag.move([1, 0, 0]);
      drag.end();
      drag.cancel();
      assert.deepEqual(reasons, [reason]);
      if (!body.removed) body.set('fixed', false);
      if (!body.removed) body.set('enabled', true);
      if (!body.removed) body.set('linearVelocity', [2, 0, 0]);
      w.step(30);
      if (!body.removed) above(position(body)[0], 0.3, 'moves again');
    });

fact('the same hands at the same times give the same bits', async () => {
  const run = async (): Promise<Vec3[]> => {
    const { w, links } = await chain(2);
    const drag = links[5]!.drag(position(links[5]!))!;
    for (let i = 0; i < 90; i++) {
      drag.move([i / 45, -5 + i / 60, Math.sin(i / 9)]);
      w.step();
    }
    return links.map(position);
  };
  assert.deepEqual(await run(), await run());
});

// ---- who may be dragged ------------------------------------------------------------------------------------------------

fact('a body says for itself, else its collection does for those that move', async () => {
  const w = await world({ draggableBody: true });
  const floor = addFloor(w);
  const free = addBody(w, { position: [0, 2, 0] });
  const shy = addBody(w, { position: [0, 4, 0], draggableBody: false });
  w.step();
  assert.deepEqual(
    [floor, free, shy].map((body) => body.draggable),
    [false, true, false],
  );
  floor.set('dragMode', 'kinematic');
  w.step();
  assert.equal(floor.draggable, false);
  floor.set('draggableBody', true);
  w.step();
  assert.equal(floor.draggable, true);
});

fact('a fixed body that is to be dragged by a spring is reported, until it is not', async () => {
  const w = await world();
  const floor = addFloor(w, 0, { draggableBody: true });
  w.step();
  claim(w, 'not-draggable');
  assert.equal(w.problems.length, 1);
  assert.equal(floor.drag([0, 0, 0]), undefined);
  floor.set('dragMode', 'teleport');
  w.step();
  assert.equal(w.problems.length, 0);
  floor.drag([0, 0, 0])!.move([0, 1, 0]);
  close(position(floor), [0, 0.5, 0], 1e-6, 'set down at');
});

fact('a point that is none is reported, and nothing is held', async () => {
  const w = await world();
  const body = addBody(w);
  claim(w, 'bad-value');
  assert.equal(body.drag([0, NaN, 0]), undefined);
});
