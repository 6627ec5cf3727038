import { readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { walk } from './plain-pairs.js';

/** Numbers have a place of their own for people, and none for pages. */
const OF_NUMBERS = /\/physics-core\/.*\.ts$/;

/**
 * A number that many files import costs each of them, and the file that it stands in, a name of its own, since files of a build
 * know each other's exports by names. For pages it stands where it is used.
 */
export function inlineNumbers() {
  const known = new Map();
  const numbersIn = (file) => {
    if (!known.has(file)) known.set(file, numbersOf(readFileSync(file, 'utf8')));
    return known.get(file);
  };
  return {
    name: 'inline-numbers',
    transform(code, id) {
      if (!id.endsWith('.ts')) return null;
      const edits = [];
      walk(this.parse(code), (node) => {
        if (node.type !== 'ImportDeclaration') return;
        const file = resolve(dirname(id), node.source.value).replace(/\.js$/, '.ts');
        const numbers = OF_NUMBERS.test(file) ? numbersIn(file) : NONE;
        if (node.specifiers.some(({ imported }) => numbers.has(imported?.name)))
          edits.push([node, numbers]);
      });
      return edits.length > 0 ? { code: inlined(code, edits), map: null } : null;
    },
  };
}

const NONE = new Map();

const COMMENT = /\/\*[^]*?\*\/|\/\/.*/g;
const NUMBER = String.raw`-?[\d._e-]+`;
const TABLE = String.raw`\{(?:\s*[a-zA-Z\d]+: ${NUMBER},?)+\s*\} as const`;
const EXPORT = new RegExp(`^export const (\\w+) = (${NUMBER}|${TABLE});`, 'gm');

/**
 * Of `export const NAME = 1e-3;` in a text, by name, and of `export const NAME = { a: 1, b: 2 } as const;`: of a table that
 * stands beside its users a minifier leaves the numbers alone, where they are used.
 */
export const numbersOf = (text) =>
  new Map(
    [...text.replace(COMMENT, '').matchAll(EXPORT)].map(([, name, value]) => [
      name,
      value.replace(/\s|_|as const$/g, ''),
    ]),
  );

/** Lines stay where they are. */
function inlined(code, edits) {
  let text = '';
  let at = 0;
  for (const [{ start, end, specifiers, source }, numbers] of edits) {
    const own = specifiers.filter(({ imported }) => numbers.has(imported.name));
    const others = specifiers.filter((each) => !own.includes(each));
    const lines = code.slice(start, end).replace(/[^\n]/g, '');
    const consts = own.map(
      ({ imported, local }) => `${local.name} = ${numbers.get(imported.name)}`,
    );
    const names = others.map((each) => code.slice(each.start, each.end)).join(', ');
    text += code.slice(at, start);
    if (names) text += `import { ${names} } from ${source.raw};`;
    if (consts.length > 0) text += `const ${consts.join(', ')};`;
    text += lines;
    at = end;
  }
  return text + code.slice(at);
}
