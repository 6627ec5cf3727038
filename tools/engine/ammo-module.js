import { usedGlue } from './used-glue.js';

/**
 * The Ammo glue (`ammojs-typed/wasm`) is a CommonJS script. Here it becomes an ES module, for Rollup and for
 * the bundles of tests alike. Node running the sources needs none of this: it imports CommonJS as it is.
 *
 * Without what the core does not call (used-glue.js), and two edits:
 * - the export block at the end becomes `export default`;
 * - the test for Node answers no. Its Node branch calls `require` and `__dirname`, which no ES module has;
 *   our loader hands over the bytes (`wasmBinary`) in Node, so the branch is not needed.
 */
const NODE_TEST =
  '"object"==typeof process&&"object"==typeof process.versions&&"string"==typeof process.versions.node';
const EXPORT_BLOCK = /if \(typeof exports === 'object' && typeof module === 'object'\)[\s\S]*$/;

const isGlue = (path) => path.endsWith('/ammojs-typed/ammo/ammo.wasm.js');

/** `sources`: those that call it, where they are more than the core. */
export function glueToModule(code, sources) {
  // Another release of the glue may read differently: better no build than a broken one.
  if (!code.includes(NODE_TEST) || !EXPORT_BLOCK.test(code)) {
    throw new Error('tools/engine/ammo-module.js does not know this version of ammojs-typed');
  }
  return usedGlue(code, sources)
    .code.replace(NODE_TEST, 'false')
    .replace(EXPORT_BLOCK, 'export default Ammo;\n');
}

/** For Rollup. */
export function ammoModule() {
  return {
    name: 'ammo-module',
    transform(code, id) {
      if (isGlue(id.replaceAll('\\', '/')))
        return { code: glueToModule(code), map: { mappings: '' } };
    },
  };
}
