import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { ballChain } from '../../../../../references/chains.js';
import { addBallChain } from '../../../../core/effects/joints/scenes.js';
import { add, cross, scale } from '../../../../../physics-core/base/math.js';
import type { World } from '../../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  close,
  fact,
  height,
  position,
  random,
  sphere,
  spin,
  velocity,
  world,
  type Body,
  type Joint,
  type Vec3,
} from '../../../../core/helpers.js';

const widest = (joints: readonly Joint[]): number => Math.max(...joints.map((joint) => joint.gap));
const fastest = (bodies: readonly Body[]): number =>
  Math.max(...bodies.map((body) => Math.hypot(...velocity(body))));

/** Widest gap and highest speed on the way. */
function worst(w: World, bodies: Body[], joints: Joint[], seconds: number): [number, number] {
  let [gap, speed] = [0, 0];
  for (let i = 0; i < seconds / w.timeStep; i++) {
    w.step();
    gap = Math.max(gap, widest(joints));
    speed = Math.max(speed, fastest(bodies));
  }
  assert.ok(bodies.every((body) => [...position(body), ...spin(body)].every(Number.isFinite)));
  return [gap, speed];
}

describe('bodies that come and go', () => {
  fact('a chain that hangs still falls asleep, and a push wakes it whole', async () => {
    const w = await world({ rest: 'auto' });
    const bodies = [1, 2, 3, 4].map((i) =>
      addBody(w, { position: [0, -i, 0], geometry: [sphere(0.2)] }),
    );
    const joints = bodies.map((body, i) =>
      addJoint(w, 'BallJoint', {
        body1: body,
        ...(i && { body2: bodies[i - 1] }),
        anchorPoint: [0, -i, 0],
      }),
    );
    w.advance(5);
    assert.ok(bodies.every((body) => body.sleeping));
    const before = bodies.map(position);
    w.advance(5);
    bodies.forEach((body, i) => close(position(body), before[i]!, 0, 'm asleep'));
    bodies[3]!.event('linearVelocity', [2, 0, 0]);
    const [gap] = worst(w, bodies, joints, 1);
    below(gap, 2e-4, 'm');
    assert.ok(bodies.every((body) => !body.sleeping));
    below(position(bodies[3]!)[0], 2, 'm');
  });

  fact('a link made fixed holds what hangs on it, and lets it go when it moves again', async () => {
    const w = await world();
    const { bodies, joints } = addBallChain(w, ballChain(1));
    w.advance(0.5);
    const held = position(bodies[3]!);
    bodies[3]!.set('fixed', true);
    const [gap] = worst(w, bodies, joints, 1);
    below(gap, 1e-4, 'm');
    close(position(bodies[3]!), held, 1e-6, 'm, fixed');
    bodies[3]!.set('fixed', false);
    const [after] = worst(w, bodies, joints, 1);
    below(after, 1e-4, 'm');
    below(height(bodies[3]!), held[1] - 0.1, 'm, it fell on');
  });

  fact('a link that is removed leaves two chains, each whole', async () => {
    const w = await world();
    const { bodies, joints } = addBallChain(w, ballChain(1));
    w.advance(0.5);
    bodies[4]!.remove();
    const rest = joints.filter((_, i) => i !== 4 && i !== 5);
    const [gap] = worst(
      w,
      bodies.filter((_, i) => i !== 4),
      rest,
      1,
    );
    below(gap, 1e-4, 'm');
    below(height(bodies[7]!), -9, 'm, the lower part falls');
    above(height(bodies[3]!), -4.1, 'm, the upper part hangs');
  });

  for (const [field, value] of [
    ['mass', 5],
    ['centerOfMass', [0.05, 0, 0]],
    ['inertia', [1, 0, 0, 0, 1, 0, 0, 0, 1]],
    ['linearDampingFactor', 0.2],
  ] as const) {
    fact(`${field} edited in mid-swing tears nothing`, async () => {
      const w = await world();
      const { bodies, joints } = addBallChain(w, ballChain(1));
      w.advance(0.7);
      bodies[3]!.set('autoDamp', true);
      bodies[3]!.set(field, value);
      const [gap, speed] = worst(w, bodies, joints, 1);
      below(gap, 1e-4, 'm');
      below(speed, 40, 'm/s');
    });
  }

  fact('a link that is put elsewhere draws the others after it without throwing them', async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const { bodies, joints } = addBallChain(w, ballChain(1));
    w.advance(0.1);
    bodies[7]!.event('position', [7.5, 0.5, 0]);
    w.advance(0.5);
    below(widest(joints), 1e-4, 'm');
    below(fastest(bodies), 0.1, 'm/s');
  });

  fact(
    'joints added and removed every frame leave nothing behind, and a reset runs alike',
    async () => {
      const w = await world({ gravity: [0, 0, 0] });
      const next = random();
      const bodies = Array.from({ length: 20 }, (_, i) =>
        addBody(w, {
          position: [i, 0, 0],
          geometry: [sphere(0.2)],
          linearVelocity: [0, next() - 0.5, next() - 0.5],
        }),
      );
      const fixed = bodies
        .slice(1)
        .map((body, i) =>
          addJoint(w, 'BallJoint', { body1: bodies[i], body2: body, anchorPoint: [i + 0.5, 0, 0] }),
        );
      const run = (): number[] => {
        for (let frame = 0; frame < 120; frame++) {
          const [a, b] = [bodies[frame % 10]!, bodies[10 + (frame % 10)]!];
          const extra = addJoint(w, 'BallJoint', { body1: a, body2: b, anchorPoint: position(a) });
          w.step();
          extra.remove();
          w.step();
        }
        return bodies.flatMap((body) => [...position(body), ...velocity(body)]);
      };
      const first = run();
      assert.ok(first.every(Number.isFinite));
      below(widest(fixed), 1e-3, 'm');
      const heap = w.engine.ammo.HEAP8.length;
      w.reset();
      assert.deepEqual(run(), first);
      assert.equal(w.engine.ammo.HEAP8.length, heap);
      assert.equal(w.stats.joints, fixed.length);
    },
  );
});

