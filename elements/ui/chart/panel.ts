import type { LevelMeasurement, World } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { data } from './data.js';
import { ERRORS, type ErrorName } from './errors.js';

export interface State {
  world: World | undefined;
  measured: readonly LevelMeasurement[] | undefined;
  /** They were given, not measured here and now. */
  kept: boolean;
  kind: ErrorName;
  /** The share of a measurement that is done, while one is under way. */
  progress: number | undefined;
  /** Why the last one came to nothing. */
  failed: string | undefined;
}

export interface Actions {
  measure(): void;
  cancel(): void;
  show(kind: ErrorName): void;
}

export function panel(state: State, actions: Actions): TemplateResult {
  const { world, measured, kind } = state;
  return html`<section part="base" aria-label="Accuracy chart">
    <header>
      <h2>What accuracy costs here</h2>
      <span role="status" class="quiet">${statusOf(state)}</span>
    </header>
    ${world?.started ? [levels(world, () => actions.show(kind)), controls(state, actions)] : nothing}
    ${world?.started && !measured ? HINT : nothing}
    <div part="chart" role="img" aria-label=${summary(measured, kind)} ?hidden=${!measured}></div>
    ${measured ? [remarks(measured), data(measured, world, kind)] : nothing}
  </section>`;
}

/** What there will be to see. */
const HINT = html`<p class="quiet">
  Measure runs a copy of the scene at every level, from the state it is in. Then each level has a
  dot: farther left is cheaper, farther down is nearer to the truth.
</p>`;

function statusOf({ world, measured, kept, progress, failed }: State): string {
  if (!world) return 'There is no physics here yet.';
  if (!world.started) return 'Not started yet.';
  if (progress !== undefined) return 'Measuring …';
  if (failed) return failed;
  if (!measured) return 'Not measured yet.';
  return kept ? 'As it was measured earlier.' : 'Measured.';
}

/** Of the running scene. */
function levels(world: World, show: () => void): TemplateResult {
  const asked = world.get('accuracy');
  const names = [...world.levels.map(({ name }) => name), 'auto' as const];
  const inForce = (name: string): boolean =>
    asked === 'auto' ? name === 'auto' : name === world.accuracy;
  return html`<fieldset part="levels">
    <legend>Level of the scene</legend>
    ${names.map(
      (name) =>
        html`<label
          ><input
            type="radio"
            name="level"
            .value=${name}
            .checked=${inForce(name)}
            @change=${() => {
              world.accuracy = name;
              show();
            }}
          />${name}${name === 'auto' && asked === 'auto' ? ` (now ${world.accuracy})` : ''}</label
        >`,
    )}
  </fieldset>`;
}

function controls({ progress, kind }: State, actions: Actions): TemplateResult {
  const measuring = progress !== undefined;
  return html`<div part="controls">
    <button part="button" type="button" @click=${measuring ? actions.cancel : actions.measure}>
      ${measuring ? 'Cancel' : 'Measure'}
    </button>
    ${
      measuring
        ? html`<progress max="1" .value=${progress} aria-label="Measured so far"></progress>`
        : html`<label>
            Error
            <select
              @change=${(event: Event) =>
                actions.show((event.currentTarget as HTMLSelectElement).value as ErrorName)}
            >
              ${Object.entries(ERRORS).map(
                ([name, { label }]) =>
                  html`<option value=${name} .selected=${name === kind}>${label}</option>`,
              )}
            </select>
          </label>`
    }
  </div>`;
}

/** What the drawing shows, in words. */
function summary(measured: State['measured'], kind: ErrorName): string {
  if (!measured) return '';
  const { label, text } = ERRORS[kind];
  const each = measured.map(
    ({ level, error, msPerSecond }) =>
      `${level} ${text(error[kind])} for ${msPerSecond.toPrecision(2)} ms`,
  );
  return `${label} error against work per simulated second: ${each.join(', ')}`;
}

function remarks(measured: readonly LevelMeasurement[]): TemplateResult {
  const [{ chaotic, horizon, tolerance, seconds, leftOut }] = measured as [LevelMeasurement];
  const { level } = measured.at(-1)!;
  const reasons = [...new Set(leftOut.map(({ reason }) => reason))];
  return html`<div class="remarks">
    ${
      chaotic
        ? html`<p class="warning">
            This scene is chaotic: roundings grow until they decide where bodies are. Levels agree
            within ${ERRORS.position.text(tolerance)} for ${horizon.toFixed(2)} s; position and
            energy are compared up to there.
          </p>`
        : nothing
    }
    <p class="quiet">
      ${seconds.toFixed(1)} s from the state the scene was in, against ${level}.
      ${reasons.length > 0 ? `Without what acts from outside: ${reasons.join('; ')}.` : nothing}
    </p>
  </div>`;
}
