// ammo.wasm as pages get it: without the functions that only bindings led to which the core does not call, and without
// functions and data that nothing can reach then (reach.js). What stays is as it was, instruction for instruction: so are
// the bits of every motion.
import { Buffer } from 'node:buffer';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import binaryen from 'binaryen';
import { CACHE } from '../current.js';
import { globSync } from '../../files.js';
import { FIRST, listOf, without } from './data.js';
import { reached } from './reach.js';
import { SOURCES, usedGlue } from './used-glue.js';

const GLUE = 'node_modules/ammojs-typed/ammo/ammo.wasm.js';
const WASM = 'node_modules/ammojs-typed/ammo/ammo.wasm.wasm';

/** Who calls by number what was cut comes here and no farther: the step fails, as by any trap, and says so. */
const CUT = 'cut';

const made = new Map();

/**
 * The same bytes for all that a build puts them into. `sources`: those that call it by name, where they are more than the
 * core, as in the tests; what is called by number is that of pages then, too, so that a test fails that comes to what was cut.
 */
export function usedWasm(sources = SOURCES) {
  const key = sources.join();
  if (!made.has(key)) made.set(key, kept(sources));
  return made.get(key);
}

/** It takes seconds to make, and each stage of the tests is a process of its own. */
function kept(sources) {
  const file = `${CACHE}/engine-${keyOf(sources)}.wasm`;
  if (existsSync(file)) return readFileSync(file);
  const bytes = make(sources);
  mkdirSync(CACHE, { recursive: true });
  // Whole at once: another stage may look for it now.
  writeFileSync(`${file}.${process.pid}`, bytes);
  renameSync(`${file}.${process.pid}`, file);
  return bytes;
}

/** Of all that it is made from. */
function keyOf(sources) {
  const hash = createHash('sha256');
  const glue = readFileSync(GLUE, 'utf8');
  for (const callers of [SOURCES, sources]) hash.update(usedGlue(glue, callers).unused.join());
  for (const file of [WASM, 'package-lock.json', ...globSync('tools/build/engine/*.js')])
    hash.update(readFileSync(file));
  return hash.digest('hex').slice(0, 16);
}

function make(sources) {
  const all = readFileSync(WASM);
  return within(all, SOURCES, (used) => {
    const { names, unread } = reached(used);
    return within(without(all, used, unread), sources, (module) => {
      cut(module, names);
      removeUnused(module);
      return Buffer.from(module.emitBinary());
    });
  });
}

/** What `act` makes of the wasm without what no source calls. */
function within(wasm, sources, act) {
  const module = binaryen.readBinary(wasm);
  for (const name of usedGlue(readFileSync(GLUE, 'utf8'), sources).unused)
    module.removeExport(name);
  removeUnused(module);
  const result = act(module);
  module.dispose();
  return result;
}

const removeUnused = (module) => module.runPasses(['remove-unused-module-elements']);

/** Leaves these alone among what is called by number; all keep their numbers. */
function cut(module, names) {
  const { name, data } = listOf(module);
  const table = binaryen.getTableInfo(module.getTableByIndex(0));
  module.addFunction(CUT, binaryen.none, binaryen.none, [], module.unreachable());
  module.removeElementSegment(name);
  const left = data.map((each) => (names.has(each) ? each : CUT));
  module.addActiveElementSegment(table.name, name, left, module.i32.const(FIRST));
}
