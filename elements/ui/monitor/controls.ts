import type { LevelName, World } from '../../../physics-core/inside.js';
import { html, type TemplateResult } from '../lit.js';

/** Pause, single step, reset, the accuracy level, the debug drawing, and marks for the Performance panel. */
export function controls(world: World, refresh: () => void): TemplateResult {
  const act = (what: () => void) => () => {
    what();
    refresh();
  };
  const { paused, started } = world;
  const button = (name: string, what: () => void): TemplateResult =>
    html`<button part="button" type="button" ?disabled=${!started} @click=${act(what)}>
      ${name}
    </button>`;
  return html`<div part="controls" role="group" aria-label="Controls">
    ${button(paused ? 'Go on' : 'Pause', () => (world.paused = !paused))}
    ${button('Step', () => stepOnce(world))} ${button('Reset', () => world.reset())}
    <label>Accuracy ${levels(world, refresh)}</label>
    ${box('Debug drawing', started, world.get('debug') as boolean, (on) => world.set('debug', on))}
    ${box('User Timing', started, world.profile, (on) => (world.profile = on))}
  </div>`;
}

/** A single step is for looking at: what ran is stopped first. */
function stepOnce(world: World): void {
  world.paused = true;
  world.step(1);
}

function levels(world: World, refresh: () => void): TemplateResult {
  const choose = ({ currentTarget }: Event): void => {
    world.accuracy = (currentTarget as HTMLSelectElement).value as LevelName;
    refresh();
  };
  return html`<select ?disabled=${!world.started} @change=${choose}>
    ${world.levels.map(
      ({ name, active, timeStep }) =>
        html`<option value=${name} .selected=${active}>
          ${name}, 1/${Math.round(1 / timeStep)} s
        </option>`,
    )}
  </select>`;
}

const box = (
  name: string,
  enabled: boolean,
  checked: boolean,
  set: (on: boolean) => void,
): TemplateResult =>
  html`<label>
    <input
      type="checkbox"
      ?disabled=${!enabled}
      .checked=${checked}
      @change=${({ currentTarget }: Event) => set((currentTarget as HTMLInputElement).checked)}
    />
    ${name}
  </label>`;
