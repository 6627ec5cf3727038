import type { Timeline, World } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { distance } from './numbers.js';
import { ghost } from './ghost.js';

/** Seconds from one picture of a timeline to the next: an arrow key's step. */
const PICTURE = 1 / 60;

/** Records what the world does, and looks back at it: a slider, with marks where something was done. */
export function timeline(world: World, refresh: () => void): TemplateResult {
  const { timeline: recorded } = world;
  const act = (what: () => unknown) => async () => {
    await what();
    refresh();
  };
  const button = (name: string, what: () => unknown): TemplateResult =>
    html`<button part="button" type="button" ?disabled=${!world.started} @click=${act(what)}>
      ${name}
    </button>`;
  if (!recorded)
    return html`<div part="timeline" role="group" aria-label="Timeline">
      ${button('Record', () => world.record())}
    </div>`;
  return html`<div part="timeline" role="group" aria-label="Timeline">
    ${slider(recorded, refresh)}
    ${
      recorded.playing
        ? button('Hold', () => recorded.pause())
        : button('Play', () => recorded.play())
    }
    ${recorded.at === undefined ? nothing : button('Go on from here', () => world.resume())}
    ${button('Stop recording', () => recorded.stop())}
    ${world.mirrored === undefined ? ghost(world, recorded, refresh) : nothing}
  </div>`;
}

function slider(recorded: Timeline, refresh: () => void): TemplateResult {
  const { from, to, marks, apart } = recorded;
  const at = recorded.at ?? to;
  const seek = ({ currentTarget }: Event): void => {
    recorded.seek((currentTarget as HTMLInputElement).valueAsNumber);
    refresh();
  };
  const last = marks.findLast(({ time }) => time <= at);
  const beside = apart === undefined ? '' : `, the ghost ${distance(apart)} away`;
  return html`<label>
      Look at
      <input
        type="range"
        list="marks"
        min=${from}
        max=${to}
        step=${PICTURE}
        .value=${String(at)}
        aria-valuetext=${`${at.toFixed(2)} of ${to.toFixed(2)} seconds${beside}`}
        @input=${seek}
      />
    </label>
    <datalist id="marks">
      ${[...new Set(marks.map(({ time }) => time))].map((time) => html`<option value=${time}></option>`)}
    </datalist>
    <span class="quiet">
      ${at.toFixed(2)} of ${from.toFixed(2)} to ${to.toFixed(2)}
      s${last ? `, after ${last.text}` : ''}
    </span>`;
}
