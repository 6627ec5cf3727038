// The classic script, global `X3DPhysics`: everything but the wasm and the views of the ui, which lie beside it.
import { beginClassic } from './begin-classic.js';
import { besideScript } from './script-address.js';

beginClassic((address) => ({ wasmUrl: besideScript('ammo.wasm', address) }));

export * from './api.js';
