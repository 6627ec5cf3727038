import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { eventTypes } from '../../elements/bridge/words/event-types.js';
import { createWorld } from '../../physics-core/index.js';

const files = ['site', 'site/gallery', 'site/guide', 'site/recipes'].flatMap((folder) =>
  readdirSync(folder)
    .filter((name) => name.endsWith('.md'))
    .map((name) => `${folder}/${name}`),
);

/** What stands in code: blocks, and words in the text. */
const codeIn = (file: string): string =>
  [...readFileSync(file, 'utf8').matchAll(/^```[^]*?^```|`[^`\n]+`/gm)]
    .map(([code]) => code)
    .join('\n');

/** What bodies have in a page only. */
const OF_ELEMENTS = new Set(['addEventListener', 'closest', 'explain', 'matches', 'setAttribute']);

/** Events of the browser itself. */
const OF_BROWSERS = new Set(['blur', 'keydown', 'keyup']);

const named = (pattern: RegExp): [name: string, file: string][] =>
  files.flatMap((file) =>
    [...codeIn(file).matchAll(pattern)].map(([, name]): [string, string] => [name!, file]),
  );

test('what the pages call of a world is there', async () => {
  const world = await createWorld();
  const names = named(/(?<![\w'"])world\.(\w+)/g);
  assert.ok(names.length > 30);
  for (const [name, file] of names) assert.ok(name in world, `world.${name} in ${file}`);
  world.destroy();
});

test('what the pages call of a body is there', async () => {
  const world = await createWorld();
  const body = world.add('RigidBody');
  const calls = named(/(?<![\w'"-])(?:body|ball|\$0)\.(\w+)\(/g);
  assert.ok(calls.length > 10);
  for (const [name, file] of calls)
    assert.ok(name in body || OF_ELEMENTS.has(name), `${name}() in ${file}`);
  world.destroy();
});

test('the events that the pages listen to are there', () => {
  const names = named(/addEventListener\('(\w+)'/g);
  assert.ok(names.length > 8);
  for (const [name, file] of names)
    assert.ok(name in eventTypes || OF_BROWSERS.has(name), `${name} in ${file}`);
});
