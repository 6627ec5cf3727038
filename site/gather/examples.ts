// The scenes that the playground opens: those of the stories and of the site's own pages, from where they are written.
import { readdirSync, readFileSync } from 'node:fs';
import { basename } from 'node:path';
import type { TemplateResult } from 'lit';
import { createServer, type ViteDevServer } from 'vite';
import { sceneOf } from '../../stories/reference/markup.js';
import { grown } from './grown.js';

export interface Example {
  group: string;
  name: string;
  markup: string;
}

interface Story {
  name?: string;
  args?: object;
  render?: (args: object) => unknown;
}

interface Stories extends Record<string, Story> {
  default: Story & { title?: string };
}

/** Stories that are pages, or show them: stories/pages has these as files. */
const PAGES = /^(Scenes|In XHTML)/;
const SHOWS_PAGES = 'Monitor';

const isTemplate = (value: unknown): value is TemplateResult =>
  typeof value === 'object' && value !== null && 'strings' in value;

/** `DebugDrawing` is Debug drawing. */
const inWords = (name: string): string =>
  name.replaceAll(/(?<=.)[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);

/** A node's main story has the node's name. */
function nameOf(name: string, node: string | undefined): string {
  if (name === node) return node;
  const words = /^\w+$/.test(name) ? inWords(name) : name;
  return node ? `${node}: ${words}` : words;
}

function examplesIn({ default: meta, ...stories }: Stories): Example[] {
  if (PAGES.test(meta.title!)) return [];
  return Object.entries(stories)
    .filter(([name]) => name !== SHOWS_PAGES)
    .flatMap(([name, story]) => {
      const shown = (story.render ?? meta.render)!({ ...meta.args, ...story.args });
      const markup = isTemplate(shown) ? sceneOf(shown) : undefined;
      const [group, node] = meta.title!.split('/') as [string, string?];
      return markup ? [{ group, name: nameOf(story.name ?? name, node), markup }] : [];
    });
}

async function ofStories(server: ViteDevServer): Promise<Example[]> {
  const files = readdirSync('stories').filter((file) => file.endsWith('.stories.ts'));
  const modules = await Promise.all(files.map((file) => server.ssrLoadModule(`/stories/${file}`)));
  return modules.flatMap((module) => examplesIn(module as Stories));
}

/** What stands in it without the page around. */
const X3D = /^( *)<x3d[^]*?<\/x3d>/im;
/** Files beside the pages, at the address that the site has them at. */
const ASSETS = '../../stories/assets/';

function ofFile(group: string, file: string): Example {
  const text = grown(basename(file), readFileSync(file, 'utf8'));
  const [markup, indent] = X3D.exec(text)!;
  const title = /<title>(.*)<\/title>/.exec(text)?.[1];
  const name = title ?? basename(file, '.html').replaceAll('-', ' ');
  return {
    group,
    name: name[0]!.toUpperCase() + name.slice(1),
    markup: markup.replaceAll(new RegExp(`^${indent}`, 'gm'), '').replaceAll(ASSETS, 'scenes/'),
  };
}

const ofFolder = (group: string, folder: string, type = '.html'): Example[] =>
  readdirSync(folder)
    .filter((file) => file.endsWith(type))
    .map((file) => ofFile(group, `${folder}/${file}`));

/** Fences of `html live` that show a scene without a script of its own. */
const LIVE = /^```html live[^\n"]*(?:"([^"]+)")?[^\n]*\n([^]*?)^```/gm;

function ofPages(group: string, folder: string): Example[] {
  return readdirSync(folder)
    .filter((file) => file.endsWith('.md'))
    .flatMap((file) => {
      const text = readFileSync(`${folder}/${file}`, 'utf8');
      const heading = /^# (.*)$/m.exec(text)?.[1] ?? file;
      return [...text.matchAll(LIVE)]
        .filter(([, , markup]) => !markup!.includes('<script'))
        .map(([, title, markup]) => ({ group, name: title ?? heading, markup: markup! }));
    });
}

export async function examples(): Promise<Example[]> {
  const server = await createServer({
    configFile: false,
    appType: 'custom',
    logLevel: 'error',
    server: { middlewareMode: true, watch: null, ws: false },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    return [
      ...ofFolder('First', 'examples'),
      ...ofFolder('Scenes', 'stories/pages'),
      ...ofFolder('Scenes as X3D', 'stories/pages', '.xhtml'),
      ...(await ofStories(server)),
      ...ofPages('Guide', 'site/guide'),
      ...ofPages('Recipes', 'site/recipes'),
    ];
  } finally {
    await server.close();
  }
}
