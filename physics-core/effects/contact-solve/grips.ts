import { dot3 } from '../../base/flat-math.js';
import { add, dot, length, normalize, scale } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { bodyAAt, bodyBAt } from '../../engine/manifold.js';
import { solverDistanceAt } from '../../engine/manifold-points.js';
import { readLoad, readVelocity } from '../../engine/heap.js';
import { isCarried } from '../../engine/solver-body.js';
import type { Vec3 } from '../../fields/types.js';
import { carrying } from '../drag/effects.js';
import type { StepWay } from '../drag/smooth-way.js';
import type { Effects } from '../effect/effects.js';
import { flight } from '../flight/flight.js';
import { C, type ConeContacts } from '../../solver/rows/cone-contacts.js';
import type { Part } from '../../solver/part.js';
import type { TouchingBodies } from './touching-bodies.js';
import { Pulls, steadily } from './pulls.js';
import { SIZE } from '../../solver/matrix/block-cholesky.js';

/** What turns more slowly than this trembles, rad/s: boxes that slide do. */
const TREMBLING = 0.0015;

/** Contacts of what lies flat, at least, and how near they are, in depths that resting contacts keep. */
const FLAT = 3;
const NEAR = 3;

/** Normals and speeds that differ by this share are the same. */
const SAME = 1e-6;

/**
 * What lies flat on something that its author moves, and touches nothing else, sticks and slips by turns. Contacts are
 * solved for the end of a step; when in it that changes, `Carrying` knows, who is told here how much friction gives.
 */
export class Grips {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #bodies: TouchingBodies;
  readonly #contacts: ConeContacts;
  /** What pulls those that slide, from step to step. */
  readonly pulls = new Pulls();
  readonly #from = new Float64Array(SIZE);
  readonly #load = new Float64Array(SIZE);
  readonly #carried = new Float64Array(SIZE);

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
  }

  forget(body: Body): void {
    this.pulls.forget(body);
  }

  /** A part was solved, and Bullet's points are what they were. */
  tell(part: Part): void {
    const carries = this.#effects.caused(carrying);
    if (!carries) return;
    const on = this.#onlyCarrier(part);
    const nearby = part.contacts.filter(this.#touches).length;
    if (on === undefined || nearby === 0) return;
    const { ammo } = this.#simulation.engine;
    const number = part.bodies[0]!;
    const pointer = this.#bodies.pointers[number]!;
    const body = this.#simulation.bodyAt(pointer)!;
    const normal = this.#normalOf(part);
    readVelocity(ammo, pointer, this.#from, 0);
    if (!this.#slides(number, nearby < FLAT ? undefined : normal)) return;
    readLoad(ammo, pointer, this.#load, 0);
    if (dot3(this.#load, 3, this.#load, 3) > 0) return;
    if (!this.#isPushed(body) || !this.#isPlain(part, on)) return;
    const friction = this.#frictionOf(part);
    if (this.#mayTip(part, normal, friction)) return;
    const pull = this.#pullOf(body, number);
    carries.grips(body, { on, normal, friction, pull, from: vector(this.#from) });
  }

  /** Not only near. */
  readonly #touches = (i: number): boolean => {
    const { bullet, engine } = this.#simulation;
    const distance = solverDistanceAt(engine.ammo, this.#contacts.pointers[i]!);
    return distance < NEAR * bullet.settings.linearSlop;
  };

  /** What the one body of a part lies on, by pointer, where that is one that is carried. */
  #onlyCarrier({ bodies, manifolds, jointed }: Part): number | undefined {
    if (bodies.length > 1 || manifolds.length > 1 || jointed) return undefined;
    const { ammo } = this.#simulation.engine;
    const a = bodyAAt(ammo, manifolds[0]!);
    const b = bodyBAt(ammo, manifolds[0]!);
    const on = a === this.#bodies.pointers[bodies[0]!] ? b : a;
    return isCarried(ammo, on) ? on : undefined;
  }

  /** Whether it turns neither before nor after the step; what lies flat does so about the normal alone. */
  #slides(number: number, normal: Vec3 | undefined): boolean {
    const after = vector(this.#bodies.velocities, number * SIZE + 3);
    return [vector(this.#from, 3), after].every((spin) => {
      const turn = normal ? Math.abs(dot(spin, normal)) : length(spin);
      return turn < TREMBLING;
    });
  }

  /** Whether nothing else is to happen to it. */
  #isPushed(body: Body): boolean {
    const flies = this.#effects.caused(flight);
    return body.dampedShare.linear === 0 && flies !== undefined && flies.isPushed(body);
  }

  /** What its author and gravity do to it in the step; undefined: nobody knows. */
  #pullOf(body: Body, number: number): StepWay | undefined {
    const { time, partOfStep } = this.#simulation;
    const pull = scale(vector(this.#load), 1 / this.#bodies.masses[number]!);
    if (this.#effects.caused(flight)!.glides(body)) return steadily(pull);
    return this.pulls.of(body, pull, time, partOfStep);
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

  /** Whether all that friction can give would take the load beyond what it stands on: then it turns about an edge. */
  #mayTip({ contacts }: Part, normal: Vec3, friction: number): boolean {
    const { values: c, a } = this.#contacts;
    const rubbed = contacts.reduce<Vec3>((sum, i) => add(sum, this.#rubAt(i)), [0, 0, 0]);
    if (length(rubbed) === 0) return false;
    const direction = normalize(rubbed);
    const arms = contacts.map((i) => vector(c, i * C.size + (a[i]! < 0 ? C.armB : C.armA)));
    const reaches = arms.map((arm) => dot(arm, direction));
    const height = -dot(arms[0]!, normal);
    return friction * height > Math.min(Math.max(...reaches), -Math.min(...reaches));
  }

  /** Its friction, N s. */
  #rubAt(i: number): Vec3 {
    const { values: c } = this.#contacts;
    const at = i * C.size;
    return add(
      scale(vector(c, at + C.direction1), c[at + C.impulse + 1]!),
      scale(vector(c, at + C.direction2), c[at + C.impulse + 2]!),
    );
  }

  /** The mean of its contacts. */
  #frictionOf({ contacts }: Part): number {
    const { values } = this.#contacts;
    return contacts.reduce((sum, i) => sum + values[i * C.size + C.friction]!, 0) / contacts.length;
  }
}

const vector = (v: Float64Array, at = 0): Vec3 => [v[at]!, v[at + 1]!, v[at + 2]!];
