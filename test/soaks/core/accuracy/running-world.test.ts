import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import { fact } from '../../../core/helpers.js';
import { busy } from '../../../core/accuracy/scenes.js';

/** Poses and velocities of all bodies, to the last bit. */
const bits = (w: World): string =>
  JSON.stringify([...w.bodies].map((body) => [body.pose(), [...w.bodies.velocityOf(body)]]));

fact(
  'the running world notices nothing: bits, counts, problems and events are as without',
  async () => {
    const run = async (measured: boolean) => {
      const w = await busy();
      const events: string[] = [];
      for (const name of ['accuracy', 'problem', 'restore', 'reset', 'lag'])
        w.on(name, () => events.push(name));
      for (const body of w.bodies)
        for (const name of ['sleep', 'wake', 'collisionstart', 'collisionend'])
          body.on(name, () => events.push(`${name} ${body.id}`));
      const before = { bits: bits(w), stats: w.stats, time: w.time, accuracy: w.accuracy };
      if (measured) await w.measureAccuracy({ seconds: 0.2 });
      const after = { bits: bits(w), stats: w.stats, time: w.time, accuracy: w.accuracy };
      assert.deepEqual(after, before);
      w.advance(1.5);
      return { bits: bits(w), events, problems: w.problems.length, stats: w.stats };
    };
    assert.deepEqual(await run(true), await run(false));
  },
);

fact('it may go on running, and be taken down, while it is measured', async () => {
  const [w, alone] = [await busy(), await busy()];
  const measuring = w.measureAccuracy({ seconds: 0.2 });
  for (const each of [w, alone]) each.advance(0.5);
  assert.equal(bits(w), bits(alone));
  const rows = await measuring;
  assert.deepEqual(
    rows.map(({ error }) => error),
    (await (await busy()).measureAccuracy({ seconds: 0.2 })).map(({ error }) => error),
    'from the state it had when it was asked',
  );
});
