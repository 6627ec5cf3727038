import type { Value, Vec3 } from '../../fields/types.js';
import { dot, length } from '../../base/math.js';
import type { CollidableNode } from './collidable.js';
import type { Body } from '../../dynamics/body.js';
import type { Contact, Touching } from '../../dynamics/contact.js';
import type { ContactParameters } from '../../dynamics/contact-parameters.js';
import type { NodeContext } from '../node/node-world.js';
import { contacts } from '../../effects/effect/chunks.js';
import { PhysicsNode } from '../node/node.js';
import { defineNode } from '../node/define.js';

/** Cosine from which a direction is the normal itself and says nothing. */
const PARALLEL = 0.999999;

/** What a sensor found: the fields of a Contact, and the bodies as Bullet has them. */
export interface FoundContact {
  pair: readonly [Body, Body];
  fields: Readonly<Record<string, Value>>;
}

/**
 * One point where two collidables touch. Those that a CollisionSensor sends stand in no list of the world: they go
 * when nobody holds them any more.
 */
export class ContactNode extends PhysicsNode implements Contact {
  /** What the sensor found, by field; undefined: a page or an author made it. */
  readonly #fields: Readonly<Record<string, Value>> | undefined;
  readonly found: Touching | undefined;

  /** Bodies of the point as Bullet has them, also those that stand for a collidable alone. */
  readonly pair: readonly [Body, Body] | undefined;
  /** Page code wrote something, or made it. */
  isChanged: boolean;

  constructor(context: NodeContext, found?: FoundContact) {
    super(context);
    this.pair = found?.pair;
    this.#fields = found?.fields;
    this.found = found && this.touching;
    this.isChanged = !found;
  }

  override asked<T = Value>(name: string): T {
    const fields = this.#fields;
    const isFound = fields && name in fields && !super.authored(name);
    return isFound ? (fields[name] as T) : super.asked(name);
  }

  override authored(name: string): boolean {
    return super.authored(name) || (this.#fields !== undefined && name in this.#fields);
  }

  /** Nothing in Bullet waits for it: set_contacts reads it. */
  override touch(name: string): void {
    this.isChanged = true;
    if (!this.found) super.touch(name);
  }

  get touching(): Touching {
    return {
      position: this.asked('position'),
      normal: this.asked('contactNormal'),
      depth: this.asked('depth'),
      first: this.asked<CollidableNode | null>('geometry1'),
      second: this.asked<CollidableNode | null>('geometry2'),
    };
  }

  /** Body1 and body2: those named, or those of the geometries. */
  get bodies(): (Body | undefined)[] {
    return ([1, 2] as const).map(
      (i) =>
        this.asked<Body | null>(`body${i}`) ??
        this.asked<CollidableNode | null>(`geometry${i}`)?.owner,
    );
  }

  wakeBodies(): void {
    for (const body of this.bodies) body?.wake();
  }

  get parameters(): ContactParameters {
    const parameters = contacts.code.contactParameters(this, 'slipCoefficients');
    const normal = this.asked<Vec3>('contactNormal');
    const direction = this.asked<Vec3>('frictionDirection');
    const size = length(direction) * length(normal);
    const given = this.asked<string[]>('appliedParameters').some(
      (token) => token.toUpperCase() === 'USER_FRICTION',
    );
    if (given && Math.abs(dot(normal, direction)) < PARALLEL * size)
      parameters.direction = direction;
    return parameters;
  }
}

export const contact = defineNode<ContactNode>({
  name: 'Contact',
  containerField: 'contacts',
  clause: '37.4.7',
  doc: 'A point where two collidables touch, for one step; page code may change it and hand it to set_contacts.',
  rank: 5,
  chunk: contacts,
  make: (context) => new ContactNode(context),
  fields: {
    appliedParameters: {
      type: 'MFString',
      access: 'inputOutput',
      default: ['BOUNCE'],
      edit: 'passive',
      doc: 'Which parameters act, as on a CollisionCollection; USER_FRICTION gives frictionDirection.',
    },
    body1: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['RigidBody'],
      edit: 'passive',
      doc: 'The body that the normal points into: the one that moves, of two that do the one made later. NULL: none.',
    },
    body2: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['RigidBody'],
      edit: 'passive',
      doc: 'The other body; NULL where the collidable belongs to none.',
    },
    bounce: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, 1],
      edit: 'passive',
      doc: 'Share of the approach speed that comes back.',
    },
    contactNormal: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 1, 0],
      edit: 'passive',
      doc: 'Unit vector into body1: moved along it, body1 comes free. World frame.',
    },
    depth: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      dimension: { length: 1 },
      edit: 'passive',
      doc: 'Depth of the overlap, metres; negative is a gap.',
    },
    frictionCoefficients: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      range: [0, Infinity],
      edit: 'passive',
      doc: 'Coulomb friction along direction 1 and 2; without FRICTION_COEFFICIENT-2 the first acts in both.',
    },
    frictionDirection: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 1, 0],
      edit: 'passive',
      doc: 'Friction direction 1, world frame; acts with USER_FRICTION. Along the normal it says nothing.',
    },
    geometry1: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['CollidableShape', 'CollidableOffset'],
      edit: 'passive',
      doc: 'The collidable of body1.',
    },
    geometry2: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['CollidableShape', 'CollidableOffset'],
      edit: 'passive',
      doc: 'The collidable of body2.',
    },
    minBounceSpeed: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      dimension: { length: 1 },
      edit: 'passive',
      doc: 'Approach speed below which nothing bounces, m/s.',
    },
    position: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 0, 0],
      dimension: { length: 1 },
      edit: 'passive',
      doc: 'Where they touch, metres, world frame.',
    },
    slipCoefficients: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      dimension: { length: 1, force: -1 },
      edit: 'passive',
      doc: 'Sliding speed per tangential force along direction 1 and 2, (m/s)/N. Below 0 counts as 0.',
    },
    softnessConstantForceMix: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.0001,
      range: [0, 1],
      edit: 'passive',
      doc: 'Softness: speed per normal force, (m/s)/N.',
    },
    softnessErrorCorrection: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.8,
      range: [0, 1],
      edit: 'passive',
      doc: 'Share of the overlap repaired per 1/60 s.',
    },
    surfaceSpeed: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      dimension: { length: 1 },
      edit: 'passive',
      doc: 'Speed at which body1 is carried along body2, direction 1 and 2, m/s.',
    },
  },
});
