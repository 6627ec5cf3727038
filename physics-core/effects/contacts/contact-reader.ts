import { ContactPoint } from '../../engine/contact-point.js';
import { MANIFOLD_POINT as POINT } from '../../engine/offsets.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from '../../nodes/body.js';
import type { CollidableNode } from '../../nodes/collidable.js';
import type { CollisionCollectionNode } from '../../nodes/collision-collection.js';
import { CollisionSensorNode } from '../../nodes/collision-sensor.js';
import type { ContactNode } from '../../nodes/contact.js';
import type { PhysicsNode } from '../../nodes/node.js';
import type { World } from '../../world/world.js';
import { eachContactPoint } from './contact-points.js';
import { foundContact } from '../../nodes/found-contact.js';
import { partAt } from './contact-part.js';
import { Effect } from '../effect.js';
import { Touches, type TouchPoint } from './touches.js';

/** A resting sphere has a distance of 1.5e-16 in some steps, so a sensor needs a tolerance, metres. */
const TOUCHING = 0.0005;

type Visit = (pointer: number, a: BodyNode, b: BodyNode) => void;

/** What of its collisions is listened to. */
const heardBy = (node: PhysicsNode): string | undefined =>
  node.heard('collisionstart')
    ? 'collisionstart'
    : node.heard('collisionend')
      ? 'collisionend'
      : undefined;

/** Reads what touches after each step, for CollisionSensors and for listeners to collisions of bodies. */
export class ContactReader extends Effect {
  readonly name = 'contact reading';
  readonly #world: World;
  readonly #touches: Touches;
  readonly #sensors = new Set<CollisionSensorNode>();
  /** Whether anybody listens to collisions at all. */
  #listening = false;
  /** Somebody ceased to listen: the next step finds out whether another does. */
  #ceased = false;
  #readPoint: ContactPoint | undefined;

  constructor(world: World) {
    super();
    this.#world = world;
    this.#touches = new Touches((touch, into) => this.#pointsOf(touch.a, touch.b, into));
  }

  get #point(): ContactPoint {
    return (this.#readPoint ??= new ContactPoint(this.#world.engine.ammo));
  }

  // ---- who needs it -----------------------------------------------------------------------------------------------

  /**
   * Somebody began or ceased to listen to a body, or to a collidable without one. Frameworks cease and begin again with
   * each rendering: a touch goes on meanwhile.
   */
  update(node: PhysicsNode): void {
    const event = heardBy(node);
    if (event && !node.removed) this.need(node, event);
    else this.#ceased = true;
  }

