import type { Value, Vec3 } from '../../fields/types.js';
import { dot, length } from '../../base/math.js';
import type { CollidableNode } from './collidable.js';
import type { Body } from '../../dynamics/body.js';
import type { Contact, Touching } from '../../dynamics/contact.js';
import type { ContactParameters } from '../../dynamics/contact-parameters.js';
import type { NodeContext } from '../node/node-world.js';
import { contactParameters } from '../../effects/contacts/parameters.js';
import { PhysicsNode } from '../node/node.js';

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
    const parameters = contactParameters(this, 'slipCoefficients');
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
