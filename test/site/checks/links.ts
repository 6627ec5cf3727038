// Links within the site that lead nowhere.
import { existsSync, readFileSync, statSync } from 'node:fs';
import { FOLDER } from '../../../tools/docs/site.js';
import type { Page } from './pages.js';

const LINK = /<(?:a|img|link|script|iframe)\b[^>]*?\s(?:href|src)="([^"]+)"/g;
const ORIGIN = 'http://site.invalid';

/** A page that is named without its ending is there, too; a folder is its index. */
function fileOf(path: string): string | undefined {
  const file = FOLDER + decodeURIComponent(path);
  return [file, `${file}.html`, `${file}/index.html`].find(
    (name) => existsSync(name) && statSync(name).isFile(),
  );
}

const ids = new Map<string, Set<string>>();

function idsOf(file: string): Set<string> {
  const known =
    ids.get(file) ??
    new Set([...readFileSync(file, 'utf8').matchAll(/\sid="([^"]+)"/g)].map(([, id]) => id!));
  ids.set(file, known);
  return known;
}

/** Stories by the ids that Storybook lists. */
function storyIds(): Set<string> {
  const { entries } = JSON.parse(readFileSync(`${FOLDER}/stories/index.json`, 'utf8'));
  return new Set(Object.keys(entries));
}

function isDead({ pathname, hash, searchParams }: URL, stories: Set<string>): boolean {
  const file = fileOf(pathname);
  if (!file) return true;
  const story = searchParams.get('id') ?? searchParams.get('path')?.replace(/^\/\w+\//, '');
  if (story) return !stories.has(story);
  // Pages that are made by script have no ids yet.
  if (!hash || !file.endsWith('.html') || pathname.startsWith('/stories/')) return false;
  // The playground reads it.
  if (hash.startsWith('#markup=')) return false;
  return !idsOf(file).has(decodeURIComponent(hash.slice(1)));
}

export function deadLinks(all: Page[]): string[] {
  const stories = storyIds();
  return all.flatMap(({ path, html }) =>
    [...html.matchAll(LINK)]
      .map(([, link]) => new URL(link!.replaceAll('&amp;', '&'), ORIGIN + path))
      .filter((url) => url.origin === ORIGIN && isDead(url, stories))
      .map((url) => `${path} leads to ${url.href.slice(ORIGIN.length)}, which is not there`),
  );
}
