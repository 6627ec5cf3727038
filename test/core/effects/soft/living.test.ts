import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  close,
  distance,
  fact,
  position,
  sphere,
  velocity,
  world,
  type Body,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { addRope, DOWN, line, place, places, tie } from './helpers.js';

/** Ropes that hang, fall, lie and tie bodies; what is known of all of them. */
function scene(w: World): { state: () => number[]; ropes: Node[]; bodies: Body[] } {
  addFloor(w, -2);
  const bodies = [0, 1, 2].map((i) =>
    addBody(w, {
      position: [i, 0, 0.1 * i],
      mass: 1 + i,
      geometry: [i === 1 ? box(0.2) : sphere(0.1)],
    }),
  );
  addJoint(w, 'BallJoint', { body1: bodies[2], anchorPoint: [2, 0.5, 0] });
  const between = addRope(w, line(10, 1, [0, 0, 0], [1, 0, 0]), { radius: 0.02 });
  tie(w, between, 0, { body: bodies[0] });
  tie(w, between, 10, { body: bodies[1], position: [0, 0.1, 0] });
  const held = addRope(w, line(8, 1.5, [0, 1, 0], [0.6, -0.8, 0]), {
    fixedIndex: [0],
    damping: 0.1,
  });
  tie(w, held, 8, { body: bodies[0] });
  const loose = addRope(w, line(12, 1, [-1, -1, 1], [0.8, 0, 0.6]), {
    radius: 0.05,
    bendStiffness: 0.01,
  });
  const stretches = addRope(w, line(6, 1, [2, 0, 0.2], [1, 0, 0]), { stretchStiffness: 200 });
  tie(w, stretches, 0, { body: bodies[2] });
  tie(w, stretches, 6, { position: [3.2, 0.2, 0] });
  const ropes = [between, held, loose, stretches];
  const state = (): number[] => [
    ...ropes.flatMap((rope) => places(rope).flat()),
    ...bodies.flatMap((body) => [...position(body), ...velocity(body)]),
  ];
  return { state, ropes, bodies };
}

// ---- going back --------------------------------------------------------------------------------------------------------

fact('put back to before, ropes go on to the same bits', async () => {
  const w = await world();
  const { state } = scene(w);
  for (const before of [0.1, 0.3, 0.6, 1.2]) {
    w.advance(before);
    const snapshot = w.snapshot();
    const then = state();
    w.advance(0.7);
    const first = state();
    w.restore(JSON.parse(JSON.stringify(snapshot)));
    assert.deepEqual(state(), then);
    w.advance(0.7);
    assert.deepEqual(state(), first);
  }
});

fact('after a reset all of it comes about again', async () => {
  const w = await world();
  const { state } = scene(w);
  w.advance(1);
  const first = state();
  w.reset();
  w.advance(1);
  assert.deepEqual(state(), first);
});

fact('two worlds of one scene go the same way to the last bit', async () => {
  const [one, two] = [await world(), await world()].map((w) => ({ w, ...scene(w) }));
  one!.w.advance(1.5);
  for (let i = 0; i < 180; i++) two!.w.step();
  assert.deepEqual(two!.state(), one!.state());
});

fact('what is recorded goes the way it goes without', async () => {
  const [plain, kept] = [await world(), await world()];
  const [one, two] = [plain, kept].map((w) => scene(w).state);
  await kept.record({ seconds: 10 });
  plain.step(150);
  kept.step(150);
  assert.deepEqual(two!(), one!());
});

for (const jointed of [false, true])
  for (const before of [0, 30])
    fact(
      `an exported run of a body on a rope${jointed ? ' and a joint' : ''}, from step ${before} on, is run anew in another world`,
      async () => {
        const [one, two] = [await world(), await world()];
        const [kept, anew] = [one, two].map((w) => {
          const rope = addRope(w, line(8, 1, [0, 0, 0], [0.6, 0.8, 0]), { fixedIndex: [0] });
          const body = addBody(w, { position: [0.6, 0.8, 0], geometry: [sphere(0.1)] });
          tie(w, rope, 8, { body });
          if (jointed) addJoint(w, 'BallJoint', { body1: body, anchorPoint: [0.6, 1.3, 0.2] });
          return () => [...places(rope).flat(), ...position(body), ...velocity(body)];
        });
        one.step(before);
        await one.record({ seconds: 10 });
        one.step(150);
        const timeline = (await two.importRun(JSON.parse(JSON.stringify(one.exportRun()))))!;
        assert.deepEqual(timeline.hashes, one.timeline!.hashes);
        assert.deepEqual(anew!(), kept!());
      },
    );

fact('its error is measured in copies of the world, which goes on as it would', async () => {
  const [w, plain] = [await world(), await world()];
  const [state, expected] = [w, plain].map((each) => scene(each).state);
  w.step(60);
  const rows = await w.measureAccuracy({ seconds: 0.2, levels: ['game', 'fine'] });
  assert.deepEqual(
    rows.map(({ level }) => level),
    ['game', 'fine'],
  );
  w.step(60);
  plain.step(120);
  assert.deepEqual(state!(), expected!());
});

// ---- on and off ----------------------------------------------------------------------------------------------------------

const effect = (w: World, name = 'ropes') => w.effects.find((each) => each.name === name)!;

