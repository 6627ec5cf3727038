// The classic script with the wasm inside, for pages opened from disk: they may not fetch a file beside them.
import wasmBinary from 'virtual:ammo-wasm';
import { chunks, configure } from '../physics-core/inside.js';
import { begin } from './begin.js';
import { besideScript, scriptAddress } from './script-address.js';
import { setViewFolder } from './ui/view.js';

const address = scriptAddress();

configure({ wasmBinary, workerUrl: besideScript('accuracy-worker.js', address) });
setViewFolder(address);
// All of them are in this file.
for (const chunk of chunks) void chunk.load();
begin();

export * from './api.js';
