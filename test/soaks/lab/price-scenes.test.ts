import assert from 'node:assert/strict';
import { test } from 'node:test';
import { engines, running } from '../../../lab/price/engines.js';
import { priceScenes } from '../../../lab/price/scenes/index.js';

test('every scene starts in every engine and takes a step, all of it finite', async () => {
  const ids = new Set(priceScenes.map(({ id }) => id));
  assert.equal(ids.size, priceScenes.length);
  // Of each kind, one: what differs in size alone is built alike.
  const kinds = new Map(priceScenes.map((scene) => [scene.build, scene])).values();
  for (const { id, small, build } of kinds) {
    const scene = build(small);
    for (const engine of engines) {
      const made = await running(engine, scene, 'game');
      assert.ok(typeof made !== 'string', `${engine.id} has no words for ${id}`);
      made.step();
      for (const { name } of scene.bodies) {
        const pose = [...made.position(name), ...made.orientation(name)];
        assert.ok(pose.every(Number.isFinite), `${id}, ${engine.id}: ${name}`);
      }
      made.destroy();
    }
  }
});
