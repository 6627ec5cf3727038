import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadEngine } from '../../../physics-core/create.js';

const AWAY = { wasmUrl: 'https://example.invalid/ammo.wasm' };

void test('a failed load may be tried again, and whoever asks then gets the one engine', async () => {
  const { fetch } = globalThis;
  let asked = 0;
  globalThis.fetch = () => {
    asked++;
    return Promise.reject(new TypeError('no network'));
  };
  const first = loadEngine(AWAY);
  // Whoever tries again at once, while others still hear that it failed.
  const again = first.catch(() => loadEngine());
  const others = [loadEngine(AWAY), loadEngine(AWAY)];
  for (const other of others) await assert.rejects(other, /no network/);
  globalThis.fetch = fetch;
  assert.equal(asked, 1);
  const engine = await again;
  assert.equal(await loadEngine(), engine);
  assert.equal(await loadEngine(AWAY), engine);
});