describe('momentum of what floats', () => {
  for (const accuracy of ['game', 'standard', 'precise'] as const) {
    fact(
      `a chain that tumbles freely keeps its momentum and its centre at ${accuracy}`,
      async () => {
        const w = await world({ gravity: [0, 0, 0], accuracy });
        const bodies = Array.from({ length: 8 }, (_, i) =>
          addBody(w, {
            position: [i, 0, 0],
            mass: 1 + (i % 3),
            geometry: [sphere(0.3)],
            linearVelocity: [0, i - 3, (i * i) / 20],
          }),
        );
        const joints = bodies.slice(1).map((body, i) =>
          addJoint(w, 'BallJoint', {
            body1: bodies[i],
            body2: body,
            anchorPoint: [i + 0.5, 0, 0],
          }),
        );
        const momenta = (): [Vec3, Vec3] =>
          bodies.reduce<[Vec3, Vec3]>(
            ([linear, angular], body) => {
              const p = scale(velocity(body), body.mass.mass);
              // The velocity belongs to the middle of the step: so does the place taken.
              const at = add(position(body), scale(velocity(body), -w.timeStep / 2));
              const own = scale(spin(body), body.mass.moments[0]);
              return [add(linear, p), add(angular, add(cross(at, p), own))];
            },
            [
              [0, 0, 0],
              [0, 0, 0],
            ],
          );
        w.step();
        const before = momenta();
        const [gap] = worst(w, bodies, joints, 5);
        below(gap, 1e-4, 'm');
        const after = momenta();
        close(after[0], before[0], 1e-3, 'N s');
        close(after[1], before[1], 5e-3 * Math.hypot(...before[1]), 'N m s');
      },
    );
  }

  fact('a chain of balls dropped on a floor lies there whole', async () => {
    const w = await world({ accuracy: 'standard' });
    addFloor(w, -3);
    const { bodies, joints } = addBallChain(w, ballChain(1));
    joints[0]!.remove();
    const [gap, speed] = worst(w, bodies, joints.slice(1), 3);
    below(gap, 1e-3, 'm');
    // Fallen 3 m.
    below(speed, 8.5, 'm/s');
    below(fastest(bodies), 0.5, 'm/s at the end');
  });
});
