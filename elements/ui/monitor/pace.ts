import type { FramePace } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { percent, upToTenths } from './numbers.js';

/** Frames per second below which it is worth saying why; not a display's own rate. */
const SLOW = 30;
/** Share of a frame from which something is its reason. */
const MOST = 0.5;

/** How frames follow each other, and who has how much of them. `dropped`: seconds that the world fell behind the clock. */
export const pace = (pace: FramePace | undefined, dropped: number): TemplateResult => {
  const value = (of: (pace: FramePace) => string): string => (pace ? of(pace) : '–');
  const rows: [name: string, value: string][] = [
    ['Frames per second', value(({ framesPerSecond }) => upToTenths(framesPerSecond))],
    ['Steps per frame', value(({ stepsPerFrame }) => upToTenths(stepsPerFrame))],
    ['Time dropped', `${upToTenths(dropped)} s`],
    ['Physics', value(({ physics }) => percent(physics))],
    ['Listeners', value(({ listeners }) => percent(listeners))],
    ['Drawing', value(({ drawing }) => percent(drawing))],
    ['Rest of a frame', value((each) => percent(restOf(each)))],
  ];
  return html`<div part="pace">
    <dl>
      ${rows.map(
        ([name, text]) =>
          html`<div>
            <dt>${name}</dt>
            <dd>${text}</dd>
          </div>`,
      )}
    </dl>
    ${pace && pace.framesPerSecond < SLOW ? html`<p>${reasonOf(pace)}</p>` : nothing}
  </div>`;
};

const restOf = ({ physics, listeners, drawing }: FramePace): number =>
  Math.max(0, 1 - physics - listeners - drawing);

/** Why frames are few. */
function reasonOf(pace: FramePace): string {
  const time = `A frame takes ${upToTenths(pace.ms)} ms, most of it `;
  if (pace.physics > MOST) return `${time}the physics: fewer bodies or a coarser level help.`;
  if (pace.listeners > MOST) return `${time}the page’s listeners of physics events.`;
  if (pace.drawing > MOST) return `${time}x3dom’s drawing: fewer or like shapes help.`;
  if (restOf(pace) > MOST)
    return `${time}outside of both: the graphics card, the browser, or other scripts of the page. A smaller picture helps the first.`;
  return `A frame takes ${upToTenths(pace.ms)} ms: physics and drawing together.`;
}
