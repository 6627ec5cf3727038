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
import { ALONG, Slips, type Grip, type Ride } from './slips.js';

/** For a snapshot: the ids of both. */
export type KeptRide = [body: number, on: number, ride: Omit<Ride, 'on'>];

/** What stands on carried bodies, or on what stands there, and goes along with them in a step or slips. */
export class Riders {
  readonly #simulation: Simulation;
  /** Bodies that touch in the step, two pointers each. */
  readonly #pairs: number[] = [];
  readonly #grips = new Map<Body, Grip>();
  #rides = new Map<Body, Ride>();
  #before = new Map<Body, Ride>();
  readonly #slips: Slips;
  readonly #pose = new Float64Array(POSE);

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
    this.#slips = new Slips(simulation);
  }

  begin(): void {
    this.#pairs.length = 0;
    this.#grips.clear();
    const rides = this.#before;
    this.#before = this.#rides;
    this.#rides = rides;
    rides.clear();
  }

  reset(): void {
    this.#rides.clear();
    this.#before.clear();
  }

  /** How the last step left them; `idOf`: of what carries them. */
  save(idOf: (on: Carried) => number): KeptRide[] {
    return [...this.#rides].map(([{ id }, { on, ...ride }]) => [
      id,
      idOf(on),
      structuredClone(ride),
    ]);
  }

  load(body: Body, ride: Ride): void {
    this.#rides.set(body, ride);
  }

  forget(body: Body): void {
    this.#rides.delete(body);
    this.#before.delete(body);
  }

  note(a: number, b: number): void {
    const last = this.#pairs.length - 1;
    // The points of a pair come one after the other.
    if (last > 0 && this.#pairs[last - 1] === a && this.#pairs[last] === b) return;
    this.#pairs.push(a, b);
  }

  grip(body: Body, grip: Grip): void {
    this.#grips.set(body, grip);
  }

  has(body: Body): boolean {
    return this.#rides.has(body);
  }

  /** Bullet has moved them: what goes along is taken on the round way of what carries it. */
  take(all: ReadonlyMap<Body, Carried>, dt: number): void {
    this.#slip(all, dt);
    const pairs = this.#pairs;
    for (let found = true; found;) {
      found = false;
      for (let i = 0; i < pairs.length; i += 2) {
        const a = this.#bodyAt(i);
        const b = this.#bodyAt(i + 1);
        if (!a || !b) continue;
        found = this.#goesOn(a, b, all, dt) || this.#goesOn(b, a, all, dt) || found;
      }
    }
  }

  #bodyAt(i: number): Body | undefined {
    return this.#simulation.bodyAt(this.#pairs[i]!);
  }

  #slip(all: ReadonlyMap<Body, Carried>, dt: number): void {
    for (const [body, grip] of this.#grips) {
      const on = all.get(this.#simulation.bodyAt(grip.on)!);
      if (!on || on.jumped) continue;
      const ride = this.#slips.take({ body, on, grip, before: this.#before.get(body), dt });
      if (ride) this.#rides.set(body, ride);
    }
  }

  /** Whether a body is found to ride on another. */
  #goesOn(body: Body, on: Body, all: ReadonlyMap<Body, Carried>, dt: number): boolean {
    const carried = all.get(on) ?? this.#carrierOf(on);
    if (!carried || carried.jumped || !body.isDynamic || this.has(body)) return false;
    return this.#goesAlong(body, carried, dt);
  }

  #carrierOf(body: Body): Carried | undefined {
    const ride = this.#rides.get(body);
    return ride?.sticks ? ride.on : undefined;
  }

  #goesAlong(body: Body, carried: Carried, dt: number): boolean {
    const { reader } = this.#simulation.engine;
    const { now, next } = carried;
    const velocity = this.#slips.velocityOf(body);
    reader.pose(body.pointer, this.#pose, 0);
    const end: Vec3 = [this.#pose[0]!, this.#pose[1]!, this.#pose[2]!];
    // Where it was when the step began, from what carries it.
    const from = subtract(subtract(end, scale(velocity, dt)), now.p);
    const turn = turnOf(now, next);
    const straight = add(subtract(next.p, now.p), cross(turn, from));
    if (length(subtract(scale(velocity, dt), straight)) > ALONG * dt) return false;
    this.#rides.set(body, { on: carried, sticks: true, velocity: scale(straight, 1 / dt) });
    const to = add(
      subtract(next.p, now.p),
      subtract(rotate(multiply(next.q, conjugate(now.q)), from), from),
    );
    const [x, y, z] = subtract(to, straight);
    if (x !== 0 || y !== 0 || z !== 0) reader.shift(body.pointer, x, y, z);
    return true;
  }
}
