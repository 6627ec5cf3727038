import type { World } from '../../../physics-core/inside.js';
import { html, nothing, svg, type TemplateResult } from '../lit.js';

type Meaning = World['debugLegend'][number];

/** What the colours of the debug drawing mean, while it is on. */
export function legend(world: World): TemplateResult | typeof nothing {
  const meanings = meaningsIn(world);
  if (meanings.length === 0) return nothing;
  return html`<div>
    <h3 id="legend">Colours of the debug drawing</h3>
    <ul part="legend" aria-labelledby="legend">
      ${meanings.map(item)}
    </ul>
  </div>`;
}

/** A ghost is drawn without the rest, too. */
function meaningsIn(world: World): readonly Meaning[] {
  const { debugLegend, timeline } = world;
  const alone = timeline?.ghostLevel && timeline.at !== undefined && !world.get('debug');
  return alone ? debugLegend.filter(({ name }) => name === 'ghost') : debugLegend;
}

const item = ({ color, means }: Meaning): TemplateResult =>
  html`<li>
    <svg viewBox="0 0 2 1" aria-hidden="true">
      ${svg`<rect width="2" height="1" fill=${textOf(color)}></rect>`}
    </svg>
    ${means}
  </li>`;

/** Red, green, blue from 0 to 1, as CSS says them; a policy may forbid a style attribute. */
const textOf = (color: Meaning['color']): string =>
  `rgb(${color.map((part) => Math.round(part * 255)).join(' ')})`;
