// The classic script, global `X3DPhysics`: everything but the wasm and the views of the ui, which lie beside it.
import { begin } from './begin.js';
import { setEngineSource } from './engine-source.js';
import { besideScript, scriptAddress } from './script-address.js';
import { setViewFolder } from './ui/view.js';

const address = scriptAddress();

setEngineSource(() => ({
  wasmUrl: new URL('ammo.wasm', address).href,
  workerUrl: besideScript('accuracy-worker.js', address),
}));
setViewFolder(address);
begin();

export * from './api.js';
