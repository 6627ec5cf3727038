import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { above, below, codes, fact, height, type Joint } from '../../../../core/helpers.js';
import { addNet, addRow } from '../../../../core/effects/joints/loaded.js';

/** Metres that a joint may gape. */
const GAP = 1e-3;

type World = Awaited<ReturnType<typeof addNet>>['w'];

/** The widest gap of any step. */
function widest(w: World, joints: readonly Joint[], seconds: number): number {
  let gap = 0;
  for (let i = 0; i < seconds / w.timeStep; i++) {
    w.step();
    gap = Math.max(gap, ...joints.map((joint) => joint.gap));
  }
  return gap;
}

const corners = (i: number, k: number): boolean => i % 4 === 0 && k % 4 === 0;
const edges = (i: number, k: number): boolean => i % 4 === 0 || k % 4 === 0;

describe('under load', () => {
  for (const [mass, seconds] of [
    [5, 2],
    [20, 1],
  ] as const)
    fact(`a net that is held by its corners carries ${mass} kg that fall on it`, async () => {
      const { w, joints, load } = await addNet('standard', {
        size: 5,
        knot: 0.2,
        held: corners,
        load: { mass, size: 0.5, drop: 0.3 },
      });
      below(widest(w, joints, seconds), GAP, 'm');
      above(height(load), 2.3, 'm');
      assert.deepEqual(codes(w), []);
    });

  fact('a trampoline carries 30 times the weight of a knot', async () => {
    const { w, joints, load } = await addNet('standard', {
      size: 5,
      knot: 0.33,
      held: edges,
      load: { mass: 10, size: 0.5, drop: 0.1 },
    });
    below(widest(w, joints, 1), GAP, 'm');
    above(height(load), 2.3, 'm');
  });

  const plank = { mass: 0.6, size: [0.28, 0.06, 0.5] as [number, number, number] };

  for (const [what, span] of [
    ['taut', 1],
    ['slack', 0.85],
  ] as const)
    fact(`a ${what} bridge of twelve planks on hinges carries 20 kg that fall on it`, async () => {
      const { w, joints, load, lowest } = await addRow('standard', {
        links: 12,
        span,
        link: plank,
        type: 'SingleAxisHingeJoint',
        load: { mass: 20, size: 0.4, drop: 0.5 },
      });
      below(widest(w, joints, 1.5), GAP, 'm');
      above(height(load), lowest - 0.1, 'm');
    });

  for (const accuracy of ['standard', 'fine'] as const)
    fact(`a straight chain holds 200 times a link that falls from 1 m at ${accuracy}`, async () => {
      const { w, joints } = await addRow(accuracy, {
        links: 8,
        span: 1,
        link: { mass: 0.5, size: [0.24, 0.06, 0.06] },
        type: 'BallJoint',
        load: { mass: 100, size: 0.4, drop: 1 },
      });
      below(widest(w, joints, 1), GAP, 'm');
    });
});
