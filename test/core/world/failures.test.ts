import assert from 'node:assert/strict';
import { afterEach } from 'node:test';
import type { World } from '../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  claim,
  close,
  fact,
  height,
  position,
  sphere,
  way,
  world,
  type Body,
} from '../helpers.js';

type Made = 'btRigidBody' | 'btSphereShape' | 'btCompoundShape' | 'btGeneric6DofConstraint';

/** From now on making one of these Bullet objects fails; returns how to mend that. */
function breaking(w: World, name: Made, error: unknown): () => unknown {
  const { ammo } = w.engine;
  const whole = ammo[name];
  const fails = function (): never {
    throw error;
  };
  Object.assign(ammo, { [name]: fails });
  broken = () => Object.assign(ammo, { [name]: whole });
  return broken;
}

/** All worlds share one engine: whatever a fact broke is mended at its end. */
let broken = (): unknown => undefined;
afterEach(() => void broken());

const BUG = new TypeError("Cannot read properties of undefined (reading 'x')");

const told = (w: World) => w.problems.map(({ code, severity }) => [code, severity]);

/** Bytes of the heap between two blocks taken around `act`: those that it left behind, beside the block. */
function leftBy(w: World, act: () => void): number {
  const take = (): number => w.engine.ammo._malloc(65536);
  for (let i = 0; i < 4; i++) {
    act();
    take();
  }
  const [first, second] = [take(), take()];
  act();
  return take() - second - (second - first);
}

fact('an exception of ours is told as such: that node is undone, the others go on', async () => {
  const w = await world();
  claim(w, 'edit-failed');
  addFloor(w);
  const ball = addBody(w, { position: [0, 9, 0] });
  w.step();
  const slots = w.poses.current.length;
  const mend = breaking(w, 'btRigidBody', BUG);
  const late = w.add(
    'RigidBody',
    { position: [3, 9, 0], geometry: box(1) },
    { name: 'late' },
  ) as Body;
  w.advance(0.5);
  assert.equal(w.paused, false);
  assert.deepEqual(told(w), [['edit-failed', 'error']]);
  const [problem] = w.problemsOf(late);
  assert.match(problem!.message, /RigidBody "late" could not be simulated \(TypeError: .* fault/);
  close(height(ball), 9 - way(9.8, 61 / 120), 0.05, 'm, its neighbour falls');
  assert.deepEqual([late.built, late.slot, w.stats.bodies], [false, -1, 2]);
  mend();
  late.set('mass', 2);
  w.advance(0.5);
  assert.deepEqual(w.problems, [], 'its next edit tries again');
  close(height(late), 9 - way(9.8, 0.5), 0.05, 'm');
  assert.equal(w.poses.current.length, slots, 'places of bodies');
});

fact(
  'what failed half way leaves nothing in the heap and takes no place among the bodies',
  async () => {
    const w = await world();
    claim(w, 'edit-failed');
    addFloor(w);
    w.step();
    const fail = (what: Made) => (): void => {
      const mend = breaking(w, what, BUG);
      const body = addBody(w, {
        geometry: [
          box(1),
          { type: 'CollidableOffset', translation: [1, 0, 0], collidable: sphere(1) },
        ],
      });
      const joint = addJoint(w, 'BallJoint', { body1: body });
      w.step();
      assert.deepEqual(told(w), [['edit-failed', 'error']]);
      mend();
      joint.remove();
      body.remove();
    };
    for (const what of ['btRigidBody', 'btCompoundShape', 'btSphereShape'] as const)
      assert.equal(leftBy(w, fail(what)), 0, `bytes left by a failed ${what}`);
    assert.equal(w.stats.bodies, 1);
    assert.deepEqual(w.problems, []);
  },
);

fact('a body whose new shape fails goes out, and what touched it hears so', async () => {
  const w = await world();
  claim(w, 'edit-failed');
  const floor = addFloor(w);
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: box(1) });
  const ends: unknown[] = [];
  stone.on('collisionend', (detail) => ends.push((detail as { reason: string }).reason));
  w.advance(0.2);
  const mend = breaking(w, 'btSphereShape', BUG);
  floor.set('geometry', [sphere(3)]);
  w.advance(0.5);
  mend();
  assert.deepEqual(ends, ['removed']);
  close(height(stone), 0.5 - way(9.8, 0.5), 0.05, 'm, it falls');
  assert.deepEqual(told(w), [['edit-failed', 'error']]);
  floor.set('geometry', [box(60, 1, 60)]);
  stone.teleport([0, 0.5, 0], undefined, { linearVelocity: [0, 0, 0] });
  w.advance(1);
  close(height(stone), 0.5, 2e-3, 'm, on it again');
  assert.deepEqual(w.problems, []);
});

