import type { X3DPhysicsMonitorElement } from '../../../elements/index.js';
import { until } from '../scene.js';

/** Two x3d elements: one body in the first, two on a collection in the second, and room for a monitor. */
export const TWO_SCENES = `
  <div id="one"><x3d id="first" width="200px" height="100px"><scene>
    <transform><shape><box></box></shape><x3d-rigid-body def="single"></x3d-rigid-body></transform>
  </scene></x3d></div>
  <div id="two"><x3d id="second" width="200px" height="100px"><scene>
    <x3d-rigid-body-collection id="collection" gravity="0 0 0">
      <x3d-rigid-body def="a" position="3 0 0" linearVelocity="1 0 0"></x3d-rigid-body>
      <x3d-rigid-body def="b" position="0 5 0"></x3d-rigid-body>
    </x3d-rigid-body-collection>
  </scene></x3d></div>`;

/** What is in the shadow root of a monitor, as a reader finds it. */
export class Shown {
  readonly monitor: X3DPhysicsMonitorElement;

  constructor(monitor: Element) {
    this.monitor = monitor as X3DPhysicsMonitorElement;
  }

  get root(): ShadowRoot {
    return this.monitor.shadowRoot!;
  }

  get text(): string {
    return (this.root?.textContent ?? '').replace(/\s+/g, ' ').trim();
  }

  part(name: string): HTMLElement | null {
    return this.root.querySelector(`[part~="${name}"]`);
  }

  /** The value beside a term. */
  count(term: string): string | undefined {
    const terms = [...(this.root?.querySelectorAll('dt') ?? [])];
    return terms.find((each) => each.textContent === term)?.nextElementSibling?.textContent?.trim();
  }

  button(name: RegExp): HTMLButtonElement {
    return [...this.root.querySelectorAll('button')].find((each) => name.test(each.textContent!))!;
  }

  /** By its label. */
  select(name: string): HTMLSelectElement | undefined {
    const labels = [...this.root.querySelectorAll('label')];
    const label = labels.find((each) => each.textContent!.trim().startsWith(name));
    return label?.control as HTMLSelectElement | undefined;
  }

  async shows(term: string, value: string): Promise<void> {
    await until(() => this.count(term) === value);
  }
}

/** Puts a monitor into the page. */
export function addMonitor(attributes = '', to: Element = document.body): Shown {
  to.insertAdjacentHTML('beforeend', `<x3d-physics-monitor ${attributes}></x3d-physics-monitor>`);
  return new Shown(to.lastElementChild!);
}
