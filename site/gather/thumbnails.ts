// Pictures of the gallery's scenes, taken while they run. What a scene's text has not changed is taken from the last time,
// so that a second build costs nothing; where there is no browser its page shows a plain tile.
//   node --import tsx site/gather/thumbnails.ts      takes those that are missing
import { createHash } from 'node:crypto';
import { cpSync, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { chromium, type Browser } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium } from '../../tools/test/browsers.js';
// @ts-expect-error plain JavaScript
import { serve } from '../../tools/docs/static-files.js';
import { GALLERY } from '../.vitepress/gallery.js';
import { frame } from '../markdown/frame.js';

const PUBLIC = 'site/public';
const KEPT = 'site/.vitepress/cache/thumbnails';
const PORT = 6246;

/** Pixels: twice what a tile shows on a desk. */
const SIZE = { width: 640, height: 400 };

/** Seconds that a scene runs before its picture, where its page says nothing else. */
const AFTER = 2;

/** Milliseconds that a page may take to load, on a machine that is busy with other things. */
const LONGEST = 120_000;

interface Scene {
  name: string;
  html: string;
  after: number;
  /** Where its picture is kept: another text, another name. */
  kept: string;
}

const FENCE = /^```html live[^\n]*\n([^]*?)\n```$/m;

const hashOf = (...texts: string[]): string =>
  createHash('sha256').update(texts.join('\0')).digest('hex').slice(0, 16);

function sceneOf(name: string): Scene {
  const page = readFileSync(`site/gallery/${name}.md`, 'utf8');
  const html = frame(FENCE.exec(page)![1]!, '/');
  const after = Number(/^after: (.*)$/m.exec(page)?.[1] ?? AFTER);
  const hash = hashOf(html, readFileSync('site/markdown/frame.css', 'utf8'), String(after));
  return { name, html, after, kept: `${KEPT}/${name}-${hash}.jpg` };
}

/** Runs in the page: its world, as far as it is to be seen, and still. */
const RUN = async (after: number): Promise<void> => {
  const x3d = document.querySelector('x3d') as unknown as { runtime: { triggerRedraw(): void } };
  const { worldOf } = await import('/x3d-physics/x3d-physics.js' as string);
  const world = worldOf(document.querySelector('x3d-rigid-body'));
  await world.ready;
  world.paused = true;
  // Piece by piece: what a scene does by its script comes in between.
  for (let time = 0; time < after; time += 0.1) {
    world.advance(0.1);
    await new Promise((done) => setTimeout(done));
  }
  // What is drawn is what the last frames knew.
  for (let i = 0; i < 4; i++) {
    x3d.runtime.triggerRedraw();
    await new Promise((done) => setTimeout(done, 100));
  }
};

async function take(browser: Browser, address: string, scene: Scene): Promise<void> {
  const tab = await browser.newPage({ viewport: SIZE, colorScheme: 'light' });
  tab.setDefaultTimeout(LONGEST);
  await tab.route('**/scene', (route) =>
    route.fulfill({ contentType: 'text/html', body: scene.html }),
  );
  await tab.goto(`${address}/scene`);
  // The scene alone: its buttons would be too small to read.
  await tab.addStyleTag({ content: 'body > :not(x3d) { display: none }' });
  await tab.evaluate(RUN, scene.after);
  await tab.screenshot({ path: scene.kept, type: 'jpeg', quality: 82 });
  await tab.close();
}

/** Two at a time: each wants a core for its picture. */
async function takeAll(scenes: Scene[]): Promise<void> {
  const executablePath = await ensureChromium();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  const { port, close } = await serve(PUBLIC, PORT);
  const left = [...scenes];
  const worker = async (): Promise<void> => {
    for (let scene = left.shift(); scene; scene = left.shift())
      await take(browser, `http://localhost:${port}`, scene).catch((error: Error) =>
        console.log(`The gallery has a plain tile for ${scene.name}: ${error.message}`),
      );
  };
  try {
    await Promise.all([worker(), worker()]);
  } finally {
    await browser.close();
    await close();
  }
}

const all = (): Scene[] => Object.keys(GALLERY).map(sceneOf);

/** Puts those that were taken before beside the site's other pictures. */
export function copyThumbnails(): void {
  mkdirSync(`${PUBLIC}/gallery`, { recursive: true });
  for (const { name, kept } of all())
    if (existsSync(kept)) cpSync(kept, `${PUBLIC}/gallery/${name}.jpg`);
}

async function main(): Promise<void> {
  const missing = all().filter(({ kept }) => !existsSync(kept));
  if (missing.length > 0) {
    try {
      await takeAll(missing);
    } catch (error) {
      console.log(`The gallery has plain tiles instead of pictures: ${(error as Error).message}`);
    }
  }
  copyThumbnails();
}

if (process.argv[1]?.endsWith('thumbnails.ts')) await main();
