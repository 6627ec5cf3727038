import assert from 'node:assert/strict';
import { fact } from '../../../core/helpers.js';
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
