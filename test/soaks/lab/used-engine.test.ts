import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stabilityCases } from '../../../lab/stability/cases/index.js';
import { engines, started, stateOf } from '../tools/engines.js';

/** Half a second: things have met, and hang. */
const FRAMES = 30;

// What breaks engines: stacks, chains, machines, meshes, things that spin, edits of what is in touch.
test('each scene of the stability matrix moves in the engine of pages as with all of Ammo, to the last bit', async () => {
  const both = await engines();
  for (const { id, scene, world: fields = {} } of stabilityCases) {
    const worlds = both.map((engine) => started(engine, fields));
    const plays = worlds.map((world) => scene(world));
    for (let frame = 0; frame < FRAMES; frame++) {
      for (const [i, play] of plays.entries()) {
        play.before?.(frame / 60, frame);
        if (play.pass) play.pass();
        else worlds[i]!.advance(1 / 60);
        play.after?.();
      }
    }
    const [all, used] = worlds.map(stateOf);
    assert.equal(used, all, id);
    for (const world of worlds) world.destroy();
  }
});
