// What is read before anything runs: types, the order of the rooms, lint and format.
import { changedFiles } from '../test/changed.js';
import { BIN } from '../processes.js';

/** Each is what Node is to run. In one thread types take a third less of the processor, and the others run beside. */
const TYPES = ['types', [BIN.tsc7, '--noEmit', '--singleThreaded']];
const ROOMS = ['rooms', ['--import', 'tsx', 'tools/check/rooms.ts']];

const lint = (files) => [BIN.eslint, '--no-warn-ignored', ...files];
const format = (files) => [BIN.prettier, '--check', '--ignore-unknown', ...files];

export const LINT = lint(['.']);
export const FORMAT = format(['.']);

/** By them every file is another one. */
const RULES = /^(eslint\.config\.js|tools\/rooms\.config\.js|\.prettier\w+)$/;

/** Lint and format of the files that changed; those of all are stages of `test:all`. */
async function ofChanged() {
  const changed = await changedFiles();
  if (!changed || changed.some((file) => RULES.test(file)))
    return [
      ['lint', LINT],
      ['format', FORMAT],
    ];
  const sources = changed.filter((file) => /\.[jt]s$/.test(file));
  return [
    ...(sources.length ? [[`lint of ${sources.length} changed files`, lint(sources)]] : []),
    ...(changed.length ? [[`format of ${changed.length} changed files`, format(changed)]] : []),
  ];
}

export const quickChecks = async () => [TYPES, ROOMS, ...(await ofChanged())];
