import type { LevelName, Timeline, World } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { distance } from './numbers.js';

/** The level at which a recorded run is run anew to be drawn beside it, and how far apart the two are. */
export function ghost(world: World, recorded: Timeline, refresh: () => void): TemplateResult {
  const { ghostLevel } = recorded;
  const choose = async ({ currentTarget }: Event): Promise<void> => {
    const { value } = currentTarget as HTMLSelectElement;
    const whole = recorded.ghost((value as LevelName) || undefined);
    refresh();
    await whole;
    refresh();
  };
  return html`<label class="ghost">
      Ghost
      <select @change=${choose}>
        <option value="" .selected=${!ghostLevel}>none</option>
        ${world.levels.map(({ name, active, timeStep }) =>
          active && name !== ghostLevel
            ? nothing
            : html`<option value=${name} .selected=${name === ghostLevel}>
                ${name}, 1/${Math.round(1 / timeStep)} s
              </option>`,
        )}
      </select>
    </label>
    ${ghostLevel ? html`<span>${textOf(recorded)}</span>` : nothing}`;
}

function textOf({ at, apart }: Timeline): string {
  if (apart !== undefined) return `Farthest apart: ${distance(apart)}`;
  return at === undefined ? 'Look back to see it.' : 'It is on its way.';
}
