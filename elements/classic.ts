// The classic script, global `X3DPhysics`: everything but the wasm and the views of the ui, which lie beside it.
import { begin } from './begin.js';
import { setEngineSource } from './engine-source.js';
import { scriptAddress } from './script-address.js';
import { setViewFolder } from './ui/view.js';

const address = scriptAddress();

setEngineSource(() => ({
  wasmUrl: new URL('ammo.wasm', address).href,
  workerUrl: new URL('accuracy-worker.js', address).href,
}));
setViewFolder(address);
begin();

export * from './api.js';
