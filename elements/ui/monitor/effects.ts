import type { EffectReport, World } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { nameOf } from './names.js';
import { kilobytes, milliseconds, upToTenths, whole } from './numbers.js';

/** What the scene switched on beyond falling bodies, because of which elements, and what it costs. */
export function effects(world: World): TemplateResult | typeof nothing {
  const active = world.effects.filter((effect) => effect.active);
  if (active.length === 0) return nothing;
  return html`<table part="effects">
    <caption>
      Effects in use: milliseconds and calls per step, size of the file with their code
    </caption>
    <thead>
      <tr>
        <th scope="col">Effect</th>
        ${['ms', 'calls', 'kB'].map((head) => html`<th scope="col">${head}</th>`)}
      </tr>
    </thead>
    <tbody>
      ${active.map(rows)}
    </tbody>
  </table>`;
}

const rows = (effect: EffectReport): TemplateResult =>
  html`<tr>
      <th scope="row">${effect.name}</th>
      <td>${milliseconds(effect.ms)}</td>
      <td>${upToTenths(effect.calls)}</td>
      <td>${effect.bytes > 0 ? kilobytes(effect.bytes) : '–'}</td>
    </tr>
    <tr>
      <td class="quiet" colspan="4">${causeOf(effect)}</td>
    </tr>`;

function causeOf({ because, elements }: EffectReport): string {
  const others = elements.length - 1;
  const more = others > 0 ? ` and ${others === 1 ? 'another' : `${whole(others)} others`}` : '';
  return `${nameOf(because?.element)}${more}: ${because?.reason}`;
}
