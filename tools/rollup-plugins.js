import { existsSync, readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { transform } from 'esbuild';
import { minify as terser } from 'terser';

const TARGET = 'es2022';
export const AMMO_WASM = 'node_modules/ammojs-typed/ammo/ammo.wasm.wasm';

/**
 * TypeScript sources, which import each other by the `.js` name they would have. Resolving them here and not
 * in node-resolve also keeps the `sideEffects` list of our own package.json away from our own sources.
 */
export function typescript() {
  const tsconfigRaw = readFileSync('tsconfig.json', 'utf8');
  return {
    name: 'typescript',
    resolveId(source, importer) {
      if (!importer?.endsWith('.ts') || !source.startsWith('.')) return null;
      const file = resolve(dirname(importer), source.replace(/\.js$/, '.ts'));
      return existsSync(file) ? file : null;
    },
    async transform(code, id) {
      if (!id.endsWith('.ts')) return null;
      return transform(code, {
        loader: 'ts',
        target: TARGET,
        sourcefile: id,
        sourcemap: true,
        tsconfigRaw,
      });
    },
  };
}

/** What tables and descriptors say to people: the manifest and the docs read it from the sources. */
const FOR_PEOPLE = {
  '/physics-core/nodes/': ['doc', 'clause'],
  '/physics-core/effects/': ['causes'],
  '/words/event-types.ts': ['doc', 'detail'],
  '/elements/': ['doc'],
};

/** Leaves in every page an empty text in place of such. Blanks keep all else where the source map has it. */
export function withoutDocs() {
  return {
    name: 'without-docs',
    transform(code, id) {
      const folder = Object.keys(FOR_PEOPLE).find((name) => id.includes(name));
      if (!folder) return null;
      let left = code;
      walk(this.parse(code), ({ type, key, value }) => {
        if (type !== 'Property' || !FOR_PEOPLE[folder].includes(key.name)) return;
        if (value.type !== 'TemplateLiteral' && typeof value.value !== 'string') return;
        const { start, end } = value;
        left = `${left.slice(0, start)}''${' '.repeat(end - start - 2)}${left.slice(end)}`;
      });
      return { code: left, map: null };
    },
  };
}

function walk(node, visit) {
  if (typeof node?.type === 'string') visit(node);
  for (const child of Object.values(node)) {
    if (child && typeof child === 'object') walk(child, visit);
  }
}

const ofOthers = (id) => !id.endsWith('.ts');

/**
 * Whole files. Of those that pages fetch one by one Terser leaves another 3 % less (gzip), for seconds: it calls what is
 * used once in its place, and gives names by how often they are used.
 */
export function minify() {
  return {
    name: 'minify',
    async renderChunk(source, { moduleIds }, { format }) {
      const { code, map } = await transform(source, {
        minify: true,
        target: TARGET,
        sourcemap: true,
        legalComments: 'eof',
        // The chart library asks it in every browser.
        define: { 'process.env.NODE_ENV': '"production"' },
        // Says that top-level names are private and may be shortened; in a classic script they are globals.
        format: format === 'es' ? 'esm' : undefined,
      });
      if (format !== 'es' || moduleIds.every(ofOthers)) return { code, map };
      return terser(code, {
        module: true,
        ecma: Number(TARGET.slice(2)),
        compress: { passes: 2 },
        format: { comments: 'some' },
        sourceMap: { content: map },
      });
    },
  };
}

/** `import wasm from 'virtual:ammo-wasm'`, see types/virtual.d.ts: as text, which any script can hold. */
export const WASM_MODULE = 'virtual:ammo-wasm';
/** Its chunk is called so. */
const WASM_TEXT = 'ammo-wasm-as-text';

export function wasmAsText() {
  return {
    name: 'wasm-as-text',
    resolveId: (source) => (source === WASM_MODULE ? WASM_TEXT : null),
    load(id) {
      if (id !== WASM_TEXT) return null;
      const base64 = readFileSync(AMMO_WASM, 'base64');
      const code = `export default () => Uint8Array.from(atob('${base64}'), (c) => c.charCodeAt(0));`;
      return { code, map: { mappings: '' } };
    },
  };
}

/** Puts ammo.wasm beside the bundles. */
export function copyWasm() {
  return {
    name: 'copy-wasm',
    generateBundle() {
      this.emitFile({ type: 'asset', fileName: 'ammo.wasm', source: readFileSync(AMMO_WASM) });
    },
  };
}
