import { ownBinding, type Binding } from './nodes/binding.js';
import type { Scene } from './scene.js';
import { setState } from './states.js';
import type { PageWorld } from './nodes/worlds.js';

/** World events and the DOM events they become, one lowercase word each so that every framework can bind them. */
const WORLD_EVENTS = {
  ready: 'physicsready',
  lag: 'physicslag',
  beforestep: 'beforestep',
  afterstep: 'afterstep',
};

/** Turns the core's events into DOM events. */
export class Events {
  readonly #scene: Scene;
  /** Kept and dispatched again: two events per step would otherwise be two objects per step. */
  readonly #steps = new WeakMap<Element, Map<string, CustomEvent<Record<string, unknown>>>>();

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  listen(world: PageWorld): void {
    for (const [event, type] of Object.entries(WORLD_EVENTS)) {
      world.on(event, (detail) =>
        this.#atCollections(world, type, detail === world ? {} : (detail as object)),
      );
    }
    world.on('problem', (problem) => this.#problem(world, problem as { element: unknown }));
  }

  /** A world's events fire at its collections; at the `<x3d>` where it has none. */
  #atCollections(world: PageWorld, type: string, detail: object): void {
    if (world.collections.size === 0) this.#fire(this.#scene.x3d, type, { ...detail });
    for (const collection of [...world.collections]) this.#fireAt(collection, type, detail);
  }

  #fireAt(binding: Binding, type: string, detail: object): void {
    const host = binding.scope?.pageHost;
    if (!host) return this.#fire(binding.element, type, detail);
    this.#fire(host, type, {
      ...detail,
      node: binding.node,
      def: binding.name,
      element: binding.element,
    });
  }

  #fire(element: Element, type: string, detail: object): void {
    if (!type.endsWith('step')) {
      element.dispatchEvent(new CustomEvent(type, { bubbles: true, composed: true, detail }));
      return;
    }
    const event = this.#stepEvent(element, type);
    Object.assign(event.detail, detail);
    element.dispatchEvent(event);
  }

  #stepEvent(element: Element, type: string): CustomEvent<Record<string, unknown>> {
    const events = this.#steps.get(element) ?? new Map();
    this.#steps.set(element, events);
    const event =
      events.get(type) ?? new CustomEvent(type, { bubbles: true, composed: true, detail: {} });
    events.set(type, event);
    return event;
  }

  #problem(world: PageWorld, problem: { element: unknown }): void {
    const { element } = problem;
    // A problem of the world itself.
    if (!(element instanceof Element)) return this.#atCollections(world, 'physicsproblem', problem);
    setState(element, 'problem', true);
    const binding = ownBinding(element);
    if (binding) this.#fireAt(binding, 'physicsproblem', problem);
    else this.#fire(element, 'physicsproblem', problem);
  }
}
