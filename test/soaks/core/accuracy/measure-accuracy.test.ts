import assert from 'node:assert/strict';
import { above, addBody, addFloor, below, close, fact, world } from '../../../core/helpers.js';
import { pendulum } from '../../../core/accuracy/scenes.js';

fact('the finest of the levels asked for is what the others are compared with', async () => {
  const w = await pendulum();
  const rows = await w.measureAccuracy({ seconds: 0.5, levels: ['fine', 'game'] });
  assert.deepEqual(
    rows.map(({ level, error }) => [level, error.position > 0]),
    [
      ['game', true],
      ['fine', false],
    ],
  );
  const [alone] = await w.measureAccuracy({ seconds: 0.1, levels: ['game'] });
  assert.equal(alone!.error.position, 0);
});

fact('the deepest overlap of a ball at rest is the depth at which contacts bear', async () => {
  const w = await world();
  addFloor(w);
  addBody(w, { position: [0, 0.5, 0] });
  w.advance(1);
  for (const { error, contacts } of await w.measureAccuracy({ seconds: 0.5 })) {
    close(error.penetration, 6e-6, 2e-6, 'm');
    above(contacts, 0);
  }
});

fact('it tells how far it is, and stops when it is told to', async () => {
  const w = await pendulum();
  const shares: number[] = [];
  const stop = new AbortController();
  const { now } = performance;
  let time = 0;
  // A slice ends after 4 ms.
  performance.now = () => (time += 0.01);
  const onprogress = (share: number): void => {
    shares.push(share);
    if (share > 0.3) stop.abort();
  };
  await assert.rejects(
    w.measureAccuracy({ seconds: 1, onprogress, signal: stop.signal }),
    (error: Error) => error.name === 'AbortError',
  );
  performance.now = now;
  above(shares.length, 3);
  assert.deepEqual(
    shares,
    [...shares].sort((a, b) => a - b),
  );
  below(shares.at(-1)!, 0.5);
  await assert.rejects(w.measureAccuracy({ signal: AbortSignal.abort() }));
});
