import {
  add,
  conjugate,
  cross,
  length,
  multiply,
  rotate,
  scale,
  subtract,
} from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { turnOf, type Carried } from './carried.js';

/** Numbers of a velocity: linear, then angular. */
const VELOCITY = 6;

/** What moves no faster than that against what carries it goes along with it, m/s: a contact solver leaves as much. */
export const ALONG = 0.02;

/** What stands on carried bodies, or on what stands there, and goes along with them in a step. */
export class Riders {
  readonly #simulation: Simulation;
  /** Bodies that touch in the step, two pointers each. */
  readonly #pairs: number[] = [];
  readonly #on = new Map<Body, Carried>();
  readonly #velocity = new Float64Array(VELOCITY);
  readonly #pose = new Float64Array(POSE);

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  begin(): void {
    this.#pairs.length = 0;
    this.#on.clear();
  }

  note(a: number, b: number): void {
    const last = this.#pairs.length - 1;
    // The points of a pair come one after the other.
    if (last > 0 && this.#pairs[last - 1] === a && this.#pairs[last] === b) return;
    this.#pairs.push(a, b);
  }

  has(body: Body): boolean {
    return this.#on.has(body);
  }

  /** Bullet has moved them: what goes along is taken on the round way of what carries it. */
  take(all: ReadonlyMap<Body, Carried>, dt: number): void {
    const pairs = this.#pairs;
    for (let found = true; found;) {
      found = false;
      for (let i = 0; i < pairs.length; i += 2) {
        const [a, b] = [this.#bodyAt(i), this.#bodyAt(i + 1)];
        if (!a || !b) continue;
        found = this.#goesOn(a, b, all, dt) || this.#goesOn(b, a, all, dt) || found;
      }
    }
  }

  #bodyAt(i: number): Body | undefined {
    return this.#simulation.bodyAt(this.#pairs[i]!);
  }

  /** Whether a body is found to ride on another. */
  #goesOn(body: Body, on: Body, all: ReadonlyMap<Body, Carried>, dt: number): boolean {
    const carried = all.get(on) ?? this.#on.get(on);
    if (!carried || carried.jumped || !body.isDynamic || this.#on.has(body)) return false;
    return this.#goesAlong(body, carried, dt);
  }

  #goesAlong(body: Body, carried: Carried, dt: number): boolean {
    const { reader } = this.#simulation.engine;
    const { now, next } = carried;
    reader.velocity(body.body, body.pointer, this.#velocity, 0);
    reader.pose(body.body, body.pointer, this.#pose, 0);
    const v: Vec3 = [this.#velocity[0]!, this.#velocity[1]!, this.#velocity[2]!];
    const end: Vec3 = [this.#pose[0]!, this.#pose[1]!, this.#pose[2]!];
    // Where it was when the step began, from what carries it.
    const from = subtract(subtract(end, scale(v, dt)), now.p);
    const turn = turnOf(now, next);
    const straight = add(subtract(next.p, now.p), cross(turn, from));
    if (length(subtract(scale(v, dt), straight)) > ALONG * dt) return false;
    this.#on.set(body, carried);
    const to = add(
      subtract(next.p, now.p),
      subtract(rotate(multiply(next.q, conjugate(now.q)), from), from),
    );
    const [x, y, z] = subtract(to, straight);
    if (x !== 0 || y !== 0 || z !== 0) reader.shift(body.body, body.pointer, x, y, z);
    return true;
  }
}