fact('ropes are on because of the first, and off without a call when the last goes', async () => {
  const w = await world();
  const none = effect(w);
  assert.deepEqual([none.active, none.because, none.calls], [false, null, 0]);
  const ropes = [0, 1].map((x) => addRope(w, line(4, 1, [x, 0, 0], DOWN), { fixedIndex: [0] }));
  const body = addBody(w, { position: [0, -1, 0], geometry: [sphere(0.1)] });
  tie(w, ropes[0]!, 4, { body });
  w.step(34);
  const on = effect(w);
  assert.equal(on.active, true);
  assert.equal((on.because!.element as Node).id, ropes[0]!.id);
  assert.deepEqual(
    on.elements.map((each) => (each as Node).id),
    ropes.map(({ id }) => id),
  );
  assert.ok(on.calls > 0);
  ropes[0]!.remove();
  w.step(34);
  assert.equal((effect(w).because!.element as Node).id, ropes[1]!.id);
  assert.equal(effect(w, 'joint solve').active, false);
  ropes[1]!.remove();
  w.step(34);
  const off = effect(w);
  assert.deepEqual([off.active, off.because, off.elements, off.calls], [false, null, [], 0]);
});

fact('coord_changed tells where its points are after each step, as positions does', async () => {
  const w = await world();
  const rope = addRope(w, line(4, 1, [0, 0, 0], [1, 0, 0]), { fixedIndex: [0] });
  const told: Vec3[][] = [];
  rope.on('coord_changed' as never, ((value: Vec3[]) => told.push(value)) as never);
  w.step(5);
  assert.equal(told.length, 5);
  assert.deepEqual(told.at(-1), places(rope));
});

// ---- rest --------------------------------------------------------------------------------------------------------------

/** A body that hangs on a rope, at rest. */
async function atRest(): Promise<{ w: World; rope: Node; body: Body }> {
  const w = await world({ rest: 'auto' });
  const rope = addRope(w, line(8, 1, [0, 0, 0], DOWN), { fixedIndex: [0], radius: 0.02 });
  const body = addBody(w, { position: [0, -1, 0], geometry: [sphere(0.1)] });
  tie(w, rope, 8, { body });
  // Two seconds of the rope, and two of the body.
  w.advance(6);
  assert.ok(body.sleeping);
  return { w, rope, body };
}

fact(
  'what hangs still falls asleep with its rope, and the world takes no step any more',
  async () => {
    const { w, rope, body } = await atRest();
    const [steps, before] = [w.stepsTaken, places(rope)];
    for (let n = 0; n < 10; n++) w.frame(n / 60);
    assert.equal(w.stepsTaken, steps);
    assert.deepEqual(places(rope), before);
    close(position(body), [0, -1, 0], 1e-5);
  },
);

const WAKES: Record<string, (rope: Node, w: World) => void> = {
  'is let go': (rope) => rope.set('fixedIndex', []),
  'is made heavier': (rope) => rope.set('mass', 5),
  'is laid anew': (rope) => rope.set('points', line(8, 1, [0, 0.1, 0], DOWN)),
  goes: (rope) => rope.remove(),
  'is switched off': (rope) => rope.set('enabled', false),
  'is tied elsewhere, too': (rope, w) => tie(w, rope, 4, { position: [0.2, -0.4, 0] }),
};

for (const [what, edit] of Object.entries(WAKES))
  fact(`a body that hangs asleep wakes when its rope ${what}`, async () => {
    const { w, rope, body } = await atRest();
    edit(rope, w);
    w.step(2);
    assert.ok(!body.sleeping);
  });

fact('a sleeping rope wakes when a ball comes against it, and its body with it', async () => {
  const { w, rope, body } = await atRest();
  const before = place(rope, 4);
  addBody(w, {
    position: [0.5, -0.5, 0],
    linearVelocity: [-3, 0, 0],
    useGlobalGravity: false,
    geometry: [sphere(0.1)],
  });
  w.advance(0.3);
  assert.ok(distance(place(rope, 4), before) > 0.01, `${place(rope, 4).join()}`);
  assert.ok(!body.sleeping);
});

fact('a sleeping rope wakes with the body that hangs on it', async () => {
  const { w, rope, body } = await atRest();
  body.applyImpulse([0.5, 0, 0]);
  w.advance(0.3);
  assert.ok(place(rope, 8)[0] > 0.05, `${place(rope, 8).join()}`);
});

fact('without rest it is within a millimetre of where it is with it', async () => {
  const [one, two] = await Promise.all(
    (['auto', 'never'] as const).map(async (rest) => {
      const w = await world({ rest });
      const rope = addRope(w, line(8, 1, [0, 0, 0], [1, 0, 0]), { fixedIndex: [0], damping: 3 });
      w.advance(12);
      return places(rope);
    }),
  );
  one!.forEach((at, i) => below(distance(at, two![i]!), 1e-3));
});

fact('gravity of its world, edited, acts on a rope, whether it rests or not', async () => {
  for (const seconds of [0.5, 6]) {
    const w = await world();
    const rope = addRope(w, line(4, 1, [0, 0, 0], DOWN), { fixedIndex: [0], damping: 4 });
    w.advance(seconds);
    close(place(rope, 4), [0, -1, 0], 1e-6);
    w.settings.set('gravity', [9.8, 0, 0]);
    w.advance(6);
    close(place(rope, 4), [1, 0, 0], 1e-2);
  }
});
