import assert from 'node:assert/strict';
import { allTypes } from '../../../physics-core/all-types.js';
import { show } from '../../../physics-core/base/show.js';
import { claim, fact, world } from '../helpers.js';

fact(
  'messages show what was given, shortly, and never an empty value as the one that is used',
  async () => {
    const cyclic: Record<string, unknown> = { type: 'Box' };
    cyclic.size = cyclic;
    const given = [
      {},
      { type: 'Box', size: [1, 2, 3] },
      cyclic,
      Object.create(null),
      new Map(),
      () => 1,
      Symbol('s'),
      10n,
      null,
      undefined,
      [],
      'x'.repeat(9999),
      Array.from({ length: 9999 }, (_, i) => i),
      new Float32Array(9999),
    ];
    for (const value of given) {
      assert.ok(show(value).length <= 60 && show(value).length > 0, show(value));
      assert.doesNotMatch(show(value), /\[object/);
    }
    assert.equal(show({ type: 'Box', size: [1, 2, 3] }), '{ type: Box, size: 1 2 3 }');
    assert.equal(show(new Float32Array([1, 2])), '1 2');
    const w = await world();
    const messages: string[] = [];
    w.on('problem', (problem) => messages.push((problem as { message: string }).message));
    claim(w, 'bad-value', 'misplaced', 'out-of-range');
    for (const type of Object.keys(allTypes)) {
      const node = w.add(type);
      for (const [field, { access }] of Object.entries(allTypes[type]!.fields))
        if (access !== 'outputOnly') for (const value of given) node.set(field, value);
      if (type !== 'RigidBodyCollection') node.remove();
    }
    assert.ok(messages.length > 500);
    for (const message of messages) {
      assert.doesNotMatch(message, /\[object|; *is used|undefined is used/);
      assert.ok(message.length < 300, message);
    }
    claim(w, 'unknown-attribute');
    w.settings.set('nope', 1);
  },
);
