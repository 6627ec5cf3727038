// Each scene of the gallery does what its page says: it runs in a browser, by the seconds of its world, all bodies stay finite
// and where there is something to see, nothing is wrong, and its end is the physical fact that is written down for it.
import { readFileSync } from 'node:fs';
import type { Browser } from 'playwright';
import { GALLERY } from '../../../site/.vitepress/gallery.js';
import { frame } from '../../../site/markdown/frame.js';
import { FACTS, type Fact } from './gallery-facts.js';

const FENCE = /^```html live[^\n]*\n([^]*?)\n```$/m;

/** Seconds between looks, and metres beyond which nothing is in the picture. */
const LOOK = 0.05;
const FAR = 1000;

/** Runs in the page; answers what is wrong. Between looks the page has time for its own scripts. */
const played = ({ seconds, first = '0', each = '0', holds }: Fact): string => `(async () => {
  const { worldOf } = await import('/x3d-physics/x3d-physics.js');
  const body = (id) => document.getElementById(id);
  const all = (selector) => [...document.querySelectorAll(selector)];
  const text = (id) => body(id).textContent;
  const world = worldOf(document.querySelector('x3d-rigid-body'));
  await world.ready;
  world.paused = true;
  const start = new Map(all('x3d-rigid-body').map((element) => [element, element.position]));
  const moved = (bodies) => bodies.map((one) => Math.hypot(...one.position.map((value, i) => value - start.get(one)[i])));
  const seen = [];
  ${first};
  // Not world.time: a scene may wait for code of what it adds.
  for (let look = 0; look < 4 * ${seconds / LOOK} && world.time < ${seconds}; look++) {
    world.advance(${LOOK});
    seen.push(${each});
    await new Promise((done) => setTimeout(done));
  }
  const places = all('x3d-rigid-body').map(({ position }) => position);
  // How busy this machine was before we paused is nothing of the scene.
  const wrong = world.problems.filter(({ code }) => code !== 'lag').map(({ code, message }) => code + ': ' + message);
  if (!places.flat().every((value) => Math.abs(value) < ${FAR})) wrong.push('a body is out of the world');
  if (!(${holds})) wrong.push('it is not so');
  return wrong;
})()`;

async function faultsOf(browser: Browser, address: string, name: string): Promise<string[]> {
  const fact = FACTS[name];
  if (!fact) return [`gallery/${name}: no fact says what it comes to`];
  const markup = FENCE.exec(readFileSync(`site/gallery/${name}.md`, 'utf8'))![1]!;
  const tab = await browser.newPage({ viewport: { width: 320, height: 200 } });
  const faults: string[] = [];
  tab.on('pageerror', (error) => faults.push(error.message));
  await tab.route('**/scene', (route) =>
    route.fulfill({ contentType: 'text/html', body: frame(markup, '/') }),
  );
  try {
    await tab.goto(`${address}/scene`);
    faults.push(...((await tab.evaluate(played(fact))) as string[]));
  } catch (error) {
    faults.push((error as Error).message);
  }
  await tab.close();
  return faults.map((fault) => `gallery/${name}, ${fact.says}: ${fault}`);
}

/** Two at a time, as many as there are cores. */
export async function untrue(
  browser: Browser,
  address: string,
  names = Object.keys(GALLERY),
): Promise<string[]> {
  const left = [...names];
  const worker = async (): Promise<string[]> => {
    const found: string[] = [];
    for (let name = left.shift(); name; name = left.shift())
      found.push(...(await faultsOf(browser, address, name)));
    return found;
  };
  return (await Promise.all([worker(), worker()])).flat();
}
