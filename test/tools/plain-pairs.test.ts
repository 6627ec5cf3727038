import assert from 'node:assert/strict';
import { test } from 'node:test';
import { parseAst } from 'rollup/parseAst';
import { plain } from '../../tools/build/plain-pairs.js';

const of = (code: string): string => plain(code, parseAst(code));

/** What a function's body returns, as it is written and as pages have it. */
const both = (body: string): [unknown, unknown] => {
  const code = `export function f() { ${body} }`;
  const call = (text: string): unknown =>
    (new Function(text.replace('export', 'return')) as () => () => unknown)()();
  return [call(code), call(of(code))];
};

test('names that are given values in a list have each its own', () => {
  assert.equal(of('const [x, y] = [a[0], f(1, 2)];'), 'const x = a[0], y = f(1, 2);');
  assert.equal(of('let [s] = [1], t = 2;'), 'let s = 1, t = 2;');
});

test('all values are there before names are given theirs', () => {
  for (const body of [
    'let [a, b] = [1, 2]; [a, b] = [b, a]; return [a, b];',
    'let most = 0, i = -1; if (most < 3) [most, i] = [3, 7]; else i = 1; return [most, i];',
    'const o = { x: 1, y: 2 }; [o.x, o.y] = [o.y, o.x + 3]; return o;',
    'const [f, n] = [() => { const [p, q] = [n, 2]; return p * q; }, 4]; return f();',
  ]) {
    const [written, inPages] = both(body);
    assert.deepEqual(inPages, written);
    assert.ok(!/\] = \[/.test(of(`export function f() { ${body} }`)), body);
  }
});

test('lists that are not known where they are taken apart stay, and so do lines', () => {
  for (const code of [
    'const [x, y] = a;',
    'const [x, ...rest] = [1, 2, 3];',
    'const [x, y = 2] = [1, z];',
    'const [x, y] = [...a];',
    'const [x] = [1, 2];',
    'for (const [x, y] of [[1, 2]]) f(x, y);',
  ])
    assert.equal(of(code), code);
  const lines = 'const [x, y] = [\n  1,\n  2,\n];\nx;';
  assert.equal(of(lines).split('\n').indexOf('x;'), lines.split('\n').indexOf('x;'));
});
