// node --import tsx tools/test/walks.ts [--calls]: how far an edit, a step and a question walk through the core. Each function of an
// instrumented core tells when it is called; --calls prints them all.
import { parseArgs } from 'node:util';
import { instrumentedCore } from './walks/core.js';
import type { Call } from './walks/recorder.js';
import { walked, walks, type Walk } from './walks/scenes.js';
import {
  before,
  callsByFile,
  crossings,
  crossingsOfAll,
  describe,
  doneTwice,
  filesOf,
  inCore,
} from './walks/walk.js';

const { values: options } = parseArgs({ options: { calls: { type: 'boolean', default: false } } });

function depthOf({ caller }: Call): number {
  return caller ? depthOf(caller) + 1 : 0;
}

function show({ says, reaches }: Walk, calls: Call[]): void {
  const there = before(calls, reaches);
  const count = (of: (calls: readonly Call[]) => unknown[]): string =>
    `${of(there).length} until ${reaches}, ${of(calls).length} in all`;
  console.log(`\n${says}`);
  console.log(`  files      ${count(filesOf)}`);
  console.log(`  calls      ${count(inCore)}`);
  console.log(`  crossings  ${count(crossings)}`);
  console.log(`    with those into fields and base: ${count(crossingsOfAll)}`);
  for (const call of crossings(there))
    console.log(`    ${describe(call.caller!)} → ${describe(call)}`);
  console.log('  effects');
  for (const [file, times] of callsByFile(calls, 'effects/')) console.log(`    ${times} ${file}`);
  console.log('  done twice');
  for (const call of doneTwice(calls)) console.log(`    ${describe(call)}`);
  if (options.calls)
    for (const call of calls) console.log(`  ${' '.repeat(depthOf(call))}${describe(call)}`);
}

const core = await instrumentedCore();
for (const walk of Object.values(walks)) show(walk, await walked(core, walk));
