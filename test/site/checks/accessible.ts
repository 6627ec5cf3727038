// What axe finds on a page: in light and dark, on a desk and on a phone.
import axe from 'axe-core';
import type { Browser, BrowserContext, Page as Tab } from 'playwright';
import type { Page } from './pages.js';

const WIDTHS = [1280, 390];

/** Scenes are looked at by themselves. */
const RUN = `axe.run(document, { iframes: false, resultTypes: ['violations'] }).then(({ violations }) =>
  violations.map(({ id, nodes }) => id + ' at ' + nodes.slice(0, 3).map(({ target }) => target.join(' ')).join(', ')))`;

async function look(tab: Tab, what: string): Promise<string[]> {
  const found = (await tab.evaluate(RUN)) as string[];
  return found.map((fault) => `${what}: ${fault}`);
}

async function faultsOf(context: BrowserContext, address: string, path: string) {
  const tab = await context.newPage();
  await tab.goto(address + path);
  await tab.waitForFunction(() => '__vue_app__' in document.querySelector('#app')!);
  await tab.addScriptTag({ content: axe.source });
  const found: string[] = [];
  for (const width of WIDTHS) {
    await tab.setViewportSize({ width, height: 900 });
    for (const theme of ['light', 'dark']) {
      await tab.evaluate(
        (dark) => document.documentElement.classList.toggle('dark', dark),
        theme === 'dark',
      );
      found.push(...(await look(tab, `${path} ${theme} ${width}`)));
    }
  }
  await tab.close();
  return found;
}

/** Of a page without scenes: they would only take time. */
export async function inaccessible(browser: Browser, address: string, pages: Page[]) {
  const context = await browser.newContext({ reducedMotion: 'reduce' });
  await context.route(/\/(x3dom|x3d-physics|stories)\//, (route) => route.abort());
  const found = await Promise.all(
    [0, 1].map(async (half) => {
      const mine: string[] = [];
      for (const { path } of pages.filter((_, i) => i % 2 === half))
        mine.push(...(await faultsOf(context, address, path)));
      return mine;
    }),
  );
  await context.close();
  return found.flat();
}
