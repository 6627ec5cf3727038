import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createWorld, loadEngine } from '../../../physics-core/create.js';
import { configure } from '../../../physics-core/inside.js';

const WASM = 'node_modules/ammojs-typed/ammo/ammo.wasm.wasm';

test('where the wasm is: a wrong address is named, a load may be tried again until one is done', async () => {
  await assert.rejects(
    createWorld({ wasmUrl: 'file:///nowhere/ammo.wasm' }),
    /nowhere\/ammo\.wasm/,
  );
  configure({ wasmUrl: 'elsewhere/ammo.wasm' });
  await assert.rejects(createWorld(), /elsewhere\/ammo\.wasm.*configure\(\{ wasmUrl \}\)/);
  const noWasm = new Uint8Array([0x3c, 0x21, 0x64, 0x6f]);
  await assert.rejects(createWorld({ wasmBinary: noWasm }), /magic/);

  // The import is one thing, what the program says next another: the engine waits for it.
  const made = createWorld();
  configure({ wasmBinary: () => noWasm });
  configure({ wasmUrl: WASM, workerUrl: '/worker.js' });
  assert.equal((await made).advance(1), 1);

  const { source } = await loadEngine();
  assert.ok(source.program instanceof WebAssembly.Module);
  assert.equal(source.workerUrl, '/worker.js');
  assert.throws(() => configure({ wasmUrl: WASM }), /too late/);
});
