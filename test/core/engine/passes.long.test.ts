import assert from 'node:assert/strict';
import type { World } from '../../../physics-core/inside.js';
import { dragging } from '../../../physics-core/effects/drag/dragging.js';
import { addBody, addFloor, box, claim, fact, world } from '../helpers.js';

/** How often a step asks a body by itself. */
function asked(w: World, steps = 1): number {
  const { reader } = w.engine;
  let count = 0;
  const names = ['pose', 'velocity', 'sleeps', 'shift'] as const;
  const counting = <A extends unknown[], R>(method: (...args: A) => R) =>
    function (this: unknown, ...args: A): R {
      count++;
      return method.apply(this, args);
    };
  for (const name of names) Object.assign(reader, { [name]: counting(reader[name] as () => void) });
  try {
    w.step(steps);
  } finally {
    for (const name of names) Reflect.deleteProperty(reader, name);
  }
  return count;
}

/** Boxes in rows, so far apart that nothing touches. */
function addBoxes(w: World, count: number, y: number): void {
  for (let i = 0; i < count; i++)
    addBody(w, { position: [2 * (i % 10), y, 2 * Math.floor(i / 10)], geometry: [box(1, 1, 1)] });
}

fact('a step of falling boxes asks none of them by itself', async () => {
  const w = await world();
  addBoxes(w, 50, 10);
  w.step();
  assert.equal(asked(w), 0);
});

fact('nor does a step of boxes that lie on the ground', async () => {
  const w = await world();
  addFloor(w);
  addBoxes(w, 20, 0.5);
  w.advance(2);
  assert.equal(asked(w), 0);
});

fact('boxes that slide are asked nothing, and go the same way where each is asked', async () => {
  const worlds = [await world(), await world()];
  const [all, each] = worlds.map((w) => {
    addFloor(w);
    addBoxes(w, 20, 0.5);
    w.flush();
    for (const body of w.bodies) if (body.movable) body.set('linearVelocity', [0, 0, 2]);
    // Whether it pulls one is to be asked from then on.
    if (w === worlds[1]) w.registry.get(dragging).need({ host: undefined }, 'it may pull one');
    w.step(20);
    return { asked: asked(w, 20), state: w.snapshot() };
  });
  assert.equal(all!.asked, 0);
  assert.ok(each!.asked > 0);
  assert.deepEqual(all!.state, each!.state);
});

fact('who turns far, has its centre elsewhere or flies far goes the same way alone', async () => {
  for (const fields of [
    { orientation: [0, 1, 0, 3], angularVelocity: [0, 9, 1] },
    { centerOfMass: [0.2, 0, 0.1], angularVelocity: [3, 2, 1] },
    { linearVelocity: [0, 0, 200], geometry: [box(0.2, 0.2, 0.2)] },
  ]) {
    const [alone, together] = [await world(), await world()];
    addBoxes(together, 20, 10);
    const [one, other] = [alone, together].map((w) => {
      const body = addBody(w, { position: [0, 30, 0], ...fields });
      w.step(60);
      return [...body.readPose([]), ...w.bodies.velocityOf(body)];
    });
    assert.deepEqual(one, other);
  }
});

fact(
  'a body without finite numbers goes back to where it was, and its neighbours go on',
  async () => {
    for (const broken of ['place', 'velocity'] as const) {
      const w = await world();
      addBoxes(w, 20, 10);
      const body = addBody(w, { position: [0, 30, 0] });
      w.step(10);
      const before = [...body.readPose([])];
      const nan = w.engine.scratch.vector(NaN, 0, 0);
      if (broken === 'velocity') body.body.setLinearVelocity(nan);
      else body.body.getWorldTransform().setOrigin(nan);
      w.step();
      assert.deepEqual([...body.readPose([])], before, broken);
      assert.equal(w.bodies.countAwake(), 20);
      claim(w, 'nan-state');
    }
  },
);
