import { cross3, dot3 } from '../../base/flat-math.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { ContactPoint, CORNER } from '../../engine/contact-point.js';
import { isCarried } from '../../engine/solver-body.js';
import type { Numbered } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { flight, type Turning } from '../flight/flight.js';
import { gyroscopic } from '../flight/gyroscopic.js';
import { C, speeds, type ConeContacts } from '../../solver/rows/cone-contacts.js';
import { turnedEvenly } from './even-push.js';
import type { TouchingBodies } from './touching-bodies.js';
import { isFlatAt, rollingPartAt, wandering } from './wandering.js';
import { SIZE } from '../../solver/matrix/block-cholesky.js';

/** What turns more slowly than this trembles, rad/s (boxes that slide do so by 0.0014); what turns farther in a step goes no way that is known beforehand, radians. */
const RESTING = 0.0015;
const FARTHEST = 0.5;

/**
 * A corner that lies on a face of another body turns with its own. Held with the arms of the start of a step it would leave
 * the face a little in each, and the error go with the step. Here contacts push where the corner is in the middle of the
 * step, and are to be whole with the arms of its end; bodies go on with the mean of the speeds at both ends (`Flight`). So
 * the error goes with the square of the step (a box that tips over: 26 µm at 1/120 s instead of 840).
 */
export class TurningCorners {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #bodies: TouchingBodies;
  readonly #contacts: ConeContacts;
  readonly #point: ContactPoint;
  /** Of the corner, and of it against the middle of a body, m/s; what the turn adds to the speeds of the contact, m/s². */
  readonly #speed = new Float64Array(3);
  readonly #against = new Float64Array(3);
  readonly #swing = new Float64Array(3);
  readonly #turned = new Float64Array(3);
  readonly #met = new Set<number>();
  /** What is round, and rolls elsewhere than about its centre of mass. */
  readonly #rolling = new Set<Body>();

  constructor(
    simulation: Simulation,
    effects: Effects,
    bodies: TouchingBodies,
    contacts: ConeContacts,
  ) {
    this.#simulation = simulation;
    this.#effects = effects;
    this.#bodies = bodies;
    this.#contacts = contacts;
    this.#point = new ContactPoint(simulation.engine.ammo);
  }

  /** For a snapshot: ids of what rolled. */
  save(): number[] {
    return [...this.#rolling].map(({ id }) => id);
  }

  load(ids: readonly number[], nodes: Numbered): void {
    this.#rolling.clear();
    for (const id of ids) {
      const body = nodes.body(id);
      if (body) this.#rolling.add(body);
    }
  }

  /** A step begins. */
  begin(): void {
    this.#rolling.clear();
  }

  /** Radians that what rolled in the last step turns in this one, at most. */
  turnRolling(dt: number): number {
    let most = 0;
    for (const body of this.#rolling) {
      const { velocities } = this.#simulation.bodies;
      const at = body.slot * VELOCITY + 3;
      if (body.active && !body.sleeping)
        most = Math.max(most, dot3(velocities, at, velocities, at));
    }
    return Math.sqrt(most) * dt;
  }

  /** The contacts of a pair were read, those from `first` on, of the bodies with these pointers. */
  read(contacts: readonly number[], first: number, a: number, b: number, dt: number): void {
    const { values: c } = this.#contacts;
    let touched = false;
    for (let i = first; i < contacts.length; i++)
      touched ||= c[contacts[i]! * C.size + C.impulse]! > 0;
    for (let i = first; i < contacts.length; i++) {
      const at = contacts[i]! * C.size;
      for (let k = 0; k < 3; k++) c[at + C.wandering + k] = 0;
      if (c[at + C.corner] === CORNER.ofNone) this.#round(contacts[i]!, a, b);
      c[at + C.meets] = !touched && this.#approaches(contacts[i]!) ? 1 : 0;
      if (c[at + C.corner] !== CORNER.ofNone) this.#lead(contacts[i]!, a, b, dt);
    }
  }

  /** Of these, nothing is reckoned with. */
  leave(contacts: readonly number[], first: number): void {
    const { values: c } = this.#contacts;
    for (let i = first; i < contacts.length; i++) {
      const at = contacts[i]! * C.size;
      c[at + C.corner] = CORNER.ofNone;
      c[at + C.meets] = 0;
    }
  }

  /** What is round and touched elsewhere in each moment is a corner, too, that wanders over its body. */
  #round(contact: number, pointerA: number, pointerB: number): void {
    const { pointers, a, b } = this.#contacts;
    const at = contact * C.size;
    const point = this.#point.at(pointers[contact]!, pointerA, pointerB);
    const bodyA = this.#bodyAt(pointerA);
    const bodyB = this.#bodyAt(pointerB);
    const ofA = rollingPartAt(point, bodyA, 0);
    const ofB = rollingPartAt(point, bodyB, 1);
    if (ofA && isFlatAt(point, bodyB, 1)) this.#rolls(at, CORNER.ofA, ofA, bodyA, a[contact]!);
    else if (ofB && isFlatAt(point, bodyA, 0)) this.#rolls(at, CORNER.ofB, ofB, bodyB, b[contact]!);
  }

