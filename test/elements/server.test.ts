import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as library from '../../elements/index.js';

// What servers do that render pages: import it and ask, where there is no page.

test('without a page the library can be imported, and no element lives in any world', () => {
  assert.equal(globalThis.document, undefined);
  const { worldOf } = library;
  for (const none of [undefined, null, {} as Element]) assert.equal(worldOf(none), undefined);
});

test('explain says what it takes instead of failing somewhere inside', () => {
  for (const none of [undefined, null, {}] as Element[])
    assert.throws(() => library.explain(none), {
      name: 'TypeError',
      message: `explain takes an element of a page, not ${String(none)}`,
    });
});

test('the classes can be extended and asked for their tables', () => {
  class Crate extends library.X3DRigidBodyElement {}
  assert.equal(Crate.tag, 'x3d-rigid-body');
  assert.ok(Crate.observedAttributes.includes('mass'));
  assert.equal(library.elementClasses.length, 14);
});
