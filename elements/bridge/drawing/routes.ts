import { codecs, type PhysicsNode, type World } from '../../../physics-core/inside.js';
import { ownBinding, type Binding } from '../nodes/binding.js';
import { inPage } from '../nodes/in-page.js';
import { nodeOf, type PhysicsX3DNode } from '../x3dom/x3dom.js';

/** Sent by the core in the very step, since what begins and ends within a frame would be lost. */
const SENT_BY_STEP: Record<string, readonly string[]> = {
  CollisionSensor: ['isActive', 'intersections', 'contacts'],
};
const byStep = (binding: Binding, field: string): boolean =>
  SENT_BY_STEP[binding.type.name]?.includes(field) ?? false;

/** What a node has sent, and the core's events it listens to. */
interface Sender {
  sent: Map<string, unknown>;
  heard: Map<string, { node: PhysicsNode; stop: () => void }>;
}

/** Joints compute and send what their forceOutput asks for. */
interface Selective extends PhysicsNode {
  outputs?(field: string): boolean;
}

const FEEDS = 'its ROUTEs to physics act within a step';

const bindingOf = ({ element }: PhysicsX3DNode): Binding => ownBinding(element!)!;

/** Sends what the simulation changed to where it is ROUTEd: once per drawn frame, contacts with each step. */
export class Routes {
  readonly #senders = new Map<PhysicsX3DNode, Sender>();

  add(node: PhysicsX3DNode): void {
    if (!this.#senders.has(node)) this.#senders.set(node, { sent: new Map(), heard: new Map() });
    this.#listen(node, this.#senders.get(node)!);
  }

  /** The core's node of an element was made or went. */
  update({ element }: Binding): void {
    const node = nodeOf(element) as PhysicsX3DNode | undefined;
    const sender = node && this.#senders.get(node);
    if (sender) this.#listen(node, sender);
  }

  send(world: World): void {
    for (const [node, sender] of this.#senders) {
      // x3dom makes a new node when an element moves or comes back.
      if (!node._xmlNode) this.#forget(node, sender);
      else this.#sendFrom(node, sender, world);
    }
  }

  #sendFrom(node: PhysicsX3DNode, { sent }: Sender, world: World): void {
    const binding = bindingOf(node);
    if (binding.world !== world || !binding.node) return;
    for (const name of node.routedFields) {
      const field = binding.type.fields[name];
      if (byStep(binding, name) || !field) continue;
      const selective = binding.node as Selective;
      if (field.access === 'outputOnly' && selective.outputs?.(name) === false) continue;
      const value = binding.get(name);
      if (value === undefined) continue;
      const last = sent.get(name);
      if (last !== undefined && codecs[field.type].equal(last, value)) continue;
      sent.set(name, value);
      node.emit(name, value);
    }
  }

  #listen(node: PhysicsX3DNode, { heard }: Sender): void {
    const binding = bindingOf(node);
    const fields = node.routedFields.filter((name) => byStep(binding, name));
    for (const [name, { node: known, stop }] of heard) {
      if (known === binding.node && fields.includes(name)) continue;
      stop();
      heard.delete(name);
    }
    const source = binding.node;
    if (!source) return;
    if (fields.length > 0 && node.feedsPhysics)
      binding.world?.stay({ why: FEEDS, host: binding.element });
    for (const name of fields) {
      if (heard.has(name)) continue;
      const stop = source.on(name, (value) => node.emit(name, inPage(value, binding.units)));
      heard.set(name, { node: source, stop });
      // What it began before.
      const value = binding.get(name);
      if (value === true || (Array.isArray(value) && value.length > 0)) node.emit(name, value);
    }
  }

  #forget(node: PhysicsX3DNode, { heard }: Sender): void {
    for (const { stop } of heard.values()) stop();
    this.#senders.delete(node);
  }
}
