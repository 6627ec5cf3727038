// The classic script with the wasm inside, for pages opened from disk: they may not fetch a file beside them.
import wasmBinary from 'virtual:ammo-wasm';
import { beginClassic } from './begin-classic.js';

beginClassic(() => ({ wasmBinary }));

export * from './api.js';
