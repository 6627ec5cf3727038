import { readFileSync } from 'node:fs';
// @ts-expect-error plain JavaScript
import { findFile } from '../../tools/docs/static-files.js';
import { AskedBrowser, type Answer, type AskedPages } from '../run/asked-browser.js';
import type { Asked, Found } from './asked.js';
import { libraryOf } from './libraries/index.js';
import { SCENES } from './scene.js';
import { inPageBundle } from '../in-page-bundle.js';

/** The driver's page; frames lie side by side, all in sight. */
const DRIVER = `<!DOCTYPE html><meta charset="utf-8"><title>Pages</title>
<style>body { margin: 0 } iframe { width: 250px; height: 190px; border: 0 }</style>
<script type="module" src="/driver.js"></script>`;

export interface PageName {
  library: string;
  scene: string;
  count: number;
}

export const addressOf = ({ library, scene, count }: PageName): string =>
  `/page?${new URLSearchParams({ library, scene, count: String(count) })}`;

/** Each page loads all of its files anew, and its clock is as fine as the browser has it: it shares nothing. */
const headers = {
  'cache-control': 'no-store',
  'cross-origin-opener-policy': 'same-origin',
  'cross-origin-embedder-policy': 'require-corp',
};

/** The page of a scene, or the file beside it. */
function sceneAt({ pathname, search, searchParams }: URL): Answer | undefined {
  if (pathname !== '/page' && pathname !== '/file') return undefined;
  const library = libraryOf(searchParams.get('library')!);
  const scene = SCENES[searchParams.get('scene')!]!(Number(searchParams.get('count')));
  if (pathname === '/file') return ['model/x3d+xml', library.file!(scene)];
  return [library.type, library.page(scene, `/page${search}`)];
}

function fileAt(path: string): Answer | undefined {
  const found = findFile('.', path) as { file: string; type: string } | undefined;
  return found && [found.type, readFileSync(found.file)];
}

/** All that a browser asks for while it is measured, and no network: `scripts` are bundled, by their paths. */
export async function pagesWith(
  scripts: Readonly<Record<string, string>>,
  answerAt: (address: URL) => Answer | undefined,
): Promise<AskedPages> {
  const own: Record<string, Answer> = { '/': ['text/html', DRIVER] };
  const all = { '/driver.js': 'lab/page/in-page/driver.ts', ...scripts };
  for (const [path, file] of Object.entries(all))
    own[path] = ['text/javascript', await inPageBundle(file)];
  const answer = (url: string): Answer | undefined => {
    const address = new URL(url, 'http://localhost');
    return own[address.pathname] ?? answerAt(address) ?? fileAt(address.pathname);
  };
  return { answer, headers, draws: true };
}

export const makePages = (): Promise<AskedPages> =>
  pagesWith({ '/hooks.js': 'lab/page/in-page/hooks.ts' }, sceneAt);

/** Milliseconds that one question may take. */
const PATIENCE = 10 * 60_000;

/** A browser at the driver's page. */
export class MeasuredBrowser {
  readonly #browser: AskedBrowser;

  private constructor(browser: AskedBrowser) {
    this.#browser = browser;
  }

  static async open(name: string, pages: AskedPages): Promise<MeasuredBrowser> {
    return new MeasuredBrowser(await AskedBrowser.open(name, pages));
  }

  /** As it says itself, once it was asked. */
  get version(): string {
    return this.#browser.version;
  }

  async ask(asked: Asked): Promise<Found> {
    return JSON.parse(await this.#browser.ask(JSON.stringify(asked), PATIENCE)) as Found;
  }

  close(): Promise<void> {
    return this.#browser.close();
  }
}

/** Asks a browser that is opened for it: one that has shown dozens of pages has gigabytes of them left, and may hang. */
export async function asking<T>(
  name: string,
  pages: AskedPages,
  ask: (browser: MeasuredBrowser) => Promise<T>,
) {
  const browser = await MeasuredBrowser.open(name, pages);
  const found = await ask(browser);
  await browser.close();
  return { found, version: browser.version };
}
