import { SI, type PhysicsNode } from '../../physics-core/index.js';
import { isCustom } from './document/dom.js';
import { COLLISIONS, nodeEvents, STEPS } from './event-types.js';
import { listening } from './listening.js';
import { ownBinding, type Binding } from './nodes/binding.js';
import { inPage } from './nodes/in-page.js';
import type { Scene } from './scene.js';
import { setState } from './states.js';
import type { PageWorld } from './nodes/worlds.js';

/** World events and the DOM events they become, one lowercase word each so that every framework can bind them. */
const WORLD_EVENTS = { ready: 'physicsready', lag: 'physicslag', accuracy: 'physicsaccuracy' };
type Stop = () => void;

/** Turns the core's events into DOM events: those that cost something only while somebody listens. */
export class Events {
  readonly #scene: Scene;
  /** Kept and dispatched again: two events per step would otherwise be two objects per step. */
  readonly #steps = new WeakMap<Element, Map<string, CustomEvent<Record<string, unknown>>>>();
  readonly #worlds = new WeakMap<PageWorld, Map<string, Stop>>();
  /** By node: one that is made anew is listened to anew. */
  readonly #nodes = new Map<Binding, { node: PhysicsNode; heard: Map<string, Stop> }>();
  /** What a node touches, where its collisions are heard. */
  readonly #touching = new WeakMap<Binding, Set<unknown>>();

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  // ---- worlds ---------------------------------------------------------------------------------------------------

  listen(world: PageWorld): void {
    for (const [event, type] of Object.entries(WORLD_EVENTS)) {
      world.on(event, (detail) =>
        this.#atCollections(world, type, detail === world ? {} : (detail as object)),
      );
    }
    world.on('problem', (problem) => this.#problem(world, problem as { element: unknown }));
    this.#worlds.set(world, new Map());
    this.updateWorld(world);
  }

  /** Its collections changed, or somebody began or ceased to listen. */
  updateWorld(world: PageWorld): void {
    const heard = this.#worlds.get(world);
    if (!heard) return;
    const places = [...world.collections].map(placeOf);
    if (places.length === 0) places.push(this.#scene.x3d);
    for (const type of STEPS) {
      const wanted = places.some((place) => listening.heard(place, type));
      toggle(heard, type, wanted, () =>
        world.on(type, (detail) => this.#atCollections(world, type, detail as object)),
      );
    }
  }

  // ---- nodes ----------------------------------------------------------------------------------------------------

  /** The node was made, moved or went, or somebody began or ceased to listen. */
  update(binding: Binding): void {
    const known = this.#nodes.get(binding);
    const { node } = binding;
    if (known && known.node !== node) {
      for (const stop of known.heard.values()) stop();
      this.#nodes.delete(binding);
      this.#forgetTouching(binding);
      setState(binding.element, 'sleeping', false);
    }
    if (!node) return;
    const heard = this.#nodes.get(binding)?.heard ?? new Map<string, Stop>();
    for (const type of nodeEvents(binding.type.name))
      toggle(heard, type, wanted(binding, type), () => this.#subscribe(binding, node, type));
    if (heard.size > 0) this.#nodes.set(binding, { node, heard });
    else this.#nodes.delete(binding);
    if (!heard.has('collisionstart')) this.#forgetTouching(binding);
  }

  #subscribe(binding: Binding, node: PhysicsNode, type: string): Stop {
    if (type === 'sleep') setState(binding.element, 'sleeping', !!(node as Sleeper).sleeping);
    return node.on(type, (detail) => this.#nodeEvent(binding, type, detail as object));
  }

  #nodeEvent(binding: Binding, type: string, detail: object): void {
    if (type === 'sleep' || type === 'wake')
      setState(binding.element, 'sleeping', type === 'sleep');
    else if (COLLISIONS.includes(type)) this.#noteTouching(binding, type, detail);
    if (isHeard(binding, type)) this.#fireAt(binding, type, inElements(detail));
  }

  #noteTouching(binding: Binding, type: string, detail: { other?: unknown }): void {
    const others = this.#touching.get(binding) ?? new Set();
    this.#touching.set(binding, others);
    if (type === 'collisionstart') others.add(detail.other);
    else others.delete(detail.other);
    setState(binding.element, 'colliding', others.size > 0);
  }

  #forgetTouching(binding: Binding): void {
    if (this.#touching.delete(binding)) setState(binding.element, 'colliding', false);
  }

  /** Somebody began or ceased to listen at `target`. */
  listenersChanged(target: EventTarget, name: string): void {
    const concerns = (place: Element): boolean =>
      !(target instanceof Node) || target.contains(place) || target instanceof ShadowRoot;
    if (STEPS.includes(name)) for (const world of this.#scene.worlds.all) this.updateWorld(world);
    else
      for (const binding of this.#scene.bindings())
        if (concerns(placeOf(binding))) this.update(binding);
  }

  /** Of a drag; false where a listener forbids its start. */
  drag(binding: Binding, type: string, detail: object): boolean {
    return this.#fireAt(binding, type, detail);
  }

  // ---- firing ---------------------------------------------------------------------------------------------------

  /** A world's events fire at its collections; at the `<x3d>` where it has none. */
  #atCollections(world: PageWorld, type: string, detail: object): void {
    if (world.collections.size === 0) this.#fire(this.#scene.x3d, type, { ...detail });
    for (const collection of [...world.collections]) this.#fireAt(collection, type, detail);
  }

  /** What has left the page is heard by its own listeners, and by those around its last place. */
  #fireAt(binding: Binding, type: string, detail: object): boolean {
    const { element, leftFrom } = binding;
    const place = placeOf(binding);
    const allowed = this.#fire(
      place,
      type,
      place === element ? detail : withNames(binding, detail),
    );
    if (leftFrom) this.#fire(leftFrom, type, withNames(binding, detail));
    return allowed;
  }

  /** False where a listener forbids what it tells of. */
  #fire(element: Element, type: string, detail: object): boolean {
    if (!STEPS.includes(type)) {
      const cancelable = type === 'bodydragstart';
      const init = { bubbles: true, composed: true, cancelable, detail };
      return element.dispatchEvent(new CustomEvent(type, init));
    }
    const event = this.#stepEvent(element, type);
    Object.assign(event.detail, detail);
    return element.dispatchEvent(event);
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
    if (!(element instanceof Element)) {
      for (const collection of world.collections) setState(collection.element, 'problem', true);
      return this.#atCollections(world, 'physicsproblem', problem);
    }
    setState(element, 'problem', true);
    const binding = ownBinding(element);
    if (binding) this.#fireAt(binding, 'physicsproblem', problem);
    else this.#fire(element, 'physicsproblem', problem);
  }
}