  override beforeStep(): void {
    if (!this.#ceased) return;
    this.#ceased = false;
    for (const node of this.causes as Iterable<PhysicsNode>)
      if (!(node instanceof CollisionSensorNode) && !heardBy(node)) super.drop(node);
    this.#sortCauses();
  }

  override need(node: PhysicsNode, reason: string): void {
    super.need(node, reason);
    this.#sortCauses();
    if (node instanceof CollisionSensorNode) this.#world.pairs.watchChanged();
  }

  /** A body that is made anew goes on touching and being listened to. */
  override drop(node: PhysicsNode): void {
    if (!(node instanceof CollisionSensorNode) && !node.removed) return;
    super.drop(node);
    this.#sortCauses();
    if (node instanceof CollisionSensorNode) this.#world.pairs.watchChanged();
  }

  /** What sensors look at. */
  get watched(): CollisionCollectionNode[] {
    return [...this.#sensors].map((sensor) => sensor.collider!);
  }

  #sortCauses(): void {
    this.#listening = false;
    this.#sensors.clear();
    for (const node of this.causes)
      if (node instanceof CollisionSensorNode) this.#sensors.add(node);
      else this.#listening = true;
    if (!this.#listening) this.#touches.forget();
  }

  /** Whether the node touches another; known while somebody listens to its collisions. */
  colliding(node: PhysicsNode): boolean {
    return this.#touches.touching(node);
  }

  /** The body is no longer in the world. */
  part(body: BodyNode, reason: 'removed' | 'disabled'): void {
    this.#touches.part(body, reason, this.#world.time);
  }

  /** The world begins anew, or ends. */
  reset(reason: 'reset' | 'removed' = 'reset'): void {
    this.#touches.endAll(reason, this.#world.time);
  }

  // ---- after each step --------------------------------------------------------------------------------------------

  override afterStep(): void {
    if (!this.#world.engine.heapTrusted) return;
    this.#world.registry.given.forget();
    this.#touches.begin();
    for (const sensor of this.#sensors) sensor.beginSensing();
    eachContactPoint(this.#world, this.#read);
    for (const sensor of this.#sensors) sensor.finishSensing();
    this.#touches.finish(this.#world.time);
  }

  readonly #read: Visit = (pointer, a, b) => {
    const point = this.#point.at(pointer, a.pointer, b.pointer);
    const { distance } = point;
    if (this.#listening && (heardBy(a.standsFor) || heardBy(b.standsFor)))
      this.#touches.note(a, b, distance, point.get(POINT.impulse));
    if (distance > TOUCHING) return;
    for (const sensor of this.#sensors) this.#sense(sensor, pointer, a, b);
  };

  #sense(sensor: CollisionSensorNode, pointer: number, a: BodyNode, b: BodyNode): void {
    const [first, second] = this.#collidablesAt(pointer, a, b);
    if (first && second && this.#watches(sensor.collider!, first, second))
      sensor.noteTouch(first, second);
  }

  #collidablesAt(
    pointer: number,
    a: BodyNode,
    b: BodyNode,
  ): [CollidableNode | undefined, CollidableNode | undefined] {
    const { ammo } = this.#world.engine;
    return [partAt(ammo, a, pointer, 0), partAt(ammo, b, pointer, 1)];
  }

  #watches(collider: CollisionCollectionNode, a: CollidableNode, b: CollidableNode): boolean {
    return collider.asked<boolean>('enabled') && this.#world.pairs.speaksFor(collider, a, b);
  }

  // ---- what touches, in full --------------------------------------------------------------------------------------

  /** The contacts of the last step that a sensor watches, each a new node of its own. */
  contactsOf(sensor: CollisionSensorNode): ContactNode[] {
    const contacts: ContactNode[] = [];
    const { collider } = sensor;
    if (!collider || !this.#world.engine.heapTrusted) return contacts;
    eachContactPoint(this.#world, (pointer, a, b) => {
      if (this.#point.at(pointer, a.pointer, b.pointer).distance > TOUCHING) return;
      const [first, second] = this.#collidablesAt(pointer, a, b);
      if (!first || !second || !this.#watches(collider, first, second)) return;
      contacts.push(
        foundContact(this.#point.at(pointer, a.pointer, b.pointer), a, b, first, second),
      );
    });
    this.#world.registry.given.report(contacts);
    return contacts;
  }

  /** Where two bodies touch, for the event of one of them. */
  #pointsOf(a: BodyNode, b: BodyNode, into: BodyNode): TouchPoint[] {
    const points: TouchPoint[] = [];
    eachContactPoint(this.#world, (pointer, first, second) => {
      if ((first !== a || second !== b) && (first !== b || second !== a)) return;
      const point = this.#point.at(pointer, first.pointer, second.pointer);
      const sign = first === into ? 1 : -1;
      const three = (offset: number, scale: number): Vec3 => [
        point.get(offset, 0) * scale,
        point.get(offset, 1) * scale,
        point.get(offset, 2) * scale,
      ];
      points.push({
        position: three(POINT.positionB, 1),
        normal: three(POINT.normalB, sign),
        depth: -point.distance,
        impulse: point.get(POINT.impulse),
      });
    });
    return points;
  }
}
