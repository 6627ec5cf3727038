import type { LevelMeasurement, World } from '../../../physics-core/inside.js';
import { html, type TemplateResult } from '../lit.js';
import { ERRORS, work, type ErrorName } from './errors.js';

const NAMES = Object.keys(ERRORS) as ErrorName[];

/** The numbers beside the drawing; the level in force is marked, and so are the errors that are not drawn. */
export function data(
  measured: readonly LevelMeasurement[],
  world: World | undefined,
  drawn: ErrorName,
): TemplateResult {
  const role = (name: ErrorName): string => (name === drawn ? 'drawn' : 'other');
  return html`<div class="scroll" tabindex="0" role="group" aria-label="What was measured">
    <table part="data">
      <thead>
        <tr>
          <th scope="col">Level</th>
          <th scope="col">Step</th>
          <th scope="col">ms per s</th>
          ${NAMES.map((name) => html`<th scope="col" class=${role(name)}>${ERRORS[name].label}</th>`)}
        </tr>
      </thead>
      <tbody>
        ${measured.map(
          ({ level, timeStep, msPerSecond, error }) =>
            html`<tr aria-current=${world?.accuracy === level}>
              <th scope="row">${level}</th>
              <td>1/${Math.round(1 / timeStep)} s</td>
              <td>${work(msPerSecond)}</td>
              ${NAMES.map((name) => html`<td class=${role(name)}>${ERRORS[name].text(error[name])}</td>`)}
            </tr>`,
        )}
      </tbody>
    </table>
  </div>`;
}
