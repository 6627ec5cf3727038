// The classic script with the wasm inside, for pages opened from disk: they may not fetch a file beside them.
import base64 from 'virtual:ammo-wasm-base64';
import { begin } from './begin.js';
import { setEngineSource } from './engine-source.js';
import { besideScript, scriptAddress } from './script-address.js';
import { setViewFolder } from './ui/view.js';

const address = scriptAddress();

setEngineSource(() => ({
  wasmBinary: Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)),
  workerUrl: besideScript('accuracy-worker.js', address),
}));
setViewFolder(address);
begin();

export * from './api.js';
