import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { loadCsf } from 'storybook/internal/csf-tools';
import { allTypes } from '../../physics-core/all-types.js';
import {
  addressOf,
  backFrom,
  isFile,
  PAGES,
  ROOMS,
  SCRIPTS,
  type Link,
} from '../../stories/start/links.js';

const files = readdirSync('stories').filter((name) => name.endsWith('.stories.ts'));

/** Of every story and reference page, as Storybook itself makes them. */
const ids = files.flatMap((fileName) => {
  const csf = loadCsf(readFileSync(`stories/${fileName}`, 'utf8'), {
    fileName,
    makeTitle: (title) => title,
  });
  const { stories, meta } = csf.parse();
  const pages = meta.tags?.includes('autodocs') ? [stories[0]!.id.replace(/--.*/, '--docs')] : [];
  return [...stories.map(({ id }) => id), ...pages];
});

const links: readonly Link[] = [...ROOMS.flatMap((room) => room.links), ...PAGES];
const leadsTo = new Set(links.map(({ to }) => to));

test('the first page leads to stories and reference pages that exist', () => {
  const dead = links.filter((link) => !isFile(link) && !ids.includes(link.to));
  assert.deepEqual(dead, []);
  assert.equal(
    addressOf({ text: '', to: 'nodes-rigidbody--docs' }),
    './?path=/docs/nodes-rigidbody--docs',
  );
  assert.equal(addressOf({ text: '', to: 'scenes--pendulum' }), './?path=/story/scenes--pendulum');
});

test('it leads to every scene and to the page of every node', () => {
  const scenes = ids.filter((id) => id.startsWith('scenes--'));
  assert.equal(scenes.length, 4);
  const pages = ids.filter((id) => id.endsWith('--docs'));
  assert.equal(pages.length, Object.keys(allTypes).length);
  for (const id of [...scenes, ...pages]) assert.ok(leadsTo.has(id), id);
});

test('in the documentation it leads back to pages of it, and by itself to none', () => {
  assert.deepEqual(backFrom('/iframe.html'), []);
  const back = backFrom('/docs/stories/iframe.html').flatMap((room) => room.links);
  assert.ok(back.length > 2);
  for (const { to } of back) {
    const source = to.replace('../', 'site/').replace(/html$/, 'md');
    assert.ok(existsSync(source), source);
  }
});

test('the files that it leads to are served: their folders are, at the addresses they have here', () => {
  const [, folders] = readFileSync('.storybook/main.js', 'utf8').match(/FOLDERS = \[([^\]]*)\]/)!;
  const served = [...folders!.matchAll(/'([^']+)'/g)].map(([, folder]) => `${folder}/`);
  for (const { to } of [...links, ...SCRIPTS].filter(isFile)) {
    assert.ok(
      served.some((folder) => to.startsWith(folder)),
      to,
    );
    // What the build makes is there once it has run, and what is drawn once the stories are built: their test fetches it.
    const made = ['dist/', 'lab/report/'].some((folder) => to.startsWith(folder));
    if (!made) assert.ok(existsSync(to), to);
  }
});
