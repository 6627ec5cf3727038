// The classic script, global `X3DPhysics`: everything but the wasm, which lies beside it.
import { begin } from './begin.js';
import { setEngineSource } from './engine-source.js';

// Known only while the script itself runs.
const script = document.currentScript as HTMLScriptElement | SVGScriptElement | null;
const address = script && 'src' in script ? script.src : document.baseURI;

setEngineSource(() => ({ wasmUrl: new URL('ammo.wasm', address).href }));
begin();

export * from './api.js';
