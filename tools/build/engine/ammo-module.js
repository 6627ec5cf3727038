import { usedGlue } from './used-glue.js';

/**
 * The Ammo glue (`ammojs-typed/wasm`) is a CommonJS script. Here it becomes an ES module, for Rollup and for
 * the bundles of tests alike. Node running the sources needs none of this: it imports CommonJS as it is.
 *
 * Without what the core does not call (used-glue.js), and two edits:
 * - the export block at the end becomes `export default`;
 * - the tests for Node, a page and a worker answer no. What follows them fetches the wasm, by `require` in Node, which no ES
 *   module has; our loader hands it over, so none of it is needed.
 */
const TESTS = [
  '"object"==typeof window',
  '"function"==typeof importScripts',
  '"object"==typeof process&&"object"==typeof process.versions&&"string"==typeof process.versions.node',
];
const EXPORT_BLOCK = /if \(typeof exports === 'object' && typeof module === 'object'\)[\s\S]*$/;

const isGlue = (path) => path.endsWith('/ammojs-typed/ammo/ammo.wasm.js');

/** `sources`: those that call it, where they are more than the core. */
export function glueToModule(code, sources) {
  // Another release of the glue may read differently: better no build than a broken one.
  if (!TESTS.every((test) => code.includes(test)) || !EXPORT_BLOCK.test(code)) {
    throw new Error('tools/build/engine/ammo-module.js does not know this version of ammojs-typed');
  }
  const used = TESTS.reduce(
    (left, test) => left.replace(test, 'false'),
    usedGlue(code, sources).code,
  );
  return used.replace(EXPORT_BLOCK, 'export default Ammo;\n');
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
