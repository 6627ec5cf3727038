import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import { Forest } from '../../../../physics-core/solver/joints/forest.js';
import type { World } from '../../../../physics-core/inside.js';
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
  velocity,
  way,
  world,
  type Body,
  type Joint,
} from '../../helpers.js';

// The joint solve moves who a joint holds. Having one is not enough: such bodies fall and bounce as free ones do.

const G = 9.81;

const far = (w: World, fields = {}): Body =>
  addBody(w, { position: [5, 20, 0], useGlobalGravity: false, ...fields });

const pin = (w: World, body1: Body, body2: Body): Joint =>
  addJoint(w, 'BallJoint', { body1, body2, anchorPoint: position(body1) });

/** Joints that hold nothing. */
const IDLE: Record<string, (w: World, body: Body) => void> = {
  'an idle MotorJoint to another body': (w, body1) =>
    void w.add('MotorJoint', { body1, body2: far(w) }),
  'an idle MotorJoint to the world': (w, body1) => void w.add('MotorJoint', { body1 }),
  'a joint to a disabled body': (w, body) => void pin(w, body, far(w, { enabled: false })),
  'a joint to a body that is disabled': (w, body) => {
    const other = far(w, { fixed: true });
    pin(w, body, other);
    w.step();
    other.set('enabled', false);
  },
  'a joint that is removed': (w, body) => {
    const joint = pin(w, body, far(w, { fixed: true }));
    w.step();
    joint.remove();
  },
  'a joint to itself': (w, body) => {
    claim(w, 'same-body');
    pin(w, body, body);
  },
};

for (const [what, add] of Object.entries(IDLE))
  describe(what, () => {
    for (const geometry of [sphere(0.5), box(1)])
      fact(`leaves a ${geometry.type} the height of its bounce`, async () => {
        for (const accuracy of levelNames) {
          const w = await world({ accuracy, gravity: [0, -G, 0] });
          addFloor(w);
          w.add('CollisionCollection', { collidables: '*', bounce: 1, minBounceSpeed: 0 });
          const body = addBody(w, { position: [0, 2.6, 0], geometry: [geometry] });
          add(w, body);
          w.advance(0.9);
          // 2.14 to 2.48 m when it was taken for one that the joint solve moves.
          close(height(body) - 0.5 + velocity(body)[1] ** 2 / (2 * G), 2.1, 1e-3, 'm');
        }
      });

    fact('leaves it its fall', async () => {
      for (const accuracy of levelNames) {
        const w = await world({ accuracy });
        const body = addBody(w);
        add(w, body);
        w.flush();
        const from = height(body);
        w.advance(0.5);
        close(from - height(body), way(9.8, 0.5), 1e-4, `m, at ${accuracy}`);
      }
    });
  });

fact('a floor that a door hangs on pushes out what lies in it as any other does', async () => {
  const heights = await Promise.all(
    [false, true].map(async (hung) => {
      const w = await world();
      claim(w, 'initial-overlap');
      const floor = addFloor(w);
      w.add('CollisionCollection', { collidables: '*', bounce: 0.5 });
      const door = addBody(w, { position: [9, 3, 0], geometry: [box(1, 2, 0.1)] });
      if (hung)
        addJoint(w, 'SingleAxisHingeJoint', {
          body1: door,
          body2: floor,
          anchorPoint: [8.5, 3, 0],
          axis: [0, 1, 0],
        });
      const stone = addBody(w, { position: [0, 0.4, 0], geometry: [box(1)] });
      w.advance(0.1);
      return height(stone);
    }),
  );
  close(heights[0]!, 0.5, 2e-3, 'm');
  close(heights[1]!, heights[0]!, 0, 'm, with a door');
});

fact('who is joined again swings as from the first', async () => {
  const swung = await Promise.all(
    [false, true].map(async (parted) => {
      const w = await world({ gravity: [0, 0, 0] });
      const post = addBody(w, { fixed: true });
      const bob = addBody(w, { position: [1, 0, 0], geometry: [sphere(0.2)] });
      addJoint(w, 'BallJoint', { body1: bob, body2: post, anchorPoint: [0, 0, 0] });
      if (parted) {
        w.step(2);
        post.set('enabled', false);
        w.step(2);
        post.set('enabled', true);
      }
      w.set('gravity', [0, -G, 0]);
      w.advance(0.25);
      return [...position(bob), ...velocity(bob)];
    }),
  );
  // Half a step of weight more, 0.04 m/s, when it went on from the step that it was last held in.
  close(swung[1]!, swung[0]!, 0, 'm, m/s');
});

/** How often joints are put in order anew in a step, after an edit. */
function orders(w: World, edit: () => void): number {
  let count = 0;
  const { build } = Forest.prototype;
  Forest.prototype.build = function (...all) {
    count++;
    build.apply(this, all);
  };
  try {
    edit();
    w.step();
  } finally {
    Forest.prototype.build = build;
  }
  return count;
}

fact(
  'joints are put in order anew when one of them changes, and not for anything else',
  async () => {
    const w = await world();
    const [one, two] = [addBody(w), addBody(w, { position: [3, 0, 0] })];
    const joint = pin(w, one, two);
    const others = [6, 9, 12].map((x) => addBody(w, { position: [x, 0, 0] }));
    const motor = w.add('MotorJoint', { body1: others[0], body2: others[1] });
    const collection = w.add('CollisionCollection', { collidables: '*' });
    w.step();
    assert.equal(
      orders(w, () => {}),
      0,
    );
    assert.equal(
      orders(w, () => others[2]!.remove()),
      0,
      'a free body goes',
    );
    assert.equal(
      orders(w, () => void addBody(w, { position: [15, 0, 0] })),
      0,
      'a free body comes',
    );
    assert.equal(
      orders(w, () => others[0]!.set('fixed', true)),
      0,
      'a free body is fixed',
    );
    assert.equal(
      orders(w, () => motor.set('axis1Torque', 1)),
      0,
      'a motor is driven',
    );
    assert.equal(
      orders(w, () => motor.remove()),
      0,
      'a motor goes',
    );
    assert.equal(
      orders(w, () => collection.remove()),
      0,
      'a collection goes',
    );
    assert.equal(
      orders(w, () => two.set('fixed', true)),
      1,
      'a body that it holds is fixed',
    );
    assert.equal(
      orders(w, () => void pin(w, others[0]!, others[1]!)),
      1,
      'a joint comes',
    );
    assert.equal(
      orders(w, () => joint.remove()),
      1,
      'a joint goes',
    );
    assert.equal(
      orders(w, () => one.remove()),
      0,
      'a body that it held goes',
    );
  },
);
