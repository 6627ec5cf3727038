// What a node has beside its fields, as text: attributes of structure, events, and what page code can call.
import type { X3DBodyElement } from '../../elements/body-element.js';
import { eventsAt, eventTypes } from '../../elements/bridge/words/event-types.js';
import type { X3DNodeElement } from '../../elements/node-element.js';
import type { NodeType } from '../../physics-core/inside.js';
import type { World } from '../../physics-core/world/world.js';
import { additionsOf } from '../../tools/build/manifest-fields.js';

/** Names and what each does. */
type Sentences = [string, string][];

// The types below list what the classes have: a member without a sentence does not compile.
type Own<T> = Exclude<keyof T, keyof HTMLElement | `${string}Callback`>;

const ELEMENT: Record<Own<X3DNodeElement>, string> = {
  world: 'The world it lives in, also before it has started.',
  explain: '`explain()`: what the simulation has for it, as plain data.',
};

const BODY: Record<Exclude<Own<X3DBodyElement>, Own<X3DNodeElement>>, string> = {
  applyForce:
    '`applyForce(force, at?)`: newtons, for the next step only, at a point of the world; without one at the centre of mass.',
  applyTorque: '`applyTorque(torque)`: newton metres, for the next step only.',
  applyImpulse: '`applyImpulse(impulse, at?)`: newton seconds, at once.',
  teleport:
    '`teleport(position, orientation?, { linearVelocity, angularVelocity }?)`: always jumps there; what is left out stays as it is.',
  drag: '`drag(point)`: takes hold of it at a point of the world; what it answers has `move(point)`, `end()` and `cancel()`.',
  wake: '`wake()`: moves again.',
  sleep: '`sleep()`: stands still until something wakes it.',
  sleeping: 'Whether it sleeps.',
  readPose: '`readPose(out)`: position and quaternion of the last step into an array of seven.',
};

const WORLD: Partial<Record<keyof World, string>> = {
  paused: 'Holds it.',
  step: '`step(n = 1)`: advances n × `timeStep` at once, paused or not; answers the seconds.',
  advance: '`advance(seconds)`: the same, whatever the accuracy level.',
  timeStep: 'Seconds of one step.',
  time: 'Seconds it has run.',
  timeScale: '0.5 runs it at half speed.',
  raycast: '`raycast(from, to)`: the first thing on the way, or null.',
  stats: 'Bodies, awake, joints, contacts, and milliseconds by phase.',
  effects: 'What the scene switched on, because of which element, at what cost.',
  problems: 'Whatever the markup got wrong, each once.',
  snapshot: '`snapshot()`: its state, as plain data for `restore`.',
  restore: '`restore(snapshot)`: back to that state, velocities included.',
  reset: '`reset()`: back to what the markup says.',
};

const additions = (type: NodeType): Sentences =>
  additionsOf(type).map(({ attribute, doc }) => [attribute, doc]);

const events = (type: NodeType): Sentences =>
  eventsAt(type.name).map((name) => {
    const { doc, detail } = eventTypes[name]!;
    return [name, detail.startsWith('{') ? `${doc} Its detail: \`${detail}\`` : doc];
  });

export interface InterfaceSection {
  title: string;
  text: string;
  sentences: Sentences;
}

const world = (type: NodeType): Sentences =>
  type.name === 'RigidBodyCollection' ? Object.entries(WORLD) : [];

export function interfaceSections(type: NodeType): InterfaceSection[] {
  const isBody = type.name === 'RigidBody';
  return [
    {
      title: 'Attributes that are no fields',
      text: 'Ours, not X3D’s: they say where it belongs.',
      sentences: additions(type),
    },
    {
      title: 'Events',
      text: 'They bubble: listen at it, or anywhere above.',
      sentences: events(type),
    },
    {
      title: 'Methods and properties',
      text: 'Of the custom element, beside a property for each field.',
      sentences: Object.entries(isBody ? { ...BODY, ...ELEMENT } : ELEMENT),
    },
    {
      title: 'Its world',
      text: 'What the property world, or worldOf(element), gives.',
      sentences: world(type),
    },
  ].filter(({ sentences }) => sentences.length > 0);
}