interface Sleeper {
  sleeping?: boolean;
}

/** Where events of a node fire. */
const placeOf = (binding: Binding): Element => binding.scope?.pageHost ?? binding.element;

/** There, or where that was taken out of. */
function isHeard(binding: Binding, type: string): boolean {
  const { leftFrom } = binding;
  return (
    listening.heard(placeOf(binding), type) ||
    (leftFrom !== undefined && listening.heard(leftFrom, type))
  );
}

/** Where it does not fire at its own element it says whose it is. */
const withNames = (binding: Binding, detail: object): object => ({
  ...detail,
  node: binding.node,
  def: binding.name,
  element: binding.element,
});

/**
 * Sleeping and waking are rare: custom elements always show them. Collisions have to be read, which nobody pays for
 * who does not listen; starts and ends go together.
 */
function wanted(binding: Binding, type: string): boolean {
  const place = placeOf(binding);
  if (COLLISIONS.includes(type)) return COLLISIONS.some((each) => listening.heard(place, each));
  const shown = type !== 'jointlimit' && isCustom(binding.element);
  return shown || listening.heard(place, type);
}

function toggle(heard: Map<string, Stop>, type: string, wanted: boolean, begin: () => Stop): void {
  if (wanted === heard.has(type)) return;
  heard.get(type)?.();
  heard.delete(type);
  if (wanted) heard.set(type, begin());
}

/** The detail with elements for nodes; in SI units, since it may concern nodes of several files. */
const inElements = (detail: object): object =>
  Object.fromEntries(Object.entries(detail).map(([key, value]) => [key, inPage(value, SI)]));
