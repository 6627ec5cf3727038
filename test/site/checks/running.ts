// Whether a scene runs: its world becomes ready, nothing is wrong with it, something moves, nothing is said in the console,
// and axe finds nothing in its frame.
import axe from 'axe-core';
import type { Browser, Page as Tab } from 'playwright';
import type { Scene } from './sources.js';

/** Milliseconds until a scene has to be ready and to have moved. */
const LATEST = 30_000;

/** Metres, or as many radians. */
const MOVED = 0.005;

interface State {
  poses: number[][];
  problems: string[];
}

/**
 * Runs in the page, of any build of the library: the first world's bodies, and what it complains of. A machine that is busy
 * with other things drops time.
 */
const stateOf = (library: string): string => `(async () => {
  const { worldOf } = globalThis.X3DPhysics ?? await import('${library}');
  const worlds = new Set();
  for (const element of document.querySelectorAll('x3d *')) {
    const world = worldOf(element);
    if (world) worlds.add(world);
  }
  await Promise.all([...worlds].map(({ ready }) => ready));
  const nodes = [...worlds].flatMap((world) => [...world.nodes]);
  return {
    poses: nodes.filter((node) => node.applyImpulse).map((node) => [...node.get('position'), ...node.get('orientation')]),
    problems: [...worlds].flatMap((world) =>
      world.problems.filter(({ code }) => code !== 'lag').map(({ code, message }) => code + ': ' + message)),
  };
})()`;

const state = (tab: Tab, { library }: Scene) => tab.evaluate(stateOf(library)) as Promise<State>;

const wayOf = (before: State, after: State): number =>
  Math.max(
    0,
    ...after.poses.flatMap((pose, i) =>
      pose.map((value, k) => Math.abs(value - (before.poses[i]?.[k] ?? value))),
    ),
  );

async function waitUntilMoved(tab: Tab, scene: Scene, start: State): Promise<State> {
  const end = Date.now() + LATEST;
  for (;;) {
    const now = await state(tab, scene);
    if (wayOf(start, now) > MOVED) return now;
    if (Date.now() > end) throw new Error('nothing moves');
    await tab.waitForTimeout(100);
  }
}

/** Of a frame: what holds of whole pages (headings, landmarks) its page answers for. */
const AXE = `axe.run(document, { resultTypes: ['violations'], runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'] })
  .then(({ violations }) => violations.map(({ id, nodes }) => id + ' at ' + nodes[0].target.join(' ')))`;

/** All frames are alike but for their scenes: half of them are looked at in the dark. */
async function accessible(
  tab: Tab,
  colorScheme: 'light' | 'dark',
  faults: string[],
): Promise<void> {
  await tab.addScriptTag({ content: axe.source });
  await tab.emulateMedia({ colorScheme });
  const found = (await tab.evaluate(AXE)) as string[];
  faults.push(...found.map((fault) => `axe, ${colorScheme}: ${fault}`));
}

/** The graphics card's driver, not the page. */
const OF_DRIVER = /GL Driver Message|GPU stall|swiftshader/i;

/** A piece of markup names what its author has elsewhere. */
const ELSEWHERE = /^(waiting-for-geometry|unknown-reference|not-in-collider|no-body)/;

/** The same in the console. */
const ELSEWHERE_SAID = /waiting-for-geometry|unknown-reference|not-in-collider|no-body/;

async function check(tab: Tab, scene: Scene, faults: string[]): Promise<void> {
  const { moves } = scene;
  // A story is put into its page when that is there.
  await tab.locator('x3d canvas').first().waitFor({ state: 'attached' });
  const start = await state(tab, scene);
  if (start.poses.length === 0) throw new Error('there are no bodies');
  const { problems } = await waitUntilMoved(tab, scene, start);
  faults.push(...(moves ? problems : problems.filter((problem) => !ELSEWHERE.test(problem))));
}

async function faultsOf(
  browser: Browser,
  address: string,
  scene: Scene,
  scheme: 'light' | 'dark',
): Promise<string[]> {
  const context = await browser.newContext({ viewport: { width: 640, height: 400 } });
  const tab = await context.newPage();
  const faults: string[] = [];
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
  const { html } = scene;
  if (html !== undefined)
    await tab.route(`**${scene.path}`, (route) =>
      route.fulfill({ contentType: 'text/html', body: html }),
    );
  try {
    await tab.goto(address + scene.path);
    await check(tab, scene, faults);
    if (scene.moves) await accessible(tab, scheme, faults);
  } catch (error) {
    faults.push((error as Error).message);
  }
  await context.close();
  return faults.map((fault) => `${scene.name}: ${fault}`);
}

/** Two at a time: each wants a core for its picture. */
export async function broken(browser: Browser, address: string, scenes: Scene[]) {
  const left = [...scenes];
  const worker = async (): Promise<string[]> => {
    const found: string[] = [];
    for (let scene = left.shift(); scene; scene = left.shift())
      found.push(...(await faultsOf(browser, address, scene, left.length % 2 ? 'dark' : 'light')));
    return found;
  };
  return (await Promise.all([worker(), worker()])).flat();
}
