import type { World } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { controls } from './controls.js';
import { costs } from './costs.js';
import { effects } from './effects.js';
import { legend } from './legend.js';
import { pace } from './pace.js';
import { problems } from './problems.js';
import { timeline } from './timeline.js';
import { whole } from './numbers.js';

const COUNTS = ['bodies', 'awake', 'joints', 'contacts'] as const;

/** All that the monitor shows. `name`: what is to be shown; `refresh`: a control was used. */
export function panel(world: World | undefined, name: string, refresh: () => void): TemplateResult {
  return html`<section part="base" aria-label="Physics monitor">
    <header>
      <h2>Physics</h2>
      <span role="status" class="quiet">${statusOf(world, name)}</span>
    </header>
    ${world ? details(world, refresh) : nothing}
  </section>`;
}

/** Only what a control changes: what changes by itself would be read out again and again. */
function statusOf(world: World | undefined, name: string): string {
  if (!world) return `There is no physics ${name ? `at "${name}"` : 'here'} yet.`;
  if (!world.started) return 'Not started yet.';
  if (!world.get('enabled')) return 'Frozen: enabled is false.';
  if (world.timeline?.at !== undefined) return 'Looking back.';
  return world.paused ? 'Paused.' : 'Running.';
}

function details(world: World, refresh: () => void): TemplateResult {
  const { stats } = world;
  return html`
    ${controls(world, refresh)} ${timeline(world, refresh)} ${legend(world)}
    <dl part="counts">
      ${COUNTS.map(
        (name) =>
          html`<div>
            <dt>${NAMES[name]}</dt>
            <dd>${whole(stats[name])}</dd>
          </div>`,
      )}
      <div>
        <dt>Time</dt>
        <dd>${world.time.toFixed(2)} s</dd>
      </div>
      <div>
        <dt>Heap</dt>
        <dd>${whole(stats.heapBytes / 2 ** 20)} MB</dd>
      </div>
      ${
        stats.batches
          ? html`<div>
              <dt>Draws saved</dt>
              <dd>${whole(stats.drawsSaved!)}</dd>
            </div>`
          : nothing
      }
    </dl>
    ${pace(world.costs?.pace, stats.dropped)} ${costs(world.costs)} ${effects(world)}
    ${problems(world)}
  `;
}

const NAMES = { bodies: 'Bodies', awake: 'Awake', joints: 'Joints', contacts: 'Contacts' };
