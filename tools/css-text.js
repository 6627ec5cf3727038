// `import text from '../styles/x.css'`: style sheets of the ui's shadow roots, as text.
import { readFileSync } from 'node:fs';
import { resolve, dirname } from 'node:path';
import { transform } from 'esbuild';

/** For Rollup: minified. */
export function cssText() {
  return {
    name: 'css-text',
    resolveId(source, importer) {
      return importer && source.endsWith('.css') ? resolve(dirname(importer), source) : null;
    },
    async load(id) {
      if (!id.endsWith('.css')) return null;
      this.addWatchFile(id);
      const css = readFileSync(id, 'utf8');
      const { code } = await transform(css, { loader: 'css', minify: true });
      return { code: `export default ${JSON.stringify(code.trim())};`, map: { mappings: '' } };
    },
  };
}

/** For the server of Web Test Runner: a module imports it as text, a page links it as it is. */
export function cssTextForServer() {
  return {
    name: 'css-text',
    transformImport({ source }) {
      return source.endsWith('.css') ? `${source}?text` : undefined;
    },
    resolveMimeType(context) {
      return isText(context) ? 'js' : undefined;
    },
    transform(context) {
      return isText(context) ? `export default ${JSON.stringify(context.body)};` : undefined;
    },
  };
}

const isText = ({ path, URL }) => path.endsWith('.css') && URL.searchParams.has('text');
