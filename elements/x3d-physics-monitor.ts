import { costs } from '../physics-core/inside.js';
import { X3DUIElement, type UIDescription } from './ui/ui-element.js';
import { loadView } from './ui/view.js';

/** Shows what a world does and costs, and has the controls to stop it, step it and start it again. */
export class X3DPhysicsMonitorElement extends X3DUIElement {
  static readonly tag = 'x3d-physics-monitor';
  static readonly description: UIDescription = {
    doc: 'Shows what a world does and costs: bodies, contacts, frames per second and who has which share of them, milliseconds by phase, effects, problems; with pause, single step, reset, the accuracy level, and a slider that looks back at what was recorded.',
    attributes: [
      {
        name: 'for',
        type: 'string',
        doc: 'DEF or id of an x3d element, a collection or any physics element; without it the nearest x3d element is shown.',
      },
    ],
    parts: {
      base: 'The panel.',
      controls: 'The row of buttons.',
      button: 'Each button.',
      timeline: 'The slider of what was recorded, with its buttons.',
      legend: 'The meanings of the debug colours, while debug drawing is on.',
      counts: 'The list of counts.',
      pace: 'Frames per second, steps per frame, time dropped, and who has which share of a frame.',
      costs: 'The table of milliseconds.',
      effects: 'The table of effects in use.',
      problems: 'The list of problems.',
    },
  };

  /** @internal */
  protected readonly label = 'physics monitor';

  /** @internal */
  protected async load() {
    const view = await loadView('monitor', () => import('./ui/monitor/view.js'));
    // So that `world.effects` tells what it weighs.
    costs.comesWith(view.bytes ?? 0);
    return view;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-physics-monitor': X3DPhysicsMonitorElement;
  }
}
