import type { World } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { nameOf } from './names.js';
import { milliseconds } from './numbers.js';

/** What the scene switched on beyond falling bodies, because of which element, and what it costs. */
export function effects(world: World): TemplateResult | typeof nothing {
  const active = world.effects.filter((effect) => effect.active);
  if (active.length === 0) return nothing;
  return html`<div>
    <h3 id="effects">Effects in use, milliseconds per step</h3>
    <ul part="effects" aria-labelledby="effects">
      ${active.map(
        ({ name, because, ms }) =>
          html`<li>
            <span>${name}</span><span>${milliseconds(ms)}</span>
            <span class="quiet">${nameOf(because?.element)}: ${because?.reason}</span>
          </li>`,
      )}
    </ul>
  </div>`;
}
