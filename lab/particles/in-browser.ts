import { asked } from '../page/measure.js';
import type { FrameCost } from '../page/in-page/frames.js';
import type { ScriptFound } from '../page/asked.js';
import type { MeasuredBrowser } from '../page/pages.js';
import { estimate } from '../statistics.js';
import { spread, type Plan } from './conditions.js';
import { countOf, type Form } from './forms.js';
import type { PageRow, PageSide } from './numbers.js';
import { pageOf } from './pages.js';

/** Milliseconds of script from which on a page is left out. */
const MOST = 2000;

function sideOf(turns: readonly FrameCost[], ours?: readonly FrameCost[]) {
  const script = turns.map((turn) => turn.script);
  return {
    script: spread(script),
    step: spread(turns.map(({ physics }) => physics)),
    drawing: spread(turns.map((turn) => turn.script - turn.physics)),
    ...(ours && { ours: estimate(script.map((ms, i) => ours[i]!.script / ms)) }),
  };
}

/** All libraries that have this form, in turns in one page. */
export async function measureForm(
  browser: MeasuredBrowser,
  form: Form,
  { count, turns, each, warmUp }: Plan,
): Promise<PageRow> {
  const pages = form.sides.map((library) => pageOf(library, form.id, countOf(form, count)));
  const question = { pages, warmUp, turns, frames: each, most: MOST };
  const found = await asked<ScriptFound>(browser.ask({ kind: 'script', ...question }));
  const sides = form.sides.map((side): [string, PageSide | string] => {
    if (typeof found === 'string') return [side, found];
    const costs = found.sides[side];
    if (!costs) return [side, `a frame takes more than ${MOST} ms`];
    const ours = side === 'ours' ? undefined : found.sides.ours;
    const [living, height] = [found.counts[side]!, found.heights[side]!];
    return [side, { ...sideOf(costs, ours), living, height }];
  });
  return { form: form.id, sides: Object.fromEntries(sides) };
}
