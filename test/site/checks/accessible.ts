// What axe finds on a page: in light and dark, on a desk and on a phone. A page that somebody wrote is looked at in light on
// the one and in dark on the other, its neighbour the other way round; pages that are made by one pattern in one way each, one
// after the other: what pages have in common is seen in all four.
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

/** Scenes and words by one pattern: half of all pages. */
const MADE = /\/(gallery|recipes|reference)\//;

/** How the page of this number is looked at. */
function looksAt({ path }: Page, i: number): readonly Look[] {
  const both = LOOKS[i % 2]!;
  return MADE.test(path) ? [both[(i >> 1) % 2]!] : both;
}

/** Scenes are looked at by themselves. */
const RUN = `axe.run(document, { iframes: false, resultTypes: ['violations'] }).then(({ violations }) =>
  violations.map(({ id, nodes }) => id + ' at ' + nodes.slice(0, 3).map(({ target }) => target.join(' ')).join(', ')))`;

async function look(tab: Tab, what: string): Promise<string[]> {
  const found = (await tab.evaluate(RUN)) as string[];
  return found.map((fault) => `${what}: ${fault}`);
}

async function faultsOf(
  tab: Tab,
  address: string,
  path: string,
  looks: readonly Look[],
): Promise<string[]> {
  await tab.goto(address + path);
  await tab.waitForFunction(() => '__vue_app__' in document.querySelector('#app')!);
  await tab.addScriptTag({ content: axe.source });
  const found: string[] = [];
  for (const [width, dark] of looks) {
    await tab.setViewportSize({ width, height: 900 });
    await tab.evaluate((on) => document.documentElement.classList.toggle('dark', on), dark);
    found.push(...(await look(tab, `${path} ${dark ? 'dark' : 'light'} ${width}`)));
  }
  return found;
}

/** What scenes are made of. Playwright's own way to leave out files has the browser keep none: each page would read all anew. */
const SCENES = ['*/x3dom/*', '*/x3d-physics/*', '*/stories/*'];

/** For one page after the other, without scenes: they would only take time. */
async function opened(context: BrowserContext): Promise<Tab> {
  const tab = await context.newPage();
  const session = await context.newCDPSession(tab);
  await session.send('Network.enable');
  await session.send('Network.setBlockedURLs', { urls: SCENES });
  return tab;
}

export async function inaccessible(browser: Browser, address: string, pages: Page[]) {
  const context = await browser.newContext({ reducedMotion: 'reduce' });
  const found = await Promise.all(
    [0, 1].map(async (half) => {
      const mine: string[] = [];
      const tab = await opened(context);
      const all = pages.filter((_, i) => i % 2 === half);
      for (const [i, page] of all.entries())
        mine.push(...(await faultsOf(tab, address, page.path, looksAt(page, i))));
      return mine;
    }),
  );
  await context.close();
  return found.flat();
}
