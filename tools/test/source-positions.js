// Where a bundle's positions are in the sources. Node could say so while the tests run (--enable-source-maps), but it looks
// each test up, too, and takes a sixth of their time for it.
import { existsSync, readFileSync } from 'node:fs';
import { SourceMap } from 'node:module';
import { dirname, relative, resolve } from 'node:path';

const POSITION = /(?:file:\/\/)?[\w/.:-]*\b(test-bundles\/[\w/.-]+\.js):(\d+):(\d+)/g;

/** A text of Node's test runner, with positions in the sources. */
export function inSources(text) {
  const maps = new Map();
  const mapOf = (bundle) => {
    if (!maps.has(bundle) && existsSync(`${bundle}.map`))
      maps.set(bundle, new SourceMap(JSON.parse(readFileSync(`${bundle}.map`, 'utf8'))));
    return maps.get(bundle);
  };
  return text.replace(POSITION, (position, bundle, line, column) => {
    const found = mapOf(bundle)?.findEntry(line - 1, column - 1);
    if (!found?.originalSource) return position;
    const file = relative('.', resolve(dirname(bundle), found.originalSource));
    return `${file}:${found.originalLine + 1}:${found.originalColumn + 1}`;
  });
}
