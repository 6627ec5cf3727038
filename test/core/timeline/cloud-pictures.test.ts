import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { World } from '../../../physics-core/inside.js';
import type { CloudPicture } from '../../../physics-core/effects/particles/seen.js';
import { CloudPictures } from '../../../physics-core/timeline/cloud-pictures.js';

/** A system of so many particles, each of which says which step it is. */
function following(count: number) {
  let shown: ReadonlyMap<number, CloudPicture> | undefined;
  let step = 0;
  const effect = {
    get pictures(): [number, CloudPicture][] {
      return [
        [1, { motion: new Float32Array(6 * count).fill(step), ages: new Float32Array(count) }],
      ];
    },
    lookBack: (pictures: typeof shown) => (shown = pictures),
  };
  const world = { registry: { find: () => effect } } as unknown as World;
  const pictures = new CloudPictures();
  const run = (steps: number): void => {
    for (let i = 0; i < steps; i++) pictures.add(++step, world);
  };
  /** The step that is shown at one. */
  const at = (asked: number): number | undefined => {
    pictures.show(asked, world);
    return shown!.get(1)?.motion[0];
  };
  return { pictures, run, at };
}

test('few particles are kept in every picture', () => {
  const { run, at } = following(100);
  run(600);
  for (const step of [1, 2, 299, 600]) assert.equal(at(step), step);
  assert.equal(at(0), undefined);
});

test('of many, what lies long back is kept less often, in 64 MB, and the last step is there', () => {
  const { run, at } = following(10_000);
  run(600);
  assert.equal(at(600), 600);
  assert.ok(at(590)! >= 589);
  const first = at(50)!;
  assert.ok(first <= 50 && first > 50 - 8, `${first}`);
});

test('what was cut or dropped is not shown', () => {
  const { pictures, run, at } = following(10);
  run(10);
  pictures.cut(6);
  assert.equal(at(9), 6);
  pictures.drop(4);
  assert.equal(at(4), 4);
  assert.equal(at(3), undefined);
});

test('what is shown of a step is still shown when those before it are dropped', () => {
  const { pictures, run, at } = following(10_000);
  run(600);
  const before = at(51);
  assert.ok(before! < 51);
  pictures.drop(51);
  assert.equal(at(51), before);
});
