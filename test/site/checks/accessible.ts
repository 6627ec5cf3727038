// What axe finds on a page: in light and dark, on a desk and on a phone. Each page is looked at in light on the one and in dark
// on the other, its neighbour the other way round: what pages have in common is seen in all four.
import axe from 'axe-core';
import type { Browser, BrowserContext, Page as Tab } from 'playwright';
import type { Page } from './pages.js';

type Look = readonly [width: number, dark: boolean];

const LOOKS: readonly (readonly Look[])[] = [
  [
    [1280, false],
    [390, true],
  ],
  [
    [1280, true],
    [390, false],
  ],
];

/** Scenes are looked at by themselves. */
const RUN = `axe.run(document, { iframes: false, resultTypes: ['violations'] }).then(({ violations }) =>
  violations.map(({ id, nodes }) => id + ' at ' + nodes.slice(0, 3).map(({ target }) => target.join(' ')).join(', ')))`;

async function look(tab: Tab, what: string): Promise<string[]> {
  const found = (await tab.evaluate(RUN)) as string[];
  return found.map((fault) => `${what}: ${fault}`);
}

async function faultsOf(
  context: BrowserContext,
  address: string,
  path: string,
  looks: readonly Look[],
): Promise<string[]> {
  const tab = await context.newPage();
  await tab.goto(address + path);
  await tab.waitForFunction(() => '__vue_app__' in document.querySelector('#app')!);
  await tab.addScriptTag({ content: axe.source });
  const found: string[] = [];
  for (const [width, dark] of looks) {
    await tab.setViewportSize({ width, height: 900 });
    await tab.evaluate((on) => document.documentElement.classList.toggle('dark', on), dark);
    found.push(...(await look(tab, `${path} ${dark ? 'dark' : 'light'} ${width}`)));
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
      const all = pages.filter((_, i) => i % 2 === half);
      for (const [i, { path }] of all.entries())
        mine.push(...(await faultsOf(context, address, path, LOOKS[i % 2]!)));
      return mine;
    }),
  );
  await context.close();
  return found.flat();
}
