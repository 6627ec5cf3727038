import { ContactPoint } from '../../engine/contact-point.js';
import { add } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Collidable } from '../../dynamics/collidable.js';
import type { Collider } from '../../dynamics/pairs.js';
import type { Sensor } from '../../dynamics/sensor.js';
import type { SimulationNode } from '../../dynamics/node.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { eachContactPoint, TOUCHING } from './contact-points.js';
import { partAt } from './contact-part.js';
import { Effect, type Cause } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { givenContacts } from './effects.js';
import { Touches, type TouchPoint } from './touches.js';

type Visit = (pointer: number, a: Body, b: Body) => void;

/** What of its collisions is listened to. */
const heardBy = (node: SimulationNode): string | undefined =>
  node.heard('collisionstart')
    ? 'collisionstart'
    : node.heard('collisionend')
      ? 'collisionend'
      : undefined;

/** Reads what touches after each step, for CollisionSensors and for listeners to collisions of bodies. */
export class ContactReader extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #touches: Touches;
  readonly #sensors = new Set<Sensor>();
  /** Whether anybody listens to collisions at all. */
  #listening = false;
  /** Somebody ceased to listen: the next step finds out whether another does. */
  #ceased = false;
  #readPoint: ContactPoint | undefined;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    this.#touches = new Touches((touch, into) => this.#pointsOf(touch.a, touch.b, into));
  }

  get #point(): ContactPoint {
    return (this.#readPoint ??= new ContactPoint(this.#simulation.engine.ammo));
  }

  // ---- who needs it -----------------------------------------------------------------------------------------------

  /**
   * Somebody began or ceased to listen to a body, or to a collidable without one. Frameworks cease and begin again with
   * each rendering: a touch goes on meanwhile.
   */
  update(node: SimulationNode): void {
    const event = heardBy(node);
    if (event && !node.removed) this.need(node, event);
    else this.#ceased = true;
  }

  override beforeStep(): void {
    if (!this.#ceased) return;
    this.#ceased = false;
    for (const node of this.causes as Iterable<SimulationNode>)
      if (!this.#sensors.has(node as Sensor) && !heardBy(node)) super.release(node);
    this.#lookWhoListens();
  }

  override need(node: Cause, reason: string): void {
    super.need(node, reason);
    this.#lookWhoListens();
  }

  override release(node: Cause): void {
    super.release(node);
    this.#lookWhoListens();
  }

  /** A body that is made anew goes on touching and being listened to. */
  override unmade(node: Cause): void {
    if ((node as SimulationNode).removed) this.release(node);
  }

  /** What a sensor looks at is to be known after each step. */
  watch(sensor: Sensor): void {
    this.#sensors.add(sensor);
    this.need(sensor, 'CollisionSensor');
    this.#simulation.pairs.watchChanged();
  }

  ignore(sensor: Sensor): void {
    this.#sensors.delete(sensor);
    this.release(sensor);
    this.#simulation.pairs.watchChanged();
  }

  /** What sensors look at. */
  get watched(): Collider[] {
    return [...this.#sensors].map((sensor) => sensor.collider!);
  }

  #lookWhoListens(): void {
    this.#listening = false;
    for (const node of this.causes) if (!this.#sensors.has(node as Sensor)) this.#listening = true;
    if (!this.#listening) this.#touches.forget();
  }

  /** Whether the node touches another; known while somebody listens to its collisions. */
  colliding(node: SimulationNode): boolean {
    return this.#touches.touching(node);
  }

  /** The body is no longer in the world. */
  part(body: Body, reason: 'removed' | 'disabled'): void {
    this.#touches.part(body, reason, this.#simulation.time);
  }

  /** The world begins anew, or ends. */
  override reset(reason: 'reset' | 'removed' = 'reset'): void {
    this.#touches.endAll(reason, this.#simulation.time);
  }

  // ---- after each step --------------------------------------------------------------------------------------------

  override afterStep(): void {
    this.#effects.find(givenContacts)?.forget();
    this.#touches.begin();
    for (const sensor of this.#sensors) sensor.beginSensing();
    eachContactPoint(this.#simulation, this.#read);
    for (const sensor of this.#sensors) sensor.finishSensing();
    this.#touches.finish(this.#simulation.time);
  }

  readonly #read: Visit = (pointer, a, b) => {
    const point = this.#point.at(pointer, a.pointer, b.pointer);
    const { distance } = point;
    if (this.#listening && (heardBy(a.standsFor) || heardBy(b.standsFor)))
      this.#touches.note(a, b, distance, point.impulse);
    if (distance > TOUCHING) return;
    for (const sensor of this.#sensors) this.#sense(sensor, point, a, b);
  };

  #sense(sensor: Sensor, point: ContactPoint, a: Body, b: Body): void {
    const [first, second] = this.#collidablesAt(point, a, b);
    if (first && second && this.#watches(sensor.collider!, first, second))
      sensor.noteTouch(first, second);
  }

  #collidablesAt(
    point: ContactPoint,
    a: Body,
    b: Body,
  ): [Collidable | undefined, Collidable | undefined] {
    return [partAt(point, a, 0), partAt(point, b, 1)];
  }

  #watches(collider: Collider, a: Collidable, b: Collidable): boolean {
    return collider.enabled && this.#simulation.pairs.speaksFor(collider, a, b);
  }

  // ---- what touches, in full --------------------------------------------------------------------------------------

  /** The contact points of the last step that a sensor watches. `point` is moved on from one to the next. */
  eachWatched(
    sensor: Sensor,
    visit: (point: ContactPoint, a: Body, b: Body, first: Collidable, second: Collidable) => void,
  ): void {
    const { collider } = sensor;
    if (!collider) return;
    eachContactPoint(this.#simulation, (pointer, a, b) => {
      const point = this.#point.at(pointer, a.pointer, b.pointer);
      if (point.distance > TOUCHING) return;
      const [first, second] = this.#collidablesAt(point, a, b);
      if (first && second && this.#watches(collider, first, second))
        visit(point, a, b, first, second);
    });
  }

  /** Where two bodies touch, for the event of one of them. */
  #pointsOf(a: Body, b: Body, into: Body): TouchPoint[] {
    const points: TouchPoint[] = [];
    eachContactPoint(this.#simulation, (pointer, first, second) => {
      if ((first !== a || second !== b) && (first !== b || second !== a)) return;
      const point = this.#point.at(pointer, first.pointer, second.pointer);
      points.push({
        position: add(point.positionVector(), this.#simulation.poses.origin),
        normal: point.normalVector(first === into ? 1 : -1),
        depth: -point.distance,
        impulse: point.impulse,
      });
    });
    return points;
  }
}
