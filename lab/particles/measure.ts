import { asking } from '../page/pages.js';
import type { Progress } from '../run/progress.js';
import { conditions, type Plan } from './conditions.js';
import { formOf, forms } from './forms.js';
import { FOUNTAIN } from './fountain.js';
import { measureForm } from './in-browser.js';
import { measureScene } from './in-node.js';
import type { NodeRow, PageRow, ParticleNumbers } from './numbers.js';
import { makePages } from './pages.js';
import { nodeScenes } from './scenes.js';

/** Frames until as many live as ever will, and all code is compiled. */
const ALL_LIVE = Math.ceil(60 * (FOUNTAIN.life + 1));

/** What the page on what particles cost stands on. */
export const THOROUGH: Plan = { count: 10_000, turns: 60, each: 4, warmUp: ALL_LIVE, forms };

/** Whether it runs: a form that all libraries have, and what ours alone has. */
export const QUICK: Plan = {
  count: 200,
  turns: 3,
  each: 2,
  warmUp: 20,
  forms: ['sprite', 'bodies'].map(formOf),
};

export async function measureInNode(
  plan: Plan,
  progress: Progress,
): Promise<ParticleNumbers['node']> {
  const rows: NodeRow[] = [];
  for (const scene of nodeScenes) rows.push(await measureScene(scene, plan, progress));
  return { ...conditions(), rows };
}

/** Each form in a browser that is opened for it. */
export async function measureInChromium(
  plan: Plan,
  progress: Progress,
): Promise<ParticleNumbers['chromium']> {
  const pages = await makePages();
  const rows: PageRow[] = [];
  let version = '';
  for (const form of plan.forms) {
    progress(`Chromium: ${form.name}`);
    const answered = await asking('chromium', pages, (browser) => measureForm(browser, form, plan));
    rows.push(answered.found);
    version = answered.version;
  }
  return { version, ...conditions(), rows };
}

/** What was not measured, in words. */
export const missingIn = ({ node, chromium }: Pick<ParticleNumbers, 'node' | 'chromium'>) => [
  ...node.rows.filter(({ living }) => living === 0).map(({ scene }) => `${scene}: none live`),
  ...chromium.rows.flatMap(({ form, sides }) =>
    Object.entries(sides)
      // One that is alone may just have died.
      .filter(([, side]) => typeof side === 'string' || (side.living === 0 && !formOf(form).alone))
      .map(([name, side]) => `${form}, ${name}: ${typeof side === 'string' ? side : 'none live'}`),
  ),
];