fact('a joint that fails is the one that is named, and its bodies fall', async () => {
  const w = await world();
  claim(w, 'edit-failed');
  const [one, other] = [addBody(w), addBody(w, { position: [2, 0, 0] })];
  const mend = breaking(w, 'btGeneric6DofConstraint', BUG);
  const joint = addJoint(w, 'BallJoint', { body1: one, body2: other });
  w.advance(0.5);
  mend();
  assert.deepEqual(w.problems.map(({ element }) => element), [joint]); // prettier-ignore
  close([height(one), height(other)], [-way(9.8, 0.5), -way(9.8, 0.5)], 1e-3, 'm');
  // A body that comes back asks its joints.
  joint.set('anchorPoint', [1, 1, 0]);
  const again = breaking(w, 'btGeneric6DofConstraint', BUG);
  w.step(0);
  one.set('enabled', false);
  w.step(0);
  one.set('enabled', true);
  w.step(0);
  again();
  assert.deepEqual(w.problems.map(({ element }) => element), [joint]); // prettier-ignore
  assert.equal(one.built, true);
});

fact(
  'only where the heap has no room it is exhausted: the world pauses, and that addition is undone',
  async () => {
    for (const full of ['null pointer', 'trap']) {
      const w = await world();
      claim(w, 'heap-exhausted');
      const ball = addBody(w, { position: [0, 5, 0] });
      w.advance(0.5);
      const at = position(ball);
      const { ammo } = w.engine;
      const [getPointer, malloc] = [ammo.getPointer, ammo._malloc];
      let mend = (): unknown => undefined;
      // Ammo hands out null where its malloc gave nothing; else the wasm stops.
      if (full === 'null pointer') {
        const { btSphereShape } = ammo;
        ammo.getPointer = (object) =>
          object instanceof btSphereShape ? 0 : getPointer.call(ammo, object);
      } else mend = breaking(w, 'btSphereShape', new WebAssembly.RuntimeError('unreachable'));
      ammo._malloc = () => 0;
      const late = addBody(w, { position: [9, 5, 0] });
      w.step(0);
      ammo.getPointer = getPointer;
      ammo._malloc = malloc;
      mend();
      assert.deepEqual(told(w), [['heap-exhausted', 'error']]);
      assert.deepEqual([w.paused, late.built, late.slot, w.stats.bodies], [true, false, -1, 1]);
      assert.deepEqual(position(ball), at);
      w.paused = false;
      late.set('mass', 2);
      w.advance(0.5);
      assert.deepEqual(w.problems, []);
      close(height(late), 5 - way(9.8, 0.5), 1e-3, 'm');
    }
  },
);

fact(
  'hundreds of bodies that find no room are one problem, and are made once the limit is higher',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    claim(w, 'heap-exhausted');
    addBody(w, { position: [0, 5, 0] });
    w.step();
    // The heap starts at 16 MB, the least limit; 24 MB more let it grow past that.
    const { ammo } = w.engine;
    if (w.engine.heapBytes <= 16 * 2 ** 20) ammo._malloc(24 * 2 ** 20);
    w.set('heapLimit', 16);
    const late = Array.from({ length: 300 }, (_, i) => addBody(w, { position: [2 * i, 0, 0] }));
    w.step(0);
    assert.deepEqual([w.paused, w.stats.bodies], [true, 1]);
    assert.equal(told(w).filter(([code]) => code === 'heap-exhausted').length, 1);
    assert.match(
      w.problems.find(({ code }) => code === 'heap-exhausted')!.message,
      /16 MB, has no room for/,
    );
    // The one that was told of goes: the next one that finds none is.
    late[0]!.remove();
    late[1]!.set('mass', 3);
    w.step(0);
    assert.equal(w.problems.find(({ code }) => code === 'heap-exhausted')!.element, late[1]);
    // It steps by hand all the same, and takes other edits.
    w.step(2);
    w.set('heapLimit', 2000);
    w.paused = false;
    for (let i = 0; i < 2; i++) w.frame(1 / 60);
    assert.equal(w.stats.bodies, 300);
    assert.ok(!told(w).some(([code]) => code === 'heap-exhausted'));
  },
);

fact('a trap of the wasm while there is room is no exhaustion', async () => {
  const w = await world();
  claim(w, 'edit-failed');
  const mend = breaking(w, 'btSphereShape', new WebAssembly.RuntimeError('unreachable'));
  addBody(w);
  w.step();
  mend();
  assert.deepEqual(told(w), [['edit-failed', 'error']]);
  assert.equal(w.paused, false);
});
