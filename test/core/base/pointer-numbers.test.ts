import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PointerNumbers } from '../../../physics-core/base/pointer-numbers.js';

/** Pointers as Bullet's heap has them: at even distances, and anywhere. */
const POINTERS = [
  ...Array.from({ length: 3000 }, (_, i) => 5_300_000 + 768 * i),
  ...Array.from({ length: 3000 }, (_, i) => 16 * ((i * 7919) % 1_000_003) + 8),
];

test('pointers are numbered as they come, and keep their number', () => {
  const numbers = new PointerNumbers();
  const known = new Map<number, number>();
  for (const pointer of POINTERS) {
    const before = known.get(pointer);
    assert.equal(numbers.find(pointer), before ?? -1);
    assert.equal(numbers.numberOf(pointer), before ?? known.size);
    if (before === undefined) known.set(pointer, known.size);
    assert.equal(numbers.count, known.size);
  }
  for (const [pointer, number] of known) assert.equal(numbers.find(pointer), number);
});

test('cleared, it begins anew', () => {
  const numbers = new PointerNumbers();
  for (const pointer of POINTERS) numbers.numberOf(pointer);
  numbers.clear();
  assert.equal(numbers.count, 0);
  for (const pointer of POINTERS) assert.equal(numbers.find(pointer), -1);
  assert.equal(numbers.numberOf(POINTERS[7]!), 0);
});
