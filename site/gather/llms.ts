// llms.txt and llms-full.txt: the site for programs that read, by the proposal of llmstxt.org.
import { existsSync, readFileSync } from 'node:fs';
import { sidebar } from '../.vitepress/sidebar.js';

interface Entry {
  text?: string;
  link?: string;
  items?: Entry[];
}

const HEAD = `# x3d-physics

> The rigid body physics of the X3D standard for X3DOM, as custom elements on Ammo (Bullet as WebAssembly). One tag per X3D node; edits of attributes patch the running world.
`;

/** Where a page's text lies; undefined for what is no page of the site. */
const sourceOf = (link: string): string | undefined =>
  [`site${link}.md`, `site/generated${link}.md`].find((file) => existsSync(file));

const textOf = (file: string): string =>
  readFileSync(file, 'utf8')
    .replace(/^---\n[^]*?\n---\n/, '')
    .trim();

const pagesOf = ({ items = [] }: Entry) =>
  items.flatMap(({ text, link }) => {
    const file = link && sourceOf(link);
    return file ? [{ text, link, file }] : [];
  });

function section(room: Entry): string {
  const lines = pagesOf(room).map(({ text, link }) => `- [${text}](${link}.html)`);
  return [`## ${room.text}\n`, ...lines].join('\n');
}

export function llmsTexts(nodes: string[]): { short: string; full: string } {
  const rooms: Entry[] = sidebar(nodes);
  return {
    short: [HEAD, ...rooms.map(section)].join('\n\n') + '\n',
    full: [HEAD, ...rooms.flatMap(pagesOf).map(({ file }) => textOf(file))].join('\n\n') + '\n',
  };
}
