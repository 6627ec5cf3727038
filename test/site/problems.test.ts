import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';

const sources = ['physics-core', 'elements'].flatMap((folder) =>
  readdirSync(folder, { recursive: true })
    .map((file) => `${folder}/${String(file)}`)
    .filter((file) => file.endsWith('.ts')),
);

const all = sources.map((file) => readFileSync(file, 'utf8')).join('\n');

/** Reports name their code where they are made; those of code that is missing, its beginning. */
const codes = new Set([
  ...[...all.matchAll(/\bcode: '([a-z0-9-]+)'/g)].map(([, code]) => code!),
  ...[...all.matchAll(/(?:\bloadFailed\(\s*|Tags = new Chunk\(\{ name: )'([a-z]+)'/g)].map(
    ([, of]) => `${of}-load-failed`,
  ),
]);

const page = readFileSync('site/guide/problems.md', 'utf8');
const entries = [...page.matchAll(/^## (.*)$/gm)].map(([, heading]) => heading!);

test('each code that the library can report has an entry, and no entry is without a code', () => {
  assert.ok(codes.size > 40);
  assert.deepEqual(entries, [...codes].sort());
});
