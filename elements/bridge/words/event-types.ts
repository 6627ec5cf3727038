/** A DOM event that elements of ours fire: bubbling, composed, and one lowercase word that every framework can bind. */
export interface EventType {
  doc: string;
  /** TypeScript type of its detail. */
  detail: string;
}

const COLLISION =
  '{ other: Element; impulse: number; contacts: { position: number[]; normal: number[]; depth: number; impulse: number }[]; time: number; reason?: string }';
const WATER = '{ water: Element; depth: number; speed: number; time: number }';
const STEP = '{ time: number; timeStep: number }';
const DRAG =
  "{ point: number[]; mode: string; by: 'mouse' | 'touch' | 'pen' | 'keyboard'; time: number; reason?: string }";

/**
 * Those of nodes in an Inline fire at the Inline, with `node`, `def` and `element` in their detail. The last ones of an
 * element that was removed fire at it, where only its own listeners hear them, and so at what it was taken out of.
 */
export const eventTypes: Record<string, EventType> = {
  collisionstart: { doc: 'It has begun to touch another one.', detail: COLLISION },
  collisionend: {
    doc: 'It no longer touches the other one; `reason` says why.',
    detail: COLLISION,
  },
  sleep: { doc: 'It has come to rest and is simulated no longer.', detail: '{ time: number }' },
  wake: { doc: 'It moves again.', detail: '{ time: number }' },
  waterenter: {
    doc: 'It has come into water.',
    detail: WATER,
  },
  waterleave: { doc: 'It is in water no more.', detail: WATER },
  jointlimit: {
    doc: 'It has reached one of its stops.',
    detail: "{ limit: 'min' | 'max'; value: number; axis?: number; time: number }",
  },
  bodydragstart: { doc: 'Somebody takes hold of it; `preventDefault` forbids that.', detail: DRAG },
  bodydrag: { doc: 'Who holds it moved.', detail: DRAG },
  bodydragend: { doc: 'It is held no more; `reason` says why.', detail: DRAG },
  physicsready: { doc: 'Its world has started.', detail: 'Record<string, unknown>' },
  physicslag: { doc: 'Time was dropped.', detail: '{ dropped: number; time: number }' },
  physicsaccuracy: {
    doc: 'Another accuracy level is in force; `because` says why (`asked`, or with auto `over budget`, `room for more`).',
    detail: '{ level: string; from: string; because: string; p90?: number }',
  },
  beforestep: { doc: 'A step begins; what is done now acts in it.', detail: STEP },
  afterstep: { doc: 'A step is over.', detail: STEP },
  physicsproblem: {
    doc: 'Something that the author should know.',
    detail: '{ code: string; severity: string; message: string; element: Element }',
  },
};

/** Of what may be dragged. */
const DRAGGED = ['RigidBody', 'Rope', 'Cloth', 'SoftBody'];
const DRAGS = ['bodydragstart', 'bodydrag', 'bodydragend'];

export const COLLISIONS = ['collisionstart', 'collisionend'];
/** Sent with each step. */
export const STEPS = ['beforestep', 'afterstep'];

const WATER_EVENTS = ['waterenter', 'waterleave'];

const GIVE_WAY = new Set(['Rope', 'Cloth', 'SoftBody']);

const WITH_STOPS = new Set(['SingleAxisHingeJoint', 'DoubleAxisHingeJoint', 'SliderJoint']);

/** The events of one node that its own node in the core sends. */
export function nodeEvents(type: string): string[] {
  if (type === 'RigidBody') return [...COLLISIONS, 'sleep', 'wake', ...WATER_EVENTS];
  if (GIVE_WAY.has(type)) return WATER_EVENTS;
  // A collidable without a body collides itself.
  if (type.startsWith('Collidable')) return COLLISIONS;
  return WITH_STOPS.has(type) ? ['jointlimit'] : [];
}

/** All that fire at its element. */
export function eventsAt(type: string): string[] {
  const worlds =
    type === 'RigidBodyCollection'
      ? ['physicsready', 'physicslag', 'physicsaccuracy', ...STEPS]
      : [];
  const drags = DRAGGED.includes(type) ? DRAGS : [];
  return [...nodeEvents(type), ...drags, ...worlds, 'physicsproblem'];
}
