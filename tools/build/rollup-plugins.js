import { existsSync, readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { transform } from 'esbuild';
import { minify as terser } from 'terser';
import { usedWasm } from './engine/used-wasm.js';
import { walk } from './plain-pairs.js';

const TARGET = 'es2022';

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

/** The order of effects: what stands beside each name is why. */
const EFFECTS = '/physics-core/effects/';
const REASONS = 'after';

/** What tables and descriptors say to people: the manifest and the docs read it from the sources. */
const FOR_PEOPLE = {
  '/physics-core/nodes/': ['doc', 'clause', 'causes'],
  '/physics-core/world/': ['causes'],
  [EFFECTS]: ['causes'],
  '/physics-core/shapes/': ['causes'],
  '/words/event-types.ts': ['doc', 'detail'],
  '/elements/': ['doc', 'causes'],
  '/elements/x3d-': ['doc', 'attributes', 'parts'],
};

/** What tables say of most fields: `defineNode` puts it back, from the same file. */
const TABLES = '/physics-core/nodes/';
const USUAL = new Map(
  [...readFileSync('physics-core/fields/usual.ts', 'utf8').matchAll(/(\w+): '(\w+)'/g)].map(
    ([, name, value]) => [name, value],
  ),
);

/** Leaves such out of every page. Blanks keep all else where the source map has it. */
export function withoutDocs() {
  return {
    name: 'without-docs',
    transform(code, id) {
      const named = Object.keys(FOR_PEOPLE).filter((name) => id.includes(name));
      if (named.length === 0) return null;
      const leftOut = named.flatMap((name) => FOR_PEOPLE[name]);
      const reasons = named.includes(EFFECTS) && REASONS;
      let left = code;
      const blank = (start, end, by = '') => {
        left = left.slice(0, start) + by.padEnd(end - start) + left.slice(end);
      };
      walk(this.parse(code), ({ type, key, value, start, end }) => {
        if (type !== 'Property') return;
        if (key.name === reasons && value.type === 'ObjectExpression')
          for (const { value: why } of value.properties) blank(why.start, why.end, '0');
        const isUsual =
          id.includes(TABLES) && USUAL.has(key.name) && value.value === USUAL.get(key.name);
        const isText = leftOut.includes(key.name) && isPlain(value);
        if (!isUsual && !isText) return;
        const [comma] = /^\s*,?/.exec(code.slice(end));
        blank(start, end + comma.length);
      });
      return { code: left, map: null };
    },
  };
}

/** Made of texts alone. */
const isPlain = (value) =>
  value.type === 'TemplateLiteral' ||
  /^(Object|Array)Expression$/.test(value.type) ||
  typeof value.value === 'string';

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
      if (moduleIds.every(ofOthers)) return { code, map };
      return terser(code, {
        module: format === 'es',
        nameCache: { vars: { props: namesBetweenFiles(this.parse(code)) } },
        ecma: Number(TARGET.slice(2)),
        compress: { passes: 3 },
        format: { comments: 'some' },
        sourceMap: { content: map },
      });
    },
  };
}

/** Longer names are for people, and a global may have them. */
const SHORT = /^[\w$]{1,2}$/;

/**
 * What files of a build know each other's parts by is what these are called inside, too, as Terser keeps names (`$` before
 * each): `export{a,b}` is half of `export{xy as a,z as b}`. Exports, which stand last, have the first choice.
 */
function namesBetweenFiles({ body }) {
  const inside = new Map();
  for (const { specifiers = [] } of body.toReversed())
    for (const { local, exported, imported } of specifiers) {
      const name = (exported ?? imported)?.name;
      if (SHORT.test(name) && !inside.has(name)) inside.set(name, local.name);
    }
  return Object.fromEntries([...inside].map(([name, local]) => [`$${local}`, name]));
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
      const packed = gzipSync(usedWasm(), { level: 9 }).toString('base64');
      return { code: unpacking(packed), map: { mappings: '' } };
    },
  };
}

/** Packed first: of what is text already a server's own gzip would leave a third more. */
const unpacking = (packed) => `export default async () => {
  const bytes = Uint8Array.from(atob('${packed}'), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
};`;

/** Puts ammo.wasm beside the bundles. */
export function copyWasm() {
  return {
    name: 'copy-wasm',
    generateBundle() {
      this.emitFile({ type: 'asset', fileName: 'ammo.wasm', source: usedWasm() });
    },
  };
}
