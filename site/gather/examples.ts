// The scenes that the playground opens: those of the stories and of the site's own pages, from where they are written.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename } from 'node:path';
import type { TemplateResult } from 'lit';
import { createServer, type ViteDevServer } from 'vite';
import { sceneOf } from '../../stories/reference/markup.js';
import { grown } from './grown.js';

export interface Example {
  /** In addresses: it stays as it is. */
  id: string;
  group: string;
  name: string;
  markup: string;
  /** Where the site has it, when it is built with pictures. */
  picture: string;
}

type Found = Omit<Example, 'id' | 'picture'> & Partial<Pick<Example, 'picture'>>;

interface Story {
  name?: string;
  args?: object;
  render?: (args: object) => unknown;
}

interface Stories extends Record<string, Story> {
  default: Story & { title?: string };
}

/** Stories that are pages, or show them: stories/pages has these as files. */
const PAGES = /^(Scenes|In XHTML|Start here)/;
/** What shows other scenes, what no one reads as text, and what is nothing without its story's buttons. */
const NOT_HERE = new Set(['Monitor', 'TwoThousandBodies', 'ManyBoxes', 'Auto']);

/** In the menu by another name than in the stories, where the group's name stands above it. */
const NAMES: Record<string, string> = {
  'Accuracy/Beside reference': 'A level beside the reference',
  'Accuracy/Chart': 'What each level costs',
  'Dragging/Pendulum': 'Drag a pendulum',
  'Dragging/Heap': 'Drag out of a heap',
  'Dragging/Modes': 'Three ways to drag',
  'Dragging/Keyboard': 'Drag by the keyboard',
  'Looking in/Events': 'Collisions as events',
  'Looking in/Raycast': 'What a ray meets',
  'Looking in/Snapshot': 'A snapshot, and back to it',
  'Looking in/Debug drawing': 'What Bullet has, drawn',
  'Shortcuts/for="ID"': 'A body that names what it moves',
  'Guide/Two bodies that name their Transforms': 'Two bodies that name what they move',
};

const GROUPS: Record<string, string> = {
  Guide: 'First steps',
  Shortcuts: 'First steps',
  Dragging: 'By hand',
  'Looking in': 'Looking inside',
};

const GALLERY = 'site/gallery';

/** As they stand in the menu; what is in none of them comes last. */
const ORDER = [
  ...['Gallery', 'First steps', 'Recipes', 'Scenes', 'By hand'],
  ...['Accuracy', 'Looking inside'],
];

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

function examplesIn({ default: meta, ...stories }: Stories): Found[] {
  if (PAGES.test(meta.title!)) return [];
  return Object.entries(stories)
    .filter(([name]) => !NOT_HERE.has(name))
    .flatMap(([name, story]) => {
      const shown = (story.render ?? meta.render)!({ ...meta.args, ...story.args });
      const markup = isTemplate(shown) ? sceneOf(shown) : undefined;
      const [group, node] = meta.title!.split('/') as [string, string?];
      return markup ? [{ group, name: nameOf(story.name ?? name, node), markup }] : [];
    });
}

async function ofStories(server: ViteDevServer): Promise<Found[]> {
  const files = readdirSync('stories').filter((file) => file.endsWith('.stories.ts'));
  const modules = await Promise.all(files.map((file) => server.ssrLoadModule(`/stories/${file}`)));
  return modules.flatMap((module) => examplesIn(module as Stories));
}

/** What stands in it without the page around. */
const X3D = /^( *)<x3d[^]*?<\/x3d>/im;
/** Files beside the pages, at the address that the site has them at. */
const ASSETS = '../../stories/assets/';

function ofFile(group: string, file: string): Found {
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

const ofFolder = (group: string, folder: string): Found[] =>
  readdirSync(folder)
    .filter((file) => file.endsWith('.html'))
    .map((file) => ofFile(group, `${folder}/${file}`));

/** Fences of `html live`. */
const LIVE = /^```html live[^\n"]*(?:"([^"]+)")?[^\n]*\n([^]*?)^```/gm;
const LIVE_FIRST = new RegExp(LIVE.source, 'm');

function ofPages(group: string, folder: string): Found[] {
  return readdirSync(folder)
    .filter((file) => file.endsWith('.md'))
    .flatMap((file) => {
      const text = readFileSync(`${folder}/${file}`, 'utf8');
      const heading = /^# (.*)$/m.exec(text)?.[1] ?? file;
      return [...text.matchAll(LIVE)].map(([, title, markup]) => ({
        group,
        name: title ?? heading,
        markup: markup!,
      }));
    });
}

/** A page for each: it is named as its page is. */
const ofGallery = (): Found[] =>
  readdirSync(GALLERY)
    .filter((file) => file.endsWith('.md'))
    .flatMap((file) => {
      const text = readFileSync(`${GALLERY}/${file}`, 'utf8');
      const [, name] = /^# (.*)$/m.exec(text) ?? [];
      const [, , markup] = LIVE_FIRST.exec(text) ?? [];
      const picture = `gallery/${basename(file, '.md')}.jpg`;
      return name && markup ? [{ group: 'Gallery', name, markup, picture }] : [];
    });

const idOf = (name: string): string =>
  name
    .toLowerCase()
    .replaceAll(/[^a-z0-9]+/g, '-')
    .replaceAll(/^-|-$/g, '');

const rankOf = ({ group }: Found): number =>
  ORDER.includes(group) ? ORDER.indexOf(group) : ORDER.length;

/** By names and groups of the menu. No name stands for two scenes, and no scene stands there twice. */
export function menuOf(found: readonly Found[]): Example[] {
  const named = found.map(({ group, name, ...rest }) => {
    const own = NAMES[`${group}/${name}`] ?? name;
    const id = idOf(own);
    const picture = `scenes/pictures/${id}.jpg`;
    return { id, group: GROUPS[group] ?? group, name: own, picture, ...rest };
  });
  for (const key of ['id', 'markup'] as const) {
    const seen = new Map<string, Example>();
    for (const each of named) {
      const twin = seen.get(each[key]);
      if (twin) throw new Error(`"${twin.name}" and "${each.name}" have the same ${key}.`);
      seen.set(each[key], each);
    }
  }
  return named.sort((a, b) => rankOf(a) - rankOf(b));
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
    return menuOf([
      ...(existsSync(GALLERY) ? ofGallery() : ofFolder('Scenes', 'stories/pages')),
      ofFile('First steps', 'site/playground/first.html'),
      ...ofFolder('First steps', 'examples'),
      ...ofPages('Guide', 'site/guide'),
      ...ofPages('Recipes', 'site/recipes'),
      // One in X3D's own tags, with a part from a file of its own.
      {
        ...ofFile('First steps', 'stories/pages/pendulum-and-motor.xhtml'),
        name: "A pendulum and a motor in X3D's own tags",
      },
      ...(await ofStories(server)),
    ]);
  } finally {
    await server.close();
  }
}
