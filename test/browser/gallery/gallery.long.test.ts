import { expect } from 'chai';
import '../console.js';
import { touch } from '../bridge/outward/dragging/hand.js';
import { until } from '../scene.js';
import { openText, type PageWindow } from '../page.js';
import { GALLERY } from '../../../site/.vitepress/gallery.js';
import { frame } from '../../../site/markdown/frame.js';
import { FACTS, type Fact } from './facts.js';

// Each scene of the gallery does what its page says: it runs, by the seconds of its world, all bodies stay finite and where
// there is something to see, nothing is wrong, and its end is the physical fact that is written down for it.

const FENCE = /^```html live[^\n]*\n([^]*?)\n```$/m;

/** Seconds between looks, and metres beyond which nothing is in the picture. */
const LOOK = 0.05;
const FAR = 1000;

/** Where the site has its files, and where they lie here. */
const FILES = [
  ['/x3dom/', '/node_modules/x3dom/'],
  ['/x3d-physics/', '/dist/'],
  ['/kit/', '/site/kit/'],
  ['/frame.css', '/site/markdown/frame.css'],
] as const;

const here = (page: string): string =>
  FILES.reduce((text, [site, file]) => text.replaceAll(`"${site}`, `"${file}`), page);

/** Runs in the page; answers what is wrong. Between looks the page has time for its own scripts. */
const played = ({ seconds, first = '0', each = '0', holds }: Fact): string => `(async () => {
  const { worldOf } = await import('/dist/x3d-physics.js');
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

const LISTENS =
  '<script>var faults = []; onerror = (message) => void faults.push(message);</script>';

/** What is drawn without a graphics card is drawn sooner. */
const SMALL = '<style>x3d { width: 32px !important; height: 20px !important; }</style>';

/** Pixels: of a frame on a phone, and what a thumb finds: https://www.w3.org/WAI/WCAG22/Understanding/target-size-enhanced */
const PHONE = 342;
const THUMB = 44;

/** The scene of a page of the gallery, in a page of its own, which keeps what goes wrong in it. */
async function shown(name: string): Promise<PageWindow & { faults: string[] }> {
  const text = await (await fetch(`/site/gallery/${name}.md`)).text();
  const page = frame(FENCE.exec(text)![1]!, '/').replace('<meta', `${LISTENS}<meta`) + SMALL;
  return (await openText(here(page))) as PageWindow & { faults: string[] };
}

/** The core comes to the same bits in every browser: one of them goes to the end, the others so far that the page's scripts ran. */
const WHOLE = navigator.userAgent.includes('Chrome/');
const begun = (fact: Fact): Fact => ({ ...fact, seconds: 1, holds: 'true', says: 'it runs' });

describe('the gallery', () => {
  for (const name of Object.keys(GALLERY)) {
    const fact = FACTS[name];
    if (!fact) throw new Error(`test/browser/gallery/facts.ts: no fact says what ${name} comes to`);
    const asked = WHOLE ? fact : begun(fact);
    it(`${name}: ${asked.says}`, async () => {
      const page = await shown(name);
      const wrong = (await (page as unknown as typeof globalThis).eval(played(asked))) as string[];
      expect([...page.faults, ...wrong]).to.eql([]);
    });
  }

  /** Paused, in a frame as wide as a phone's. */
  async function carOnHills() {
    const page = await shown('car-on-hills');
    page.frameElement!.setAttribute('style', `width: ${PHONE}px`);
    const find = (selector: string) => page.document.querySelector(selector)!;
    const car = find('#car') as any;
    const world = await car.world.ready;
    world.paused = true;
    const joint = () => find('.front') as any;
    const driven = () => [joint().desiredAngularVelocity2, joint().minAngle1];
    return { page, find, car, world, driven };
  }

  it('car-on-hills: it drives while a thumb is on the pad, and no longer', async () => {
    const { page, find, car, world, driven } = await carOnHills();
    const { x, y } = find('[data-drive="1"]').getBoundingClientRect();
    const { left, top } = page.frameElement!.getBoundingClientRect();
    await touch('start', [Math.round(left + x + 20), Math.round(top + y + 15)]);
    await until(() => driven()[0] === 18);
    const [from] = car.position;
    world.advance(2);
    expect(car.position[0] - from).to.be.above(4);
    await touch('end');
    await until(() => driven()[0] === 0);
  });

  it('car-on-hills: its pads stand side by side on a phone, each as large as a thumb', async () => {
    const { page } = await carOnHills();
    const pads = [...page.document.querySelectorAll('.pads button')].map((pad) =>
      pad.getBoundingClientRect(),
    );
    expect(pads.length).to.equal(4);
    for (const { top, right, height, width } of pads) {
      expect(top).to.equal(pads[0]!.top);
      expect(right).to.be.below(PHONE);
      expect(height).to.be.at.least(THUMB);
      expect(width).to.be.at.least(THUMB);
    }
  });

  it('car-on-hills: it drives and steers while arrow keys are down, and no longer', async () => {
    const { page, car, world, driven } = await carOnHills();
    const { KeyboardEvent } = page as unknown as typeof globalThis;
    const press = (type: string, key: string) =>
      page.document.body.dispatchEvent(new KeyboardEvent(type, { key, bubbles: true }));
    press('keydown', 'ArrowUp');
    press('keydown', 'ArrowLeft');
    const [from] = car.position;
    expect(driven()).to.eql([18, -0.4]);
    world.advance(2);
    expect(car.position[0] - from).to.be.above(4);
    press('keyup', 'ArrowLeft');
    expect(driven()).to.eql([18, 0]);
    press('keyup', 'ArrowUp');
    expect(driven()).to.eql([0, 0]);
  });
});
