import { gzipSync } from 'node:zlib';

/** In place of the number, until the files are written. */
const UNKNOWN = '__CHUNK_BYTES__';

/** The modules of chunks: `provide` gives their code to effects, `createView` shows them. */
const provides = (code, id) =>
  /(-code|\/view)\.ts$/.test(id) && /export (const|function) (provide|createView)\b/.test(code);

/** Files that a file is not run without, itself included. */
function withImports(bundle, name, found = new Set()) {
  if (found.has(name) || !bundle[name]) return found;
  found.add(name);
  for (const each of bundle[name].imports ?? []) withImports(bundle, each, found);
  return found;
}

/**
 * Tells each file that pages fetch with its cause, and that provides code of effects, what it weighs: `world.effects`
 * shows it. With what comes along, and without what comes with `entries`; as a server sends it (gzip).
 */
export function chunkBytes(entries) {
  return {
    name: 'chunk-bytes',
    transform(code, id) {
      if (!provides(code, id)) return null;
      return { code: `${code}\nexport const bytes = ${UNKNOWN};\n`, map: null };
    },
    generateBundle(_, bundle) {
      const files = Object.values(bundle).filter(({ type }) => type === 'chunk');
      const there = new Set();
      for (const { name, isEntry, fileName } of files)
        if (isEntry && entries.includes(name)) withImports(bundle, fileName, there);
      const weight = (name) => (there.has(name) ? 0 : gzipSync(bundle[name].code).length);
      for (const file of files) {
        if (!file.code.includes(UNKNOWN)) continue;
        const all = [...withImports(bundle, file.fileName)];
        const bytes = all.reduce((sum, name) => sum + weight(name), 0);
        file.code = file.code.replace(UNKNOWN, bytes);
      }
    },
  };
}
