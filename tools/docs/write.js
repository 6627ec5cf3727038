// npm run write -- <name>: writes anew what is made of other files of the repository and kept in it.
import { runNode } from '../processes.js';

const WRITERS = {
  /** docs/chunks.md, from dist/. */
  chunks: 'tools/docs/chunks-page.ts',
  /** docs/conformance.md with --write; without, both columns on the console. */
  conformance: 'tools/test/conformance.ts',
  /** docs/effects.md. */
  effects: 'tools/docs/effects-page.ts',
  /** dist/custom-elements.json and its like. */
  manifest: 'tools/build/manifest.ts',
  /** The README's moving picture. */
  picture: 'tools/docs/moving-picture.ts',
  /** TypeScript's side of the field tables. */
  types: 'tools/build/types.ts',
};

const [name = '', ...args] = process.argv.slice(2);
if (Object.hasOwn(WRITERS, name)) {
  const { ok } = await runNode(['--import', 'tsx', WRITERS[name], ...args]);
  if (!ok) process.exitCode = 1;
} else {
  console.error(`npm run write -- ${Object.keys(WRITERS).join(' | ')}`);
  process.exitCode = 1;
}
