// How a page of the site arrives: what it weighs, when something is seen, and what moves meanwhile by itself.
import { existsSync, statSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Frame, Page as Tab, Request } from 'playwright';
import { CHROMIUM_ARGUMENTS } from '../test/browsers.js';

/**
 * For a browser whose arrivals are counted: all that a page loads is heard. A sandbox in a process of its own has mostly asked
 * for its first files before anyone listens there.
 */
export const ARRIVAL_ARGUMENTS = [
  ...CHROMIUM_ARGUMENTS,
  '--disable-features=IsolateSandboxedIframes',
];

/** A visitor: a window, and a line as Lighthouse takes it for its two kinds of device. */
export interface Visitor {
  name: string;
  width: number;
  height: number;
  /** Of the line: kilobits a second, and milliseconds there and back. */
  speed: number;
  latency: number;
}

/** https://github.com/GoogleChrome/lighthouse/blob/main/docs/throttling.md: slow 4G, and cable. */
export const VISITORS: readonly Visitor[] = [
  { name: 'phone', width: 390, height: 844, speed: 1638, latency: 150 },
  { name: 'desk', width: 1280, height: 800, speed: 10240, latency: 40 },
];

export interface Arrival {
  /**
   * Bytes as a server sends them that has the packed files of the package, and of how many files; what the page asks for
   * once more and has already is none. Frames below the window are left out: how early they are fetched, browsers choose
   * by the line that they guess they have (https://web.dev/articles/iframe-lazy-loading).
   */
  bytes: number;
  files: number;
  /** Of them the bytes without which nothing is drawn: the page's own text and what that waits for. */
  before: number;
  /** Milliseconds to the first word or picture, and to the largest. */
  first: number;
  largest: number;
  /** Cumulative layout shift: https://web.dev/articles/cls. Up to 0.1 is called good. */
  shift: number;
  /** Of what moved by itself: its class or tag, from where to where, pixels. */
  moved: string[];
}

/** What a page has seen so far. */
type Watched = Pick<Arrival, 'largest' | 'shift' | 'moved'>;

/** Put into a page before its own scripts: as text, since what compiles us may name functions by one of its own. */
const WATCH = `
  const watched = (window.watched = { largest: 0, shift: 0, moved: [] });
  const each = (type, see) =>
    new PerformanceObserver((list) => list.getEntries().forEach(see)).observe({ type, buffered: true });
  each('largest-contentful-paint', ({ startTime }) => (watched.largest = startTime));
  each('layout-shift', ({ value, hadRecentInput, sources }) => {
    if (hadRecentInput) return;
    watched.shift += value;
    for (const { node, previousRect: from, currentRect: to } of sources)
      watched.moved.push(\`\${node?.className || node?.nodeName} from \${from.x}, \${from.y} to \${to.x}, \${to.y}\`);
  });`;

/** As far as the page is now. Chromium says what a page waits for before it draws anything. */
const LOOK = `({
  ...watched,
  first: performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? Infinity,
  before: [...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')]
    .filter(({ entryType, renderBlockingStatus }) => entryType === 'navigation' || renderBlockingStatus === 'blocking')
    .reduce((sum, { encodedBodySize }) => sum + encodedBodySize, 0),
})`;

/** In the window, or the page itself. */
async function isSeen(frame: Frame, height: number): Promise<boolean> {
  if (!frame.parentFrame()) return true;
  const element = await frame.frameElement();
  const box = await element.boundingBox();
  return !!box && box.y < height;
}

/** Bytes of what came: of the packed file in `folder`, where the server of the tests packs nothing. */
async function sizeOf(request: Request, folder: string): Promise<number> {
  const { responseBodySize: sent } = await request.sizes();
  const { pathname } = new URL(request.url());
  const packed = join(folder, `${pathname}.br`);
  // None: it was there already.
  return sent && pathname.endsWith('.wasm') && existsSync(packed) ? statSync(packed).size : sent;
}

async function slowDown(tab: Tab, { speed, latency }: Visitor): Promise<void> {
  const session = await tab.context().newCDPSession(tab);
  const bytesPerSecond = (speed * 1000) / 8;
  await session.send('Network.enable');
  await session.send('Network.emulateNetworkConditions', {
    offline: false,
    latency,
    downloadThroughput: bytesPerSecond,
    uploadThroughput: bytesPerSecond,
  });
}

/**
 * Opens `address` + `path` as that visitor and looks until nothing has come for `quiet` milliseconds. `slow`: by the
 * visitor's line.
 */
export async function arrivalOf(
  browser: Browser,
  site: { address: string; folder: string },
  path: string,
  visitor: Visitor,
  { quiet, slow }: { quiet: number; slow: boolean },
): Promise<Arrival> {
  const { width, height } = visitor;
  const context = await browser.newContext({ viewport: { width, height } });
  const tab = await context.newPage();
  if (slow) await slowDown(tab, visitor);
  const sizes = new Map<Frame, Promise<number>[]>();
  let last = performance.now();
  const count = (request: Request): void => {
    last = performance.now();
    if (!request.url().startsWith(site.address)) return;
    const frame = request.frame();
    sizes.set(frame, [...(sizes.get(frame) ?? []), sizeOf(request, site.folder)]);
  };
  tab.on('requestfinished', count);
  await tab.addInitScript(WATCH);
  await tab.goto(site.address + path);
  while (performance.now() - last < quiet) await tab.waitForTimeout(100);
  tab.off('requestfinished', count);
  const bytes: number[] = [];
  for (const [frame, ofFrame] of sizes)
    if (await isSeen(frame, height))
      bytes.push(...(await Promise.all(ofFrame)).filter((size) => size > 0));
  const seen = await tab.evaluate<Watched & Pick<Arrival, 'first' | 'before'>>(LOOK);
  await context.close();
  return { ...seen, bytes: bytes.reduce((all, each) => all + each, 0), files: bytes.length };
}
