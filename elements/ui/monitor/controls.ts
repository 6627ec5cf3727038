import type { LevelName, World } from '../../../physics-core/index.js';
import { html, type TemplateResult } from '../lit.js';

/** Pause, single step, reset, and the accuracy level. */
export function controls(world: World, refresh: () => void): TemplateResult {
  const act = (what: () => void) => () => {
    what();
    refresh();
  };
  const { paused, started } = world;
  return html`<div part="controls" role="group" aria-label="Controls">
    <button
      part="button"
      type="button"
      ?disabled=${!started}
      @click=${act(() => (world.paused = !paused))}
    >
      ${paused ? 'Go on' : 'Pause'}
    </button>
    <button part="button" type="button" ?disabled=${!started} @click=${act(() => stepBy(world))}>
      Step
    </button>
    <button part="button" type="button" ?disabled=${!started} @click=${act(() => world.reset())}>
      Reset
    </button>
    <label>
      Accuracy
      <select
        ?disabled=${!started}
        @change=${(event: Event) => {
          world.accuracy = (event.currentTarget as HTMLSelectElement).value as LevelName;
          refresh();
        }}
      >
        ${world.levels.map(
          ({ name, active, timeStep }) =>
            html`<option value=${name} .selected=${active}>
              ${name}, 1/${Math.round(1 / timeStep)} s
            </option>`,
        )}
      </select>
    </label>
  </div>`;
}

/** A single step is for looking at: what ran is stopped first. */
function stepBy(world: World): void {
  world.paused = true;
  world.step(1);
}
