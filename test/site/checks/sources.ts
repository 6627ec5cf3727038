// Scenes in the site's pages: those that run in them, and those that are only shown.
import { globSync } from '../../../tools/files.js';
import { readdirSync, readFileSync } from 'node:fs';
import { frame } from '../../../site/markdown/frame.js';

export interface Scene {
  name: string;
  /** Where it runs, from the site's root. */
  path: string;
  /** What the server is to answer there; undefined: the site has it. */
  html?: string;
  /** The library that it has, as a module. */
  library: string;
  /** Whether something in it is to move: a piece of markup may be all rest. */
  moves: boolean;
  /** Whether a page shows it running, and not only its markup. */
  live: boolean;
  /** Pixels, of its frame. */
  height: number;
}

/** Pixels, of a frame that does not say. */
const HEIGHT = 340;

const FENCE = /^```html([^\n]*)\n([^]*?)\n```$/gm;

/** Pages that were written for the site, with those that are gathered for it. */
const sources = (): string[] =>
  readdirSync('site', { recursive: true })
    .map((file) => `site/${String(file).replaceAll('\\', '/')}`)
    .filter((file) => file.endsWith('.md') && !file.startsWith('site/public/'));

/** The scripts of a whole page, from where the site has them. */
const served = (html: string): string =>
  html
    .replace(/src="[^"]*?x3dom\.js"/g, 'src="/x3dom/x3dom.js"')
    .replace(/src="[^"]*?(x3d-physics[\w.]*\.js)"/g, 'src="/x3d-physics/$1"');

/** A piece of a scene, with one body beside it that falls. */
const around = (piece: string): string => `<x3d><scene>${piece}
  <transform translation="0 9 0"><shape><sphere></sphere></shape><x3d-rigid-body></x3d-rigid-body></transform>
</scene></x3d>`;

function page(markup: string): string {
  if (/^<!doctype/i.test(markup)) return served(markup);
  return frame(/<x3d[\s>]/.test(markup) ? markup : around(markup), '/');
}

const isScene = (markup: string): boolean => /<x3d[\s>]|<x3d-/.test(markup);

export const scenes = (): Scene[] =>
  sources().flatMap((file) =>
    [...readFileSync(file, 'utf8').matchAll(FENCE)]
      .map(([, info, markup], i) => ({
        info: info!,
        markup: markup!,
        name: `${file} scene ${i + 1}`,
      }))
      .filter(({ markup }) => isScene(markup))
      .map(({ info, markup, name }) => ({
        name,
        path: `/${name.replace(/\W+/g, '-')}.html`,
        html: page(markup),
        library: '/x3d-physics/x3d-physics.js',
        moves: /^ live/.test(info) || /<x3d[\s>]/.test(markup),
        live: /^ live/.test(info),
        height: Number(/\d+/.exec(info)?.[0] ?? HEIGHT),
      })),
  );

const STORY = /<iframe class="live story"[^>]* height="(\d+)" title="([^"]+)" src="([^"]+)"/;

/** The story that the page of each node shows. */
export const stories = (): Scene[] =>
  globSync('site/generated/reference/*.md').map((file) => {
    const [, height, title, path] = STORY.exec(readFileSync(file, 'utf8'))!;
    const name = `${file}: ${title}`;
    return {
      name,
      path: path!,
      library: '/stories/dist/x3d-physics.js',
      moves: true,
      live: true,
      height: Number(height),
    };
  });
