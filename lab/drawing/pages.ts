import { readFileSync } from 'node:fs';
import { chromium, type Browser, type Page } from 'playwright';
// @ts-expect-error plain JavaScript
import { CHROMIUM_ARGUMENTS, findChromium } from '../../tools/test/browsers.js';
// @ts-expect-error plain JavaScript
import { findFile } from '../../tools/docs/static-files.js';
import type { Measure } from './in-page/index.js';
import { inPageBundle } from '../in-page-bundle.js';

const HOST = 'http://lab.test';
const PATIENCE = 120_000;

/** Runs in the page: whether it moves, with as many batches. */
function isThere(batches: number): boolean {
  type Moving = Element & { world?: { time: number; stats: { batches?: number } } };
  const world = document.querySelector<Moving>('x3d-rigid-body-collection')?.world;
  return !!world && world.time > 0.1 && (world.stats.batches ?? 0) >= batches;
}

/** A browser whose pages have `measure`; no network is needed. */
export class Pages {
  readonly #browser: Browser;
  readonly #script: string;

  private constructor(browser: Browser, script: string) {
    this.#browser = browser;
    this.#script = script;
  }

  static async open(): Promise<Pages> {
    const executablePath = (await findChromium()) as string;
    const args = CHROMIUM_ARGUMENTS as string[];
    return new Pages(
      await chromium.launch({ executablePath, args }),
      await inPageBundle('lab/drawing/in-page/index.ts'),
    );
  }

  /** What is measured in a page of its own, once so many batches move there. */
  async measure<T>(html: string, batches: number, ask: (page: Page) => Promise<T>): Promise<T> {
    const page = await this.#browser.newPage();
    await page.route(`${HOST}/**`, async (route) => {
      const { pathname } = new URL(route.request().url());
      if (pathname === '/') return route.fulfill({ contentType: 'text/html', body: html });
      const found = findFile('.', pathname) as { file: string; type: string } | undefined;
      if (!found) return route.fulfill({ status: 404 });
      return route.fulfill({ contentType: found.type, body: readFileSync(found.file) });
    });
    await page.addInitScript(this.#script);
    await page.goto(HOST);
    await page.waitForFunction(isThere, batches, { timeout: PATIENCE });
    const found = await ask(page);
    await page.close();
    return found;
  }

  close(): Promise<void> {
    return this.#browser.close();
  }
}

declare global {
  interface Window {
    measure: Measure;
  }
}
