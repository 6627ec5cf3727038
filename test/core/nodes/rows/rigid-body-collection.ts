import assert from 'node:assert/strict';
import type { CreateOptions } from '../../../../physics-core/create.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  claim,
  close,
  counts,
  height,
  position,
  velocity,
  way,
  world,
} from '../../helpers.js';
import type { Row } from './row.js';

const QUIET = { disableTime: 0.5, disableLinearSpeed: 0.1, disableAngularSpeed: 0.1 };

async function resting(fields: Record<string, unknown>) {
  const w = await world(fields);
  addFloor(w);
  const stone = addBody(w, { geometry: [box(1)], position: [0, 0.5, 0] });
  return { w, stone };
}

/** Frames of 1/60 s. */
const run = (w: World, frames: number): void => {
  for (let i = 0; i < frames; i++) w.frame(1 / 60);
};

/** The level in force after so many frames whose steps take a millisecond each. */
function framesOf(w: World, frames: number): string {
  addBody(w, { position: [0, 1000, 0] });
  const { now } = performance;
  let time = 0;
  performance.now = () => time;
  const stop = w.on('afterstep', () => time++);
  run(w, frames);
  stop();
  performance.now = now;
  return w.accuracy;
}

const levelAfter = async (fields: CreateOptions): Promise<string> =>
  framesOf(await world(fields), 200);

/** Metres that 9.8 N, asked for anew in each step, push 1 kg in one second from rest: they tell the step in force. */
function pushed(w: World): number {
  const ball = addBody(w, { position: [0, 100, 0], useGlobalGravity: false });
  const off = w.on('beforestep', () => ball.applyForce([0, 9.8, 0]));
  w.advance(1);
  const way = height(ball) - 100;
  off();
  ball.remove();
  return way;
}

/** What is left of a gap of 0.1 m, torn open by hand, after one step. */
async function gapLeft(errorCorrection: number | undefined): Promise<number> {
  const w = await world({ gravity: [0, 0, 0], accuracy: 'game' });
  const ball = addBody(w);
  const joint = addJoint(w, 'BallJoint', { body1: ball });
  w.step();
  if (errorCorrection === undefined) w.set('errorCorrection', 0.3);
  w.step();
  if (errorCorrection === undefined) w.settings.unset('errorCorrection');
  else w.set('errorCorrection', errorCorrection);
  ball.set('position', [0.1, 0, 0]);
  w.step();
  return joint.gap;
}

