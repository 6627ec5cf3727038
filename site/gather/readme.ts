// Sections of the README that are pages of the site.
import { readFileSync } from 'node:fs';
import { forSite } from './links.js';

/** Page of the site: the sections that make it, the first one its title. */
const PAGES: Record<string, string[]> = {
  'guide/script': ['From a script', 'Without a page'],
  'guide/dragging': ['Dragging'],
  'guide/looking-inside': ['Looking inside'],
  'guide/accuracy': ['Accuracy', 'Measured'],
  'guide/limits': ['What works where'],
};

function section(readme: string, title: string): string {
  const [, text] = readme.split(`\n## ${title}\n`);
  if (text === undefined) throw new Error(`README.md has no section "${title}"`);
  return text.split(/\n## /)[0]!.trim();
}

export function readmePages(): [file: string, text: string][] {
  const readme = readFileSync('README.md', 'utf8');
  return Object.entries(PAGES).map(([file, [first, ...rest]]) => {
    const more = rest.map((title) => `## ${title}\n\n${section(readme, title)}`);
    return [`${file}.md`, forSite([`# ${first}`, section(readme, first!), ...more].join('\n\n'))];
  });
}
