import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { allEffects } from '../../../physics-core/effects/all.js';
import type { EffectDescriptor } from '../../../physics-core/effects/effect/effect.js';
import { inOrder } from '../../../physics-core/effects/effect/order.js';

const FOLDER = 'physics-core/effects';
const namesOf = (effects: readonly EffectDescriptor[]): string[] => effects.map(({ name }) => name);

describe('the order of effects', () => {
  for (const { name, after = {} } of allEffects)
    for (const [earlier, why] of Object.entries(after))
      test(`${name} comes after ${earlier}, and it is said why`, () => {
        const [at, before] = [name, earlier].map((each) => namesOf(allEffects).indexOf(each));
        assert.ok(before! >= 0, `there is no effect "${earlier}"`);
        assert.ok(before! < at!);
        assert.match(why, /^\S+( \S+)+$/);
      });

  test('is the one that they ask for, and nothing is left to be moved', () => {
    assert.deepEqual(namesOf(inOrder(allEffects)), namesOf(allEffects));
  });

  test('has each effect once, by a name of its own', () => {
    assert.equal(new Set(namesOf(allEffects)).size, allEffects.length);
  });

  test('has every effect that some file describes', () => {
    const texts = (readdirSync(FOLDER, { recursive: true }) as string[])
      .filter((file) => file.endsWith('.ts'))
      .map((file) => readFileSync(`${FOLDER}/${file}`, 'utf8'));
    const described = texts.flatMap((text) => text.match(/^export const \w+: EffectDescriptor/gm));
    assert.equal(described.filter(Boolean).length, allEffects.length);
  });

  test('has all that come and go with others', () => {
    for (const { name, with: others = [] } of allEffects)
      for (const other of others) assert.ok(allEffects.includes(other), `${name}: ${other.name}`);
  });

  test('says of each effect what switches it on', () => {
    for (const { name, causes } of allEffects) assert.match(causes, /\w/, name);
  });
});

/** An effect that nobody makes. */
const effect = (name: string, ...after: string[]): EffectDescriptor => ({
  name,
  causes: 'nothing',
  after: Object.fromEntries(after.map((each) => [each, 'it has to'])),
  load: () => assert.fail(),
});

describe('an order of effects', () => {
  test('leaves those as they are listed that ask for nothing', () => {
    assert.deepEqual(namesOf(inOrder([effect('b'), effect('a')])), ['b', 'a']);
  });

  test('puts each behind all that it asks for, through others too', () => {
    const listed = [effect('c', 'b'), effect('b', 'a'), effect('x'), effect('a')];
    assert.deepEqual(namesOf(inOrder(listed)), ['a', 'b', 'c', 'x']);
  });

  test('there is none of effects that wait for each other, or for one that is none', () => {
    assert.throws(() => inOrder([effect('a', 'b'), effect('b', 'a')]), /wait for each other/);
    assert.throws(() => inOrder([effect('a', 'nobody')]), /"nobody", which is no effect/);
  });
});