  /** On this part of it; `number`: its own among those that touch, -1 where it does not move. */
  #rolls(at: number, corner: number, part: CollidablePart, body: Body, number: number): void {
    const { values: c } = this.#contacts;
    c[at + C.corner] = corner;
    this.#rolling.add(body);
    if (number < 0) return;
    const { velocities: v } = this.#bodies;
    const sign = corner === CORNER.ofA ? -1 : 1;
    const outwards = [0, 1, 2].map((k) => sign * c[at + C.normal + k]!) as Vec3;
    const spin = [3, 4, 5].map((k) => v[SIZE * number + k]!) as Vec3;
    c.set(wandering(part, body, outwards, spin), at + C.wandering);
  }

  #approaches(contact: number): boolean {
    const { values: c, a, b } = this.#contacts;
    const at = contact * C.size;
    speeds(c, at, this.#bodies.velocities, a[contact]!, b[contact]!, C.miss);
    return c[at + C.miss]! < 0;
  }

  #lead(contact: number, pointerA: number, pointerB: number, dt: number): void {
    const { values: c, a, b } = this.#contacts;
    const at = contact * C.size;
    const p = a[contact]!;
    const q = b[contact]!;
    const owner = c[at + C.corner] === CORNER.ofA ? p : q;
    const bounces = c[at + C.target]! > 0;
    if (owner < 0 || bounces || this.#carried(p, pointerA) || this.#carried(q, pointerB)) {
      c[at + C.corner] = CORNER.ofNone;
      return;
    }
    // It may begin to turn in this step.
    const spin = this.#spinOf(owner);
    if (spin < RESTING) return;
    if (spin * dt > FARTHEST || !this.#glides(p, pointerA) || !this.#glides(q, pointerB)) {
      c[at + C.corner] = CORNER.ofNone;
      return;
    }
    this.#readSpeed(at, owner, owner === p);
    this.#swing.fill(0);
    this.#turn(c, at + C.armA, p, 1, dt);
    this.#turn(c, at + C.armB, q, -1, dt);
    this.#spinOn(c, at + C.armA, p, pointerA, 2 / dt);
    this.#spinOn(c, at + C.armB, q, pointerB, -2 / dt);
    for (let k = 0; k < 3; k++)
      c[at + C.target + k]! -= (dt / 2) * dot3(c, at + 3 * k, this.#swing, 0);
  }

  /** How fast the corner goes. */
  #readSpeed(at: number, owner: number, isA: boolean): void {
    const { values: c } = this.#contacts;
    const { velocities: v } = this.#bodies;
    cross3(this.#speed, 0, v, SIZE * owner + 3, c, at + (isA ? C.armA : C.armB));
    for (let k = 0; k < 3; k++) this.#speed[k]! += v[SIZE * owner + k]! + c[at + C.wandering + k]!;
  }

  /** rad/s */
  #spinOf(body: number): number {
    const { velocities: v } = this.#bodies;
    const at = SIZE * body + 3;
    return Math.sqrt(dot3(v, at, v, at));
  }

  #carried(body: number, pointer: number): boolean {
    return body < 0 && isCarried(this.#simulation.engine.ammo, pointer);
  }

  /** Whether it stands still, or goes on with the mean of its speeds. */
  #glides(body: number, pointer: number): boolean {
    return body < 0 || (this.#effects.caused(flight)?.glides(this.#bodyAt(pointer)) ?? false);
  }

  #bodyAt(pointer: number): Body {
    return this.#simulation.bodyAt(pointer)!;
  }

  /** An arm goes to where it is in the middle of the step. */
  #turn(c: Float64Array, arm: number, body: number, sign: 1 | -1, dt: number): void {
    const { velocities: v } = this.#bodies;
    const against = this.#against;
    const turned = this.#turned;
    for (let k = 0; k < 3; k++) {
      against[k] = this.#speed[k]! - (body < 0 ? 0 : v[SIZE * body + k]!);
      c[arm + k]! += (dt / 2) * against[k]!;
    }
    if (body < 0) return;
    cross3(turned, 0, v, SIZE * body + 3, against, 0);
    for (let k = 0; k < 3; k++) this.#swing[k]! += sign * turned[k]!;
  }

  /** Bullet has the spin that a top has in the middle of the step; what it has at the end is to meet the contact. */
  #spinOn(c: Float64Array, arm: number, body: number, pointer: number, share: number): void {
    const spin =
      body < 0 ? undefined : this.#effects.caused(gyroscopic)?.spinOf(this.#bodyAt(pointer));
    if (!spin) return;
    const gained = this.#against;
    const turned = this.#turned;
    for (let k = 0; k < 3; k++) gained[k] = spin.end[k]! - spin.given[k]! + spin.missed[k]!;
    cross3(turned, 0, gained, 0, c, arm);
    for (let k = 0; k < 3; k++) this.#swing[k]! += share * turned[k]!;
  }

  /** They were solved: what turns about one of them is to go on with the mean of its speeds, however slow it is. */
  tell(contacts: readonly number[]): void {
    const { values: c } = this.#contacts;
    for (const i of contacts) {
      const at = i * C.size;
      // What meets something only in this step loses its speed there, and not evenly.
      if (c[at + C.meets]! > 0 && c[at + C.impulse]! > 0) this.#eachTurning(i, this.#meets);
    }
    for (const i of contacts)
      if (c[i * C.size + C.corner] !== CORNER.ofNone) this.#eachTurning(i, this.#turns);
    this.#met.clear();
  }

  readonly #meets = (body: number): unknown => this.#met.add(body);

  readonly #turns = (body: number): void => {
    if (this.#met.has(body)) return;
    const node = this.#bodyAt(this.#bodies.pointers[body]!);
    const { velocities } = this.#simulation.bodies;
    const at = node.slot * VELOCITY + 3;
    const rested = dot3(velocities, at, velocities, at) < RESTING ** 2;
    this.#effects.caused(flight)?.turnsOn(node, rested ? this.#begins : this.#goesOn);
  };

  readonly #goesOn = this.#turning(false);
  readonly #begins = this.#turning(true);

  #turning(begins: boolean): Turning {
    const to: Turning['to'] = (body, velocity, dt) => {
      const spins = this.#effects.caused(gyroscopic);
      return spins && turnedEvenly(spins, body, velocity, dt, begins);
    };
    return { to, begins };
  }

  #eachTurning(contact: number, visit: (body: number) => void): void {
    const { a, b } = this.#contacts;
    for (const body of [a[contact]!, b[contact]!])
      if (body >= 0 && this.#spinOf(body) > RESTING) visit(body);
  }
}
