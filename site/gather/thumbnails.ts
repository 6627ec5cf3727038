// Pictures of the gallery's scenes, and smaller ones of all others that the playground's menu opens, taken while they run.
// What a scene's text has not changed is taken from the last time, so that a second build costs nothing; where there is no
// browser a page shows a plain tile, and the menu names alone.
//   node --import tsx site/gather/thumbnails.ts      takes those that are missing
import { createHash } from 'node:crypto';
import { cpSync, existsSync, readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { chromium, type Page as Tab } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium } from '../../tools/test/browsers.js';
// @ts-expect-error plain JavaScript
import { serve } from '../../tools/docs/static-files.js';
import { GALLERY } from '../.vitepress/gallery.js';
import { frame } from '../markdown/frame.js';
import type { Example } from './examples.js';

const PUBLIC = 'site/public';
/** What the playground's menu opens, in the public folder. */
export const MENU = 'scenes/examples.json';
const KEPT = 'site/.vitepress/cache/thumbnails';
const PORT = 6246;

/** Pixels: twice what a tile shows on a desk. */
const SIZE = { width: 640, height: 400 };
/** And in the menu, where a picture has 72 x 45. */
const SMALL = { width: 240, height: 150 };

/** Seconds that a scene runs before its picture, where its page says nothing else. */
const AFTER = 2;
/** And one that is looked at as small as in the menu: what falls is still on its way. */
const SOON = 0.8;

/** Milliseconds that a page may take to load, on a machine that is busy with other things. */
const LONGEST = 120_000;

interface Scene {
  /** Of its picture, from where the site lies. */
  path: string;
  html: string;
  size: typeof SIZE;
  after: number;
  /** Where its picture is kept: another text, another name. */
  kept: string;
}

const FENCE = /^```html live[^\n]*\n([^]*?)\n```$/m;

const hashOf = (...texts: string[]): string =>
  createHash('sha256').update(texts.join('\0')).digest('hex').slice(0, 16);

const STYLE = 'site/markdown/frame.css';

function sceneOf(path: string, markup: string, size: typeof SIZE, after: number): Scene {
  const html = frame(markup, '/');
  const hash = hashOf(html, readFileSync(STYLE, 'utf8'), String(after), JSON.stringify(size));
  return { path, html, size, after, kept: `${KEPT}/${basename(path, '.jpg')}-${hash}.jpg` };
}

function ofGallery(name: string): Scene {
  const page = readFileSync(`site/gallery/${name}.md`, 'utf8');
  const after = Number(/^after: (.*)$/m.exec(page)?.[1] ?? AFTER);
  return sceneOf(`gallery/${name}.jpg`, FENCE.exec(page)![1]!, SIZE, after);
}

/** A scene's own size: there it is as large as its picture. */
const OWN_SIZE = /(?<=<x3d\b[^>]*)\s(?:width|height|style)="[^"]*"/gi;

/** What ends itself, as in XML: in a page of HTML it would go on. */
const ENDED = /<([\w-]+)((?:\s[^<>]*)?)\/>/g;

/** Those that have no page in the gallery. */
const ofMenu = ({ picture, markup }: Example): Scene =>
  sceneOf(picture, markup.replaceAll(OWN_SIZE, '').replaceAll(ENDED, '<$1$2></$1>'), SMALL, SOON);

interface X3D {
  runtime: { triggerRedraw(): void; canvas: { doc: { downloadCount: number } } };
}

/** Runs in the page: its world, as far as it is to be seen, and still. */
const RUN = async (after: number): Promise<void> => {
  const x3d = document.querySelector('x3d') as unknown as X3D;
  const { worldOf } = await import('/x3d-physics/x3d-physics.js' as string);
  const world = worldOf(document.querySelector('x3d-rigid-body, RigidBody'));
  await world.ready;
  // What comes from files of its own, for some seconds at most.
  for (let i = 0; i < 600 && x3d.runtime.canvas.doc.downloadCount > 0; i++)
    await new Promise(requestAnimationFrame);
  world.paused = true;
  // Piece by piece: what a scene does by its script comes in between.
  for (let time = 0; time < after; time += 0.1) {
    world.advance(0.1);
    await new Promise((done) => setTimeout(done));
  }
  // What is drawn is what the last frames knew.
  for (let i = 0; i < 4; i++) {
    x3d.runtime.triggerRedraw();
    await new Promise(requestAnimationFrame);
  }
};

async function take(tab: Tab, address: string, scene: Scene): Promise<void> {
  await tab.setViewportSize(scene.size);
  await tab.goto(address + pathOf(scene));
  // The scene alone: its buttons would be too small to read, and nothing is to be seen of its loading.
  await tab.addStyleTag({
    content: 'body > :not(x3d), .x3dom-progress { display: none !important }',
  });
  await tab.evaluate(RUN, scene.after);
  await tab.screenshot({ path: scene.kept, type: 'jpeg', quality: 82 });
}

/** Where it runs: beside the site's own pages. */
const pathOf = ({ kept }: Scene): string => `/${basename(kept, '.jpg')}.html`;

/** Two at a time: each wants a core for its picture. Scenes follow in the same tab: what they share is compiled once. */
async function takeAll(scenes: Scene[]): Promise<void> {
  const executablePath = await ensureChromium();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  const made = Object.fromEntries(scenes.map((scene) => [pathOf(scene), scene.html]));
  const { port, close } = await serve(PUBLIC, PORT, made);
  const left = [...scenes];
  const worker = async (): Promise<void> => {
    const tab = await browser.newPage({ colorScheme: 'light' });
    tab.setDefaultTimeout(LONGEST);
    for (let scene = left.shift(); scene; scene = left.shift())
      await take(tab, `http://localhost:${port}`, scene).catch((error: Error) =>
        console.log(`There is no picture ${scene.path}: ${error.message}`),
      );
  };
  try {
    await Promise.all([worker(), worker()]);
  } finally {
    await browser.close();
    await close();
  }
}

const all = (): Scene[] => {
  const menu = JSON.parse(readFileSync(`${PUBLIC}/${MENU}`, 'utf8')) as Example[];
  const others = menu.filter(({ picture }) => !picture.startsWith('gallery/'));
  return [...Object.keys(GALLERY).map(ofGallery), ...others.map(ofMenu)];
};

/** Puts those that were taken before beside the site's other pictures. */
export function copyThumbnails(): void {
  for (const { path, kept } of all())
    if (existsSync(kept)) cpSync(kept, `${PUBLIC}/${path}`, { recursive: true });
}

async function main(): Promise<void> {
  const missing = all().filter(({ kept }) => !existsSync(kept));
  if (missing.length > 0) {
    try {
      await takeAll(missing);
    } catch (error) {
      console.log(`There are no pictures of scenes: ${(error as Error).message}`);
    }
  }
  copyThumbnails();
}

if (process.argv[1]?.endsWith('thumbnails.ts')) await main();
