import { SI, type PhysicsNode } from '../../../physics-core/inside.js';
import { isCustom } from '../words/dom.js';
import { COLLISIONS, nodeEvents, STEPS } from '../words/event-types.js';
import { listening } from '../x3dom/listening.js';
import { ownBinding, type Binding } from '../nodes/binding.js';
import { inPage } from '../nodes/in-page.js';
import type { Stage } from './stage.js';
import { setState } from '../base/states.js';
import type { PageWorld } from '../nodes/surroundings.js';

/** World events and the DOM events they become, one lowercase word each so that every framework can bind them. */
const WORLD_EVENTS = { ready: 'physicsready', lag: 'physicslag', accuracy: 'physicsaccuracy' };
type Stop = () => void;

/** Turns the core's events into DOM events: those that cost something only while somebody listens. */
export class Events {
  readonly #stage: Stage;
  /** Kept and dispatched again: two events per step would otherwise be two objects per step. */
  readonly #steps = new WeakMap<Element, Map<string, CustomEvent<Record<string, unknown>>>>();
  readonly #worlds = new WeakMap<PageWorld, Map<string, Stop>>();
  /** By node: one that is made anew is listened to anew. */
  readonly #nodes = new Map<Binding, Heard>();

  constructor(stage: Stage) {
    this.#stage = stage;
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
    if (places.length === 0) places.push(this.#stage.x3d);
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
    this.#letGo(binding);
    const { node } = binding;
    if (node) this.#listenTo(binding, node);
    this.#showStates(binding);
  }

  #listenTo(binding: Binding, node: PhysicsNode): void {
    const heard: Heard = this.#nodes.get(binding) ?? { from: binding, node, stops: new Map() };
    for (const type of nodeEvents(binding.type.name))
      toggle(heard.stops, type, wanted(binding, type), () => this.#subscribe(heard, type));
    if (heard.stops.size > 0) this.#nodes.set(binding, heard);
    else this.#nodes.delete(binding);
  }

  /** Its node went, and may still have to tell of it: from where it stood. */
  #letGo(binding: Binding): void {
    const known = this.#nodes.get(binding);
    if (!known || known.node === binding.node) return;
    const { element, name, scope, leftFrom } = binding;
    known.from = { element, name, scope, leftFrom, node: known.node };
    this.#nodes.delete(binding);
  }

  #subscribe(heard: Heard, type: string): Stop {
    return heard.node.on(type, (detail) => {
      // Another listener may have taken it out of the page a moment ago: what it was taken out of hears it, too.
      if (!placeOf(heard.from).isConnected) this.#stage.takeRecords();
      this.#showStates(ownBinding(heard.from.element)!);
      if (isHeard(heard.from, type)) this.#fireAt(heard.from, type, inElements(detail as object));
    });
  }

  /** They show what is, and not what is told: that may have passed. */
  #showStates(binding: Binding): void {
    const { element } = binding;
    const { node, stops } = this.#nodes.get(binding) ?? {};
    setState(element, 'sleeping', !!stops?.has('sleep') && !!(node as Sleeper).sleeping);
    setState(element, 'colliding', !!stops?.has('collisionstart') && !!node?.colliding);
  }

  /** Somebody began or ceased to listen at `target`. */
  listenersChanged(target: EventTarget, name: string): void {
    const concerns = (place: Element): boolean =>
      !(target instanceof Node) || target.contains(place) || target instanceof ShadowRoot;
    if (STEPS.includes(name)) for (const world of this.#stage.worlds.all) this.updateWorld(world);
    else
      for (const binding of this.#stage.bindings())
        if (concerns(placeOf(binding))) this.update(binding);
  }

  /** Of a drag; false where a listener forbids its start. */
  drag(binding: Binding, type: string, detail: object): boolean {
    return this.#fireAt(binding, type, detail);
  }

  // ---- firing ---------------------------------------------------------------------------------------------------

  /** A world's events fire at its collections; at the `<x3d>` where it has none. */
  #atCollections(world: PageWorld, type: string, detail: object): void {
    if (world.collections.size === 0) this.#fire(this.#stage.x3d, type, { ...detail });
    for (const collection of [...world.collections]) this.#fireAt(collection, type, detail);
  }

  /** What has left the page is heard by its own listeners, and by those around its last place. */
  #fireAt(from: Sender, type: string, detail: object): boolean {
    const { element, leftFrom } = from;
    const place = placeOf(from);
    const allowed = this.#fire(place, type, place === element ? detail : withNames(from, detail));
    if (leftFrom) this.#fire(leftFrom, type, withNames(from, detail));
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
    // It may be settled by now.
    setState(element, 'problem', world.problemsOf(element).length > 0);
    const binding = ownBinding(element);
    if (binding) this.#fireAt(binding, 'physicsproblem', problem);
    else this.#fire(element, 'physicsproblem', problem);
  }
}

interface Sleeper {
  sleeping?: boolean;
}

/** Whose events fire, and where it stands or stood. */
type Sender = Pick<Binding, 'element' | 'name' | 'scope' | 'leftFrom' | 'node'>;

/** What of a node is listened to. */
interface Heard {
  /** Its binding; where it stood, once that has another node or none. */
  from: Sender;
  readonly node: PhysicsNode;
  readonly stops: Map<string, Stop>;
}

/** Where events of a node fire. */
const placeOf = ({ scope, element }: Sender): Element => scope?.pageHost ?? element;

/** There, or where that was taken out of. */
function isHeard(from: Sender, type: string): boolean {
  const { leftFrom } = from;
  return (
    listening.heard(placeOf(from), type) ||
    (leftFrom !== undefined && listening.heard(leftFrom, type))
  );
}

/** Where it does not fire at its own element it says whose it is. */
const withNames = ({ node, name, element }: Sender, detail: object): object => ({
  ...detail,
  node,
  def: name,
  element,
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
