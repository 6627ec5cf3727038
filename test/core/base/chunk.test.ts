import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { Chunk } from '../../../physics-core/base/chunk.js';
import { fact } from '../helpers.js';

describe('code that comes when it is needed', () => {
  fact('is fetched once, however many ask for it', async () => {
    let fetched = 0;
    const chunk = new Chunk<string>('test', 'a test').comesFrom(async () => {
      fetched++;
      return { provide: () => 'code' };
    });
    assert.equal(chunk.here, false);
    await Promise.all([chunk.load(), chunk.load()]);
    await chunk.load();
    assert.deepEqual([fetched, chunk.here, chunk.code], [1, true, 'code']);
  });

  fact('may be tried again when it could not be had', async () => {
    let online = false;
    const chunk = new Chunk('test', 'a test').comesFrom(async () => {
      if (!online) throw new Error('no network');
      return { provide: () => {} };
    });
    await assert.rejects(chunk.load(), /no network/);
    assert.equal(chunk.here, false);
    online = true;
    await chunk.load();
    assert.equal(chunk.here, true);
  });

  fact('is not used before it is here', () => {
    const chunk = new Chunk('test', 'a test').comesFrom(() => new Promise(() => {}));
    void chunk.load();
    assert.throws(() => chunk.code, /"test" is asked for before it is here/);
  });
});
