import assert from 'node:assert/strict';
import { addBody, addFloor, claim, position, world } from '../helpers.js';

/**
 * One fact about one field, effect or guard. The tests run all of them; the mutation tests break what a row names and
 * expect one of its rows to throw. A row edits the field while the world runs and looks at motion or Bullet's state.
 */
export interface Row {
  field?: string;
  effect?: string;
  guard?: string;
  fact: string;
  run: () => void | Promise<void>;
}

/** Rows of fields that are kept but not simulated yet: the author is told, and nothing moves otherwise. */
export const unsimulated = (type: string, values: Record<string, unknown>): Row[] =>
  Object.entries(values).map(([field, value]) => ({
    field,
    fact: 'is kept but not simulated yet: its author is told, and the motion stays as it was',
    run: async () => {
      const heights: number[] = [];
      for (const edit of [false, true]) {
        const w = await world();
        addFloor(w);
        const ball = addBody(w, { position: [0, 1, 0], linearVelocity: [1, 0, 0] });
        const collection = w.add('CollisionCollection', { collidables: '*' });
        w.advance(0.25);
        if (edit) {
          claim(w, 'approximated-field');
          const node = type === 'CollisionCollection' ? collection : w.settings;
          node.set(field, value);
          assert.deepEqual(node.get(field), value);
        }
        w.advance(0.5);
        heights.push(...position(ball));
      }
      assert.deepEqual(heights.slice(0, 3), heights.slice(3));
    },
  }));
