import assert from 'node:assert/strict';
import {
  addBody,
  addJoint,
  claim,
  close,
  counts,
  distance,
  height,
  position,
  sphere,
  velocity,
  way,
  world,
  type Node,
  WEIGHTLESS,
} from '../../../helpers.js';
import type { Row } from '../row.js';

const axisOf = (type: string, axis: number[]) => (type === 'SingleAxisHingeJoint' ? { axis } : {});

/** Two balls side by side on a joint that holds the first, and one of them is let go by naming the other. */
export function bodies(type: string): Row[] {
  return (['body1', 'body2'] as const).map((field) => ({
    field,
    fact: `the joint holds whom ${field} names now, and lets go of whom it named before`,
    run: async () => {
      const w = await world();
      const pin = addBody(w, { fixed: true, position: [0, 5, 0], geometry: [] });
      const [first, second] = [addBody(w), addBody(w, { position: [4, 0, 0] })];
      const other = field === 'body1' ? 'body2' : 'body1';
      const joint = addJoint(w, type, { [field]: first, [other]: pin, anchorPoint: [0, 0, 0] });
      w.advance(0.5);
      close(height(first), 0, 1e-3, 'm, held');
      close(height(second), -way(9.8, 0.5), 1e-3, 'm, free');
      second.event('position', [4, 0, 0]);
      second.event('linearVelocity', [0, 0, 0]);
      const { created } = counts(w);
      joint.set('anchorPoint', [4, 0, 0]);
      joint.set(field, second);
      w.advance(0.5);
      close(height(first), -way(9.8, 0.5), 1e-3, 'm, let go');
      close(height(second), 0, 1e-3, 'm, held instead');
      // Only the joint is made anew.
      assert.equal(counts(w).created, created + 1);
      // The other side becomes the world.
      joint.set(other, null);
      w.advance(0.5);
      close(height(second), 0, 1e-3, 'm, held by the world');
      claim(w, 'no-body');
      joint.set(field, null);
      w.advance(0.5);
      close(height(second), -way(9.8, 0.5), 2e-3, 'm, held by nobody');
    },
  }));
}

export function forceOutput(type: string): Row {
  return {
    field: 'forceOutput',
    fact: 'says which outputs are sent; motion and objects stay as they are',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { angularVelocity: [0, 1, 0] });
      const joint = addJoint(w, type, { body1: ball, ...axisOf(type, [0, 1, 0]) });
      w.advance(0.5);
      const before = counts(w);
      joint.set('forceOutput', ['angle']);
      w.advance(0.5);
      close(ball.get('orientation') as number[], [0, 1, 0, 1], 1e-3, 'rad');
      assert.deepEqual({ ...counts(w), patched: 0 }, { ...before, patched: 0 });
      assert.deepEqual([joint.outputs('angle'), joint.outputs('angleRate')], [true, false]);
      joint.set('forceOutput', 'ALL');
      assert.equal(joint.outputs('angleRate'), true);
    },
  };
}

export function outputAnchors(type: string): Row[] {
  return ([1, 2] as const).map((which) => ({
    field: `body${which}AnchorPoint`,
    fact: `is the anchor as body${which} carries it, also where the joint is torn open`,
    run: async () => {
      const w = await world(WEIGHTLESS);
      const [a, b] = [addBody(w), addBody(w, { position: [2, 0, 0] })];
      const joint = addJoint(w, type, { body1: a, body2: b, anchorPoint: [1, 0, 0] });
      const anchor = () => joint.get(`body${which}AnchorPoint`) as number[];
      w.step();
      close(anchor(), [1, 0, 0], 1e-4, 'm');
      const moved = which === 1 ? a : b;
      moved.set('position', [0, 3, 0]);
      moved.set('orientation', [0, 0, 1, Math.PI / 2]);
      // The anchor lies a metre along the body's x, forward or back, which now points up.
      close(anchor(), [0, which === 1 ? 4 : 2, 0], 1e-4, 'm, carried by the body');
      moved.event('position', [which === 1 ? 0 : 2, 0, 0]);
      moved.event('orientation', [0, 0, 1, 0]);
      a.set('linearVelocity', [0, 1, 0]);
      b.set('linearVelocity', [0, 1, 0]);
      w.advance(1);
      close(anchor(), [1, 1, 0], 1e-3, 'm, carried along');
    },
  }));
}

export function anchorPoint(type: string): Row {
  return {
    field: 'anchorPoint',
    fact: 'a hanging ball swings about its new anchor: distance kept, ½ v² = g h',
    run: async () => {
      const w = await world({ accuracy: 'fine' });
      const ball = addBody(w, { geometry: [sphere(0.05)] });
      const joint = addJoint(w, type, {
        body1: ball,
        anchorPoint: [0, 1, 0],
        ...axisOf(type, [0, 0, 1]),
      });
      w.advance(0.5);
      close(position(ball), [0, 0, 0], 1e-3, 'm, hanging');
      joint.set('anchorPoint', [1, 0, 0]);
      let fastest = 0;
      for (let i = 0; i < 240; i++) {
        w.step();
        close(distance(position(ball), [1, 0, 0]), 1, 5e-3, 'm from the anchor');
        fastest = Math.max(fastest, Math.hypot(...velocity(ball)));
      }
      // From the level of the anchor through the lowest point; 1 + 2/5 r² of its moment turns along.
      close(fastest, Math.sqrt((2 * 9.8) / (1 + 0.4 * 0.0025)), 0.05, 'm/s');
    },
  };
}

/** What `jointlimit` tells from now on, without its times. */
export function heard(joint: Node): Record<string, unknown>[] {
  const limits: Record<string, unknown>[] = [];
  joint.on('jointlimit', (detail) => {
    const { time, ...rest } = detail as Record<string, unknown>;
    assert.equal(typeof time, 'number');
    limits.push(rest);
  });
  return limits;
}
