import type { LevelMeasurement } from '../physics-core/inside.js';
import { X3DUIElement, type UIDescription } from './ui/ui-element.js';
import { loadView } from './ui/view.js';

/** Shows, for the scene as it is, what each level of accuracy costs and what error it leaves; and sets the level. */
export class X3DAccuracyChartElement extends X3DUIElement {
  static readonly tag = 'x3d-accuracy-chart';
  static readonly description: UIDescription = {
    doc: 'Measures what each accuracy level costs in the scene as it is and what error it leaves, draws one against the other, and sets the level.',
    attributes: [
      {
        name: 'for',
        type: 'string',
        doc: 'DEF or id of an x3d element, a collection or any physics element; without it the nearest x3d element is measured.',
      },
    ],
    parts: {
      base: 'The panel.',
      controls: 'The choice of the error, and the button that measures.',
      button: 'The button.',
      levels: 'The row of radio buttons.',
      chart: 'The drawing.',
      data: 'The table of what was measured.',
    },
  };

  #measured: readonly LevelMeasurement[] | undefined;

  /** What it draws: the last measurement, or one that was kept and is given back: plain data but for the elements that `worst` and `leftOut` name. */
  get measured(): readonly LevelMeasurement[] | undefined {
    return this.#measured;
  }

  set measured(measured: readonly LevelMeasurement[] | undefined) {
    this.#measured = measured;
    this.changed();
  }

  /** @internal */
  protected override get settable(): readonly string[] {
    return [...super.settable, 'measured'];
  }

  /** @internal */
  protected readonly label = 'accuracy chart';

  /** @internal */
  protected load() {
    return loadView('chart', () => import('./ui/chart/view.js'));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-accuracy-chart': X3DAccuracyChartElement;
  }
}
