import assert from 'node:assert/strict';
import { loadEngine } from '../../../physics-core/create.js';
import { World } from '../../../physics-core/inside.js';
import { Owner } from '../../../physics-core/engine/owner.js';
import { SolverHook } from '../../../physics-core/engine/solver-hook.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  fact,
  position,
  random,
  world,
} from '../helpers.js';
import {
  bodyOffsetsHold,
  manifoldOffsetsHold,
  solverOffsetsHold,
  stagesHold,
  stateByMethods,
} from './layout.js';

function scene(w: World): void {
  addFloor(w);
  const next = random(3);
  for (let i = 0; i < 10; i++)
    addBody(w, {
      position: [next(), 1 + i, next()],
      orientation: [next(), 1, 0, 3 * next()],
      geometry: [box(0.7, 0.5, 0.9)],
      angularVelocity: [next(), next(), next()],
    });
  const bob = addBody(w, { position: [5, 5, 0], centerOfMass: [0, 0.3, 0] });
  addJoint(w, 'BallJoint', { body1: bob, anchorPoint: [5, 6, 0] });
}

fact('Bullet has the layout, the hooks and the stages that the core knows', async () => {
  const { ammo } = await loadEngine();
  assert.ok(bodyOffsetsHold(ammo), 'bodies, shapes and joints');
  assert.ok(solverOffsetsHold(ammo), "the solver's settings");
  assert.ok(manifoldOffsetsHold(ammo, new SolverHook(ammo)), 'contact points, and who is told');
  assert.ok(stagesHold(ammo), 'stages of a step, and tables');
});

fact('reading from the heap and by methods of Ammo gives the same numbers', async () => {
  const w = await world();
  scene(w);
  const { reader } = w.engine;
  const fast = new Float64Array(13);
  for (let i = 0; i < 30; i++) {
    w.step(5);
    for (const { body, pointer } of w.bodies) {
      reader.pose(pointer, fast, 0);
      reader.velocity(pointer, fast, 7);
      const sure = stateByMethods(body);
      // A quaternion and its opposite are one rotation; Bullet's own is of single precision.
      const sign = Math.sign(fast[6]! * sure[6]! || 1);
      for (const k of [3, 4, 5, 6]) sure[k]! *= sign;
      close([...fast], [...sure], 1e-6, 'm, m/s');
      assert.equal(reader.sleeps(pointer), !body.isActive());
    }
  }
});

fact('reads go on after the heap has grown and moved', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { linearVelocity: [1, 0, 0] });
  w.step(60);
  const { ammo } = w.engine;
  const before = ammo.HEAPF32;
  (ammo as unknown as { _malloc(bytes: number): number })._malloc(w.engine.heapBytes);
  assert.notEqual(ammo.HEAPF32, before);
  w.step(60);
  close(position(ball), [1, 0, 0], 1e-4, 'm');
});

fact('an owner frees newest first, once', async () => {
  const { ammo } = await loadEngine();
  const freed: object[] = [];
  const owner = new Owner({
    destroy: (object: object) => freed.push(object),
    getPointer: () => 8,
  } as never);
  const [a, b] = [owner.own({}), owner.own({})];
  owner.dispose();
  owner.dispose();
  assert.deepEqual(freed, [b, a]);
  assert.ok(freed[0] === b && freed[1] === a && ammo);
});
