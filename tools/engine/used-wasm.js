// ammo.wasm as pages get it: without the functions that only bindings led to which the core does not call. What stays is
// as it was, instruction for instruction: so are the bits of every motion.
import { Buffer } from 'node:buffer';
import { readFileSync } from 'node:fs';
import binaryen from 'binaryen';
import { usedGlue } from './used-glue.js';

const GLUE = 'node_modules/ammojs-typed/ammo/ammo.wasm.js';
const WASM = 'node_modules/ammojs-typed/ammo/ammo.wasm.wasm';

let made;

/** The same bytes for all that a build puts them into. */
export const usedWasm = () => (made ??= make());

function make() {
  const module = binaryen.readBinary(readFileSync(WASM));
  for (const name of usedGlue(readFileSync(GLUE, 'utf8')).unused) module.removeExport(name);
  module.runPasses(['remove-unused-module-elements']);
  const bytes = Buffer.from(module.emitBinary());
  module.dispose();
  return bytes;
}
