import assert from 'node:assert/strict';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { test } from 'node:test';

const readme = readFileSync('README.md', 'utf8');

/** A stranger reads so much and no more. */
const WORDS = 900;

/** Bytes of the picture that moves: it comes with the page on every phone. */
const PICTURE = 300_000;

test('the README has at most 900 words, markup included', () => {
  const words = readme.split(/\s+/).length;
  assert.ok(words <= WORDS, `${words} words`);
});

test('links and pictures of the README lead to what is in the repository', () => {
  const places = [...readme.matchAll(/\]\((?!https:)([^)#]+)/g)].map(([, place]) => place!);
  assert.ok(places.length > 20);
  assert.deepEqual(
    places.filter((place) => !existsSync(place)),
    [],
  );
});

test("the README's picture moves and is small", () => {
  const [, file] = /!\[[^\]]+\]\(([^)]+\.webp)\)/.exec(readme)!;
  const bytes = readFileSync(file!);
  assert.ok(statSync(file!).size <= PICTURE, `${statSync(file!).size} bytes`);
  // Frames of a moving picture stand in chunks of this name.
  assert.ok(bytes.toString('latin1').split('ANMF').length > 20);
});
