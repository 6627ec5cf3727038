import { gzipSync } from 'node:zlib';

const zipped = (code) => gzipSync(code).length;

/** Files that a file is not run without, itself included. */
function withImports(bundle, name, found = new Set()) {
  if (found.has(name) || !bundle[name]) return found;
  found.add(name);
  for (const each of bundle[name].imports ?? []) withImports(bundle, each, found);
  return found;
}

/**
 * Tells each file that pages fetch with its cause, and that provides code of effects, what it weighs: `world.effects`
 * shows it. With what comes along, and without what is there already; as a server sends it (gzip).
 */
export function chunkBytes(entries) {
  return {
    name: 'chunk-bytes',
    generateBundle(_, bundle) {
      const chunks = Object.values(bundle).filter(({ type }) => type === 'chunk');
      const there = new Set();
      for (const { name, isEntry, fileName } of chunks)
        if (isEntry && entries.includes(name)) withImports(bundle, fileName, there);
      for (const chunk of chunks) {
        if (!chunk.isDynamicEntry || !chunk.exports.includes('provide')) continue;
        const own = [...withImports(bundle, chunk.fileName)].filter((name) => !there.has(name));
        const bytes = own.reduce((sum, name) => sum + zipped(bundle[name].code), 0);
        const at = chunk.code.lastIndexOf('//# sourceMappingURL');
        const end = at < 0 ? chunk.code.length : at;
        chunk.code = `${chunk.code.slice(0, end)}export const bytes=${bytes};\n${chunk.code.slice(end)}`;
      }
    },
  };
}
