// The ES module of the package: registers all elements with the page and with x3dom.
import { begin } from './begin.js';
import { setEngineSource } from './engine-source.js';

setEngineSource(() => ({
  wasmUrl: new URL('./ammo.wasm', import.meta.url).href,
  workerUrl: new URL('./accuracy-worker.js', import.meta.url).href,
}));
begin();

export * from './api.js';
