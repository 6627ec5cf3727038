// Each scene, opened once: whether it runs, nothing is said in the console, axe finds nothing in its frame, and how it looks.
// One tab shows scenes after each other: what they share is read and compiled once.
import axe from 'axe-core';
import type { Browser, BrowserContext, Page as Tab } from 'playwright';
import { NARROW, ugly, WIDTH } from './look.js';
import { decoder, type Picture } from './picture.js';
import { broken } from './running.js';
import type { Scene } from './sources.js';

/** What is wrong with scenes: as they run, and as they look. */
export interface Faults {
  running: string[];
  looks: string[];
}

/** Of a frame: what holds of whole pages (headings, landmarks) its page answers for. In a scene nothing is text or control. */
const AXE = `axe.run({ exclude: 'scene' }, { resultTypes: ['violations'], runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'] })
  .then(({ violations }) => violations.map(({ id, nodes }) => id + ' at ' + nodes[0].target.join(' ')))`;

async function inaccessible(
  tab: Tab,
  height: number,
  colorScheme: 'light' | 'dark',
): Promise<string[]> {
  await tab.setViewportSize({ width: WIDTH, height });
  await tab.addScriptTag({ content: axe.source });
  await tab.emulateMedia({ colorScheme });
  const found = (await tab.evaluate(AXE)) as string[];
  return found.map((fault) => `axe, ${colorScheme}: ${fault}`);
}

/** The graphics card's driver, not the page. */
const OF_DRIVER = /GL Driver Message|GPU stall|swiftshader/i;

/** A piece of markup names what its author has elsewhere: so says the console. */
const ELSEWHERE_SAID = /waiting-for-geometry|unknown-reference|not-in-collider|no-body/;

/** Hears what goes wrong in a tab; the answer says whose faults it is from now on. */
function hear(tab: Tab): (scene: Scene, faults: string[]) => void {
  let scene: Scene;
  let faults: string[] = [];
  tab.on('pageerror', (error) => faults.push(error.message));
  tab.on('console', (line) => {
    // A frame asks for no icon; opened by itself it does.
    const icon = line.location().url.endsWith('/favicon.ico');
    const said = /error|warning/.test(line.type()) && !icon && !OF_DRIVER.test(line.text());
    if (said && (scene.moves || !ELSEWHERE_SAID.test(line.text()))) faults.push(line.text());
  });
  tab.on('response', (answer) => {
    if (answer.status() >= 400) faults.push(`${answer.status()} ${answer.url()}`);
  });
  return (nextScene, nextFaults) => ([scene, faults] = [nextScene, nextFaults]);
}

/** Where scenes follow each other. */
interface Viewer {
  tab: Tab;
  address: string;
  read: (png: Buffer) => Promise<Picture>;
}

const failure = (error: Error): string[] => [error.message];

/** All frames are alike but for their scenes: axe looks at half of them in the dark. */
async function look(
  { tab, address, read }: Viewer,
  scene: Scene,
  scheme: 'light' | 'dark',
  { running, looks }: Faults,
): Promise<void> {
  const { path, height, live, moves } = scene;
  await tab.emulateMedia({ colorScheme: 'light' });
  await tab.setViewportSize({ width: NARROW, height });
  await tab.goto(address + path);
  running.push(...(await broken(tab, scene).catch(failure)));
  if (live) looks.push(...(await ugly(tab, scene, read).catch(failure)));
  if (moves) running.push(...(await inaccessible(tab, height, scheme)));
}

async function lookAll(context: BrowserContext, address: string, left: Scene[]): Promise<Faults> {
  const all: Faults = { running: [], looks: [] };
  const viewer = { read: await decoder(context), tab: await context.newPage(), address };
  const listen = hear(viewer.tab);
  for (let scene = left.shift(); scene; scene = left.shift()) {
    const { name } = scene;
    const found: Faults = { running: [], looks: [] };
    listen(scene, found.running);
    await look(viewer, scene, left.length % 2 ? 'dark' : 'light', found).catch((error: Error) =>
      found.running.push(error.message),
    );
    all.running.push(...found.running.map((fault) => `${name}: ${fault}`));
    all.looks.push(...found.looks.map((fault) => `${name}: ${fault}`));
  }
  return all;
}

/** Two at a time: each wants a core for its picture. */
export async function wrong(browser: Browser, address: string, scenes: Scene[]): Promise<Faults> {
  const left = [...scenes];
  const worker = async (): Promise<Faults> => {
    const context = await browser.newContext();
    const found = await lookAll(context, address, left);
    await context.close();
    return found;
  };
  const both = await Promise.all([worker(), worker()]);
  return {
    running: both.flatMap(({ running }) => running),
    looks: both.flatMap(({ looks }) => looks),
  };
}
