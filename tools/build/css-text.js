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
