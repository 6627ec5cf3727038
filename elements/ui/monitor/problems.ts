import type { Problem, World } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { nameOf } from './names.js';
import { whole } from './numbers.js';

/** More would be no list to read. */
const MOST = 20;

/** What the markup got wrong, and what is used instead. */
export function problems({ problems: all }: World): TemplateResult {
  const rest = all.length - MOST;
  return html`<div>
    <h3 id="problems">${all.length === 0 ? 'No problems' : `Problems (${whole(all.length)})`}</h3>
    <ul part="problems" aria-labelledby="problems" tabindex=${all.length > 0 ? 0 : nothing}>
      ${all.slice(0, MOST).map(item)} ${rest > 0 ? html`<li>and ${whole(rest)} more</li>` : nothing}
    </ul>
  </div>`;
}

const textOf = (used: unknown): string =>
  used instanceof Element ? nameOf(used) : Array.isArray(used) ? used.join(' ') : String(used);

const item = ({ severity, code, message, used }: Problem): TemplateResult =>
  html`<li>
    <strong class=${severity}>${severity}</strong> ${message}
    <span class="quiet">[${code}]${used === undefined ? '' : ` Used: ${textOf(used)}`}</span>
  </li>`;