export const rows: Row[] = [
  ...['bodies', 'joints'].map((field): Row => ({
    field,
    fact: `naming something in ${field} changes no motion: membership is kept at each node`,
    run: async () => {
      const w = await world();
      const ball = addBody(w, { position: [0, 2, 0] });
      const joint = addJoint(w, 'BallJoint', { body1: ball, anchorPoint: [0, 2, 0] });
      const free = addBody(w, { position: [5, 0, 0] });
      w.advance(0.5);
      const before = counts(w);
      w.set(field, field === 'bodies' ? [free] : [joint]);
      w.advance(0.5);
      close(height(free), -way(9.8, 1), 1e-3, 'm');
      close(height(ball), 2, 1e-4, 'm');
      assert.deepEqual({ ...counts(w), patched: 0 }, { ...before, patched: 0 });
    },
  })),
  {
    field: 'collider',
    fact: 'with a collider only its members collide, the others fall through; without one everything does',
    run: async () => {
      const w = await world();
      claim(w, 'not-in-collider');
      addFloor(w, -10);
      const shape = (size: number[]) => w.add('CollidableShape', { shape: [box(...size)] });
      const [slab, inside, outside] = [shape([20, 1, 20]), shape([1, 1, 1]), shape([1, 1, 1])];
      addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [slab] });
      const member = addBody(w, { position: [-2, 0.5, 0], geometry: [inside] });
      const other = addBody(w, { position: [2, 0.5, 0], geometry: [outside] });
      const collider = w.add('CollisionCollection', { collidables: [slab, inside] });
      w.advance(0.5);
      close([height(member), height(other)], [0.5, 0.5], 1e-3, 'm, no collider');
      w.set('collider', collider);
      w.advance(0.5);
      close([height(member), height(other)], [0.5, 0.5 - way(9.8, 0.5)], 2e-3, 'm, collider');
      w.advance(0.4);
      w.settings.unset('collider');
      w.advance(3);
      close([height(member), height(other)], [0.5, -9.5], 2e-3, 'm, no collider again');
    },
  },
  {
    field: 'enabled',
    fact: 'a disabled collection stands still and goes on without a jump in time',
    run: async () => {
      const w = await world();
      const ball = addBody(w);
      run(w, 30);
      close(height(ball), -way(9.8, 0.5), 1e-4, 'm');
      w.set('enabled', false);
      run(w, 60);
      close(height(ball), -way(9.8, 0.5), 1e-4, 'm, disabled');
      w.settings.unset('enabled');
      run(w, 30);
      close(height(ball), -way(9.8, 1), 1e-3, 'm, enabled again');
    },
  },
  {
    field: 'gravity',
    fact: 'another gravity acts on every body of the collection from the next step on',
    run: async () => {
      const w = await world();
      const [ball, free] = [
        addBody(w),
        addBody(w, { position: [5, 0, 0], useGlobalGravity: false }),
      ];
      w.advance(0.5);
      w.set('gravity', [3, 0, 0]);
      w.advance(0.5);
      close(velocity(ball), [1.5, -4.9, 0], 1e-4, 'm/s');
      close(velocity(free), [0, 0, 0], 0, 'm/s without global gravity');
      w.settings.unset('gravity');
      w.advance(0.5);
      close(velocity(ball), [1.5, -9.8, 0], 1e-4, 'm/s at -9.8 again');
    },
  },
  {
    field: 'preferAccuracy',
    fact: 'TRUE steps by 1/480 s, seen in the ½ a t dt by which a push in each step goes too far, unless a level is authored',
    run: async () => {
      const w = await world();
      close(pushed(w), way(9.8, 1) + 4.9 / 120, 5e-4, 'm at standard');
      w.set('preferAccuracy', true);
      close(pushed(w), way(9.8, 1) + 4.9 / 480, 5e-4, 'm at precise');
      w.set('accuracy', 'game');
      close(pushed(w), way(9.8, 1) + 4.9 / 60, 5e-4, 'm, the authored level wins');
      w.settings.unset('accuracy');
      w.settings.unset('preferAccuracy');
      close(pushed(w), way(9.8, 1) + 4.9 / 120, 5e-4, 'm at standard again');
    },
  },
  {
    field: 'accuracy',
    fact: 'each level steps by its own time, seen in the ½ a t dt by which a push in each step goes too far',
    run: async () => {
      const w = await world();
      w.step();
      for (const [level, steps] of [
        ['game', 60],
        ['standard', 120],
        ['fine', 240],
        ['precise', 480],
        ['reference', 960],
      ] as const) {
        w.set('accuracy', level);
        close(pushed(w), way(9.8, 1) + 4.9 / steps, 5e-4, `m at ${level}`);
      }
      w.settings.unset('accuracy');
      close(pushed(w), way(9.8, 1) + 4.9 / 120, 5e-4, 'm at standard again');
    },
  },
  {
    field: 'iterations',
    fact: 'one iteration lets a loaded pile sink in, fifty hold it better; 0 counts as 1',
    run: async () => {
      const w = await world({ accuracy: 'game' });
      addFloor(w);
      const pile = Array.from({ length: 4 }, (_, i) =>
        addBody(w, { position: [0, i + 0.5, 0], mass: i === 3 ? 20 : 1, geometry: [box(1)] }),
      );
      const lowest = () => {
        let top = 4;
        for (let i = 0; i < 30; i++) {
          w.step();
          top = Math.min(top, height(pile[3]!));
        }
        return 3.5 - top;
      };
      const info = () => w.bullet.bullet.getSolverInfo().get_m_numIterations();
      w.step();
      assert.equal(info(), 10);
      w.set('iterations', 50);
      const many = lowest();
      assert.equal(info(), 50);
      w.set('iterations', 0);
      w.reset();
      const one = lowest();
      assert.equal(info(), 1);
      above(one, 3 * many, 'm, sunk in at 1 iteration');
      w.settings.unset('iterations');
      w.step();
      assert.equal(info(), 10);
    },
  },
  {
    field: 'errorCorrection',
    fact: 'the share of a gap that one step of 1/60 s repairs; unset, the level says it',
    run: async () => {
      close(await gapLeft(0.2), 0.08, 1e-4, 'm left at 0.2');
      close(await gapLeft(0.5), 0.05, 1e-4, 'm left at 0.5');
      close(await gapLeft(undefined), 0.02, 1e-4, 'm left at the level');
    },
  },
  {
    field: 'constantForceMix',
    guard: 'jointSoftness',
    fact: 'a soft joint sags under a weight by CFM · m g · dt / ERP, and never lets go',
    run: async () => {
      const w = await world({ accuracy: 'game', errorCorrection: 0.5 });
      const ball = addBody(w, { mass: 2 });
      const joint = addJoint(w, 'BallJoint', { body1: ball });
      w.advance(1);
      close(joint.gap, 0, 1e-4, 'm, hard');
      w.set('constantForceMix', 0.002);
      w.advance(3);
      close(joint.gap, (0.002 * 2 * 9.8) / 60 / 0.5, 2e-5, 'm, sag');
      // So soft that Bullet would drop the joint (a fall of 44 m in 3 s).
      w.set('constantForceMix', 1000);
      w.advance(3);
      below(joint.gap, 1, 'm, softest');
      w.settings.unset('constantForceMix');
      w.advance(3);
      close(joint.gap, 0, 1e-4, 'm, hard again');
    },
  },
  {
    field: 'contactSurfaceThickness',
    fact: 'a box at rest sinks in by this depth',
    run: async () => {
      const { w, stone } = await resting({});
      w.advance(1);
      close(height(stone), 0.5, 1e-3, 'm');
      w.set('contactSurfaceThickness', 0.05);
      w.advance(2);
      close(height(stone), 0.45, 1e-3, 'm, sunk');
      w.settings.unset('contactSurfaceThickness');
      w.advance(2);
      close(height(stone), 0.5, 2e-3, 'm, lifted again');
    },
  },
  {
    field: 'autoDisable',
    fact: 'TRUE is the default of every body that says nothing itself',
    run: async () => {
      const { w, stone } = await resting(QUIET);
      const own = addBody(w, { geometry: [box(1)], position: [4, 0.5, 0], autoDisable: false });
      w.advance(2);
      assert.equal(stone.sleeping, false);
      w.set('autoDisable', true);
      w.advance(1);
      assert.deepEqual([stone.sleeping, own.sleeping], [true, false]);
      w.set('autoDisable', false);
      w.advance(1);
      assert.equal(stone.sleeping, false);
    },
  },
  {
    field: 'disableTime',
    fact: 'bodies sleep after the new time',
    run: async () => {
      const { w, stone } = await resting({ ...QUIET, autoDisable: true, disableTime: 100 });
      w.advance(2);
      assert.equal(stone.sleeping, false);
      w.set('disableTime', 0.5);
      w.advance(0.4);
      assert.equal(stone.sleeping, false);
      w.advance(0.5);
      assert.equal(stone.sleeping, true);
    },
  },
  {
    field: 'disableLinearSpeed',
    fact: 'drifting bodies sleep once the speed is above theirs',
    run: async () => {
      const w = await world({ ...QUIET, autoDisable: true, gravity: [0, 0, 0] });
      const ball = addBody(w, { linearVelocity: [0.2, 0, 0] });
      w.advance(2);
      assert.equal(ball.sleeping, false);
      w.set('disableLinearSpeed', 0.3);
      w.advance(1);
      close(velocity(ball), [0, 0, 0], 0, 'm/s, asleep');
    },
  },
  {
    field: 'disableAngularSpeed',
    fact: 'turning bodies sleep once the spin is above theirs',
    run: async () => {
      const w = await world({ ...QUIET, autoDisable: true, gravity: [0, 0, 0] });
      const ball = addBody(w, { angularVelocity: [0, 0.2, 0] });
      w.advance(2);
      assert.equal(ball.sleeping, false);
      w.set('disableAngularSpeed', 0.3);
      w.advance(1);
      close(ball.get('angularVelocity') as number[], [0, 0, 0], 0, 'rad/s, asleep');
    },
  },
  {
    field: 'rest',
    effect: 'rest',
    fact: 'with auto a body at rest sleeps after 2 s, with never it wakes and stays awake',
    run: async () => {
      const { w, stone } = await resting({});
      w.advance(4);
      assert.equal(stone.sleeping, false);
      w.settings.unset('rest');
      w.advance(1.9);
      assert.equal(stone.sleeping, false);
      w.advance(0.6);
      assert.equal(stone.sleeping, true);
      w.set('rest', 'never');
      w.advance(4);
      assert.equal(stone.sleeping, false);
    },
  },
  {
    field: 'collisionRules',
    fact: 'by the strict rules nothing collides without a collider',
    run: async () => {
      const { w, stone } = await resting({});
      w.advance(0.5);
      close(height(stone), 0.5, 1e-3, 'm, lenient');
      w.set('collisionRules', 'strict');
      w.advance(0.5);
      close(height(stone), 0.5 - way(9.8, 0.5), 2e-3, 'm, strict');
    },
  },
  {
    field: 'accuracy',
    fact: 'auto takes the finest level whose frames fit the time budget',
    run: async () => assert.equal(await levelAfter({ accuracy: 'auto', timeBudget: 8 }), 'fine'),
  },
  {
    field: 'timeBudget',
    fact: 'a smaller one makes auto take a coarser level, while it runs',
    run: async () => {
      assert.equal(await levelAfter({ accuracy: 'auto', timeBudget: 1 }), 'game');
      const w = await world({ accuracy: 'auto', timeBudget: 100 });
      assert.equal(framesOf(w, 60), 'fine');
      w.set('timeBudget', 1);
      assert.equal(framesOf(w, 60), 'standard');
    },
  },
  {
    field: 'runHidden',
    fact: 'nothing in the core follows it: a page does',
    run: async () => {
      const w = await world();
      const ball = addBody(w);
      w.advance(0.5);
      const before = counts(w);
      w.set('runHidden', true);
      w.advance(0.5);
      close(position(ball), [0, -way(9.8, 1), 0], 1e-3, 'm');
      assert.deepEqual({ ...counts(w), patched: 0 }, { ...before, patched: 0 });
    },
  },
  {
    field: 'debug',
    effect: 'debug drawing',
    fact: 'whoever draws is told when the first collection asks for it, and when the last no longer does',
    run: async () => {
      const w = await world();
      const told: unknown[] = [];
      w.on('debug', (on) => told.push(on));
      const drawing = () => w.effects.find(({ name }) => name === 'debug drawing')!;
      const other = w.add('RigidBodyCollection');
      w.set('debug', true);
      other.set('debug', true);
      w.step(0);
      assert.deepEqual(told, [true]);
      assert.equal(drawing().because!.reason, 'debug');
      w.reset();
      w.settings.unset('debug');
      w.step(0);
      assert.deepEqual(told, [true]);
      other.remove();
      assert.deepEqual(told, [true, false]);
      assert.equal(drawing().active, false);
    },
  },
  {
    effect: 'monitor',
    fact: 'counts the frames in which the world took a step',
    run: async () => {
      const w = await world();
      addBody(w);
      w.recordCosts('somebody');
      for (let i = 0; i < 3; i++) {
        w.frame(1 / 60);
        w.stepping.frameOver(0);
      }
      assert.equal(w.costs!.frames, 3);
    },
  },
  {
    field: 'thread',
    fact: 'where there are no workers it runs here, and says so when it is reset',
    run: async () => {
      const w = await world();
      const ball = addBody(w);
      w.set('thread', 'worker');
      w.step(0);
      assert.deepEqual(w.problems, []);
      w.reset();
      assert.equal(w.mirrored, undefined);
      claim(w, 'thread-main');
      w.step(60);
      close(height(ball), -way(9.8, 0.5), 1e-3, 'm');
    },
  },
  {
    field: 'heapLimit',
    guard: 'roomy',
    fact: 'beyond the limit a body is not made and the world pauses; the rest of it is untouched',
    run: async () => {
      const w = await world();
      claim(w, 'heap-low', 'heap-exhausted');
      const ball = addBody(w);
      w.advance(0.5);
      // The heap starts at 16 MB, the least limit; 24 MB more let it grow past that.
      const { ammo } = w.engine;
      if (w.engine.heapBytes <= 16 * 2 ** 20)
        (ammo as unknown as { _malloc(bytes: number): number })._malloc(24 * 2 ** 20);
      w.set('heapLimit', 16);
      w.frame(0);
      const late = addBody(w, { position: [9, 0, 0] });
      w.step(0);
      assert.equal(w.paused, true);
      assert.equal(late.built, false);
      const at = position(ball);
      run(w, 30);
      close(position(ball), at, 0, 'm, paused');
      w.set('heapLimit', 2000);
      late.touch('geometry');
      w.paused = false;
      run(w, 30);
      assert.equal(late.built, true);
      close(height(late), -way(9.8, 0.5), 1e-3, 'm, made after all');
    },
  },
];
