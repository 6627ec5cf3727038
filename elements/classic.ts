// The classic script, global `X3DPhysics`: everything but the wasm and the views of the ui, which lie beside it.
import { chunks, configure } from '../physics-core/inside.js';
import { begin } from './begin.js';
import { besideScript, scriptAddress } from './script-address.js';
import { setViewFolder } from './ui/view.js';

const address = scriptAddress();

configure({
  wasmUrl: besideScript('ammo.wasm', address),
  workerUrl: besideScript('accuracy-worker.js', address),
});
setViewFolder(address);
// All of them are in this file.
for (const chunk of chunks) void chunk.load();
begin();

export * from './api.js';
