import { dot3 } from '../../base/flat-math.js';
import { scale } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { bodyAAt, bodyBAt, solverDistanceAt } from '../../engine/manifold.js';
import { isCarried, readLoad, readVelocity } from '../../engine/solver-body.js';
import type { Vec3 } from '../../fields/types.js';
import { carrying } from '../drag/effects.js';
import type { Effects } from '../effect/effects.js';
import { flight } from '../flight/flight.js';
import { C, type ConeContacts } from './cone-contacts.js';
import type { Part } from './part.js';
import type { SolveBodies } from './solve-bodies.js';
import { SIZE } from './sparse-cholesky.js';

/** What turns more slowly than this trembles, rad/s: boxes that slide do. */
const TREMBLING = 0.0015;

/** Normals and speeds that differ by this share are the same. */
const SAME = 1e-6;

/**
 * What lies flat on something that its author moves, and touches nothing else, sticks and slips by turns. Contacts are
 * solved for the end of a step; when in it that changes, `Carrying` knows, who is told here how much friction gives.
 */
export class Grips {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #bodies: SolveBodies;
  readonly #contacts: ConeContacts;
  readonly #from = new Float64Array(SIZE);
  readonly #load = new Float64Array(SIZE);
  readonly #carried = new Float64Array(SIZE);

  constructor(
    simulation: Simulation,
    effects: Effects,
    bodies: SolveBodies,
    contacts: ConeContacts,
  ) {
    this.#simulation = simulation;
    this.#effects = effects;
    this.#bodies = bodies;
    this.#contacts = contacts;
  }

  /** A part was solved, and Bullet's points are what they were. */
  tell(part: Part): void {
    const carries = this.#effects.caused(carrying);
    if (!carries || !this.#touches(part)) return;
    const { ammo } = this.#simulation.engine;
    const on = this.#onlyCarrier(part);
    if (on === undefined) return;
    const number = part.bodies[0]!;
    const pointer = this.#bodies.pointers[number]!;
    const body = this.#simulation.bodyAt(pointer)!;
    readVelocity(ammo, pointer, this.#from, 0);
    if (!this.#slides(body, number) || !this.#isPlain(part, on)) return;
    readLoad(ammo, pointer, this.#load, 0);
    carries.grips(body, {
      on,
      normal: this.#normalOf(part),
      friction: this.#frictionOf(part),
      pull: scale(vector(this.#load), 1 / this.#bodies.masses[number]!),
      from: vector(this.#from),
    });
  }

  /** Not only near. */
  #touches({ contacts }: Part): boolean {
    const { bullet, engine } = this.#simulation;
    const { pointers } = this.#contacts;
    return contacts.some(
      (i) => solverDistanceAt(engine.ammo, pointers[i]!) < bullet.settings.linearSlop,
    );
  }

  /** What the one body of a part lies on, by pointer, where that is one that is carried. */
  #onlyCarrier({ bodies, manifolds, jointed }: Part): number | undefined {
    if (bodies.length > 1 || manifolds.length > 1 || jointed) return undefined;
    const { ammo } = this.#simulation.engine;
    const [a, b] = [bodyAAt(ammo, manifolds[0]!), bodyBAt(ammo, manifolds[0]!)];
    const on = a === this.#bodies.pointers[bodies[0]!] ? b : a;
    return isCarried(ammo, on) ? on : undefined;
  }

  /** Whether it turns neither before nor after the step, and nothing else is to happen to it. */
  #slides(body: Body, number: number): boolean {
    const { velocities } = this.#bodies;
    const at = number * SIZE + 3;
    return (
      dot3(this.#from, 3, this.#from, 3) < TREMBLING ** 2 &&
      dot3(velocities, at, velocities, at) < TREMBLING ** 2 &&
      body.dampedShare.linear === 0 &&
      (this.#effects.caused(flight)?.glides(body) ?? false)
    );
  }

  /** Whether all contacts face one way and none throws back, over a surface that moves only with its body. */
  #isPlain({ contacts }: Part, on: number): boolean {
    const { values: c, b } = this.#contacts;
    readVelocity(this.#simulation.engine.ammo, on, this.#carried, 0);
    const first = contacts[0]! * C.size;
    const speed = 1 + Math.sqrt(dot3(this.#carried, 0, this.#carried, 0));
    return contacts.every((i) => {
      const at = i * C.size;
      const sign = b[i]! < 0 ? 1 : -1;
      for (let k = 1; k < 3; k++) {
        const own = c[at + C.driven + k]! - sign * dot3(c, at + 3 * k, this.#carried, 0);
        if (Math.abs(own) > SAME * speed) return false;
      }
      return c[at + C.back] === 0 && dot3(c, first, c, at) > 1 - SAME;
    });
  }

  /** Into the body. */
  #normalOf({ contacts: [first] }: Part): Vec3 {
    const { values, a } = this.#contacts;
    return scale(vector(values, first! * C.size + C.normal), a[first!]! < 0 ? -1 : 1);
  }

  /** The mean of its contacts. */
  #frictionOf({ contacts }: Part): number {
    const { values } = this.#contacts;
    return contacts.reduce((sum, i) => sum + values[i * C.size + C.friction]!, 0) / contacts.length;
  }
}

const vector = (v: Float64Array, at = 0): Vec3 => [v[at]!, v[at + 1]!, v[at + 2]!];
