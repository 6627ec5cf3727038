import { dot4 } from '../../base/flat-math.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { Effect, type Cause, type EffectDescriptor } from '../effect/effect.js';

/**
 * When nobody wrote autoDisable: below these for this long, and not drifting meanwhile, an island may sleep unseen.
 * The drift bound keeps a slow slide awake, which the speeds alone would freeze.
 */
const LIBRARY = { time: 2, linearSpeed: 0.01, angularSpeed: 0.01, drift: 1e-4 };

/**
 * Where a heap is so large that its contacts are gone over one at a time all creep a little, and single bodies slip for long.
 * There this is no drift, and this share may have moved farther within the time, as long as they are slow again.
 */
const HEAP = { drift: 5e-4, slipped: 0.01 };

/** Islands are looked at this often, seconds of simulated time. */
const LOOK = 0.25;

const limitsOf = ({ rest }: Body) => (rest.mode === 'library' ? LIBRARY : rest);

/** Seconds a body has been slow, the pose it was slow at, and a number that those have in common that fell asleep together. */
export interface RestState {
  quiet: number;
  anchor: number[];
  island?: number;
}

interface Island {
  bodies: Body[];
  /** Not all of them may sleep. */
  awake: boolean;
  /** How many of them are slow, but were not for long enough. */
  slipped: number;
}

/** Puts islands to sleep whose bodies all ask for it. Bullet itself wakes them when something touches them. */
export class Resting extends Effect {
  readonly #simulation: Simulation;
  /** Seconds each body was slow, and the pose it was slow at, by slot. */
  #quiet = new Float64Array(16);
  #anchor = new Float64Array(16 * POSE);
  /** Square of the speed below which each body that asks for it may rest, m²/s²; -1: it does not ask. */
  #limits = new Float64Array(16).fill(-1);
  /** What each body fell asleep together with, by slot, until it wakes or is put to sleep by anybody else. */
  readonly #islands: (readonly Body[] | undefined)[] = [];
  /** Pointers of bodies in large heaps that are gone over by sweeps. */
  heaps: ReadonlySet<number> = new Set();
  /** Slots of those that were restored asleep, and sleep on: Bullet has not looked at what they lie on. */
  readonly #restored = new Set<number>();
  /** Islands of the snapshot that is restored, by their number in it. */
  readonly #loading = new Map<number, Body[]>();
  /** Seconds since islands were looked at. */
  sinceLook = 0;

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  /** Its rule of rest may be another. */
  override need(body: Body, reason: string): void {
    this.leaveIsland(body.slot);
    if (body.slot >= this.#quiet.length) this.#grow(body.slot);
    this.#limits[body.slot] = limitsOf(body).linearSpeed ** 2;
    super.need(body, reason);
  }

  override release(node: Cause): void {
    const { slot } = node as Body;
    this.leaveIsland(slot);
    if (this.isNeededBy(node)) this.#limits[slot] = -1;
    super.release(node);
  }

  #grow(slot: number): void {
    const room = 2 ** Math.ceil(Math.log2(slot + 1));
    const quiet = new Float64Array(room);
    quiet.set(this.#quiet);
    const anchor = new Float64Array(room * POSE);
    anchor.set(this.#anchor);
    this.#quiet = quiet;
    this.#anchor = anchor;
    const limits = new Float64Array(room).fill(-1);
    limits.set(this.#limits);
    this.#limits = limits;
  }

  /** How a body rests, for a snapshot. */
  save(slot: number): RestState {
    const anchor = [...this.#anchor.subarray(slot * POSE, (slot + 1) * POSE)];
    const island = this.#islands[slot]?.[0]?.slot;
    return { quiet: this.#quiet[slot] ?? 0, anchor, ...(island !== undefined && { island }) };
  }

  /** A snapshot is restored: who rested together does so no more. */
  beginLoad(sinceLook: number): void {
    this.sinceLook = sinceLook;
    this.#islands.length = 0;
    this.#restored.clear();
    this.#loading.clear();
  }

  load(body: Body, { quiet, anchor, island }: RestState): void {
    const { slot } = body;
    if (slot >= this.#quiet.length) this.#grow(slot);
    this.#quiet[slot] = quiet;
    this.#anchor.set(anchor.slice(0, POSE), slot * POSE);
    if (!body.sleeping) return;
    this.#restored.add(slot);
    if (island === undefined) return;
    const bodies = this.#loading.get(island) ?? [];
    this.#loading.set(island, bodies);
    bodies.push(body);
    this.#islands[slot] = bodies;
  }

  /** Visits those that were restored asleep, and sleep on. */
  eachRestored(visit: (body: Body) => void): void {
    for (const slot of [...this.#restored]) {
      const body = this.#simulation.bodies.in(slot);
      if (body) visit(body);
    }
  }

  restart(slot: number): void {
    this.leaveIsland(slot);
    if (slot < this.#quiet.length) this.#quiet[slot] = 0;
  }

  leaveIsland(slot: number): void {
    this.#islands[slot] = undefined;
    this.#restored.delete(slot);
  }

  /** What a sleeping body fell asleep with: nothing has touched it since. Undefined: that is not known. */
  islandOf(slot: number): readonly Body[] | undefined {
    return this.#islands[slot];
  }

  override afterStep(dt: number): void {
    const { bodies } = this.#simulation;
    const { slots, pointers, asleep, velocities } = bodies.moving;
    const limits = this.#limits;
    const quiet = this.#quiet;
    let ready = false;
    for (let slot = 0; slot < slots; slot++) {
      const limit = limits[slot]!;
      if (pointers[slot] === 0 || !(limit >= 0)) continue;
      const at = slot * VELOCITY;
      const x = velocities[at]!;
      const y = velocities[at + 1]!;
      const z = velocities[at + 2]!;
      // Most are: none of the rest is asked of them.
      if (x * x + y * y + z * z >= limit) quiet[slot] = 0;
      else if (asleep[slot] === 0) ready = this.#watch(bodies.in(slot)!, dt) || ready;
    }
    this.sinceLook += dt;
    if (!ready || this.sinceLook < LOOK) return;
    this.sinceLook = 0;
    this.#sleepReadyIslands();
  }

  /** Counts how long the body was slow; true when it may sleep. */
  #watch(body: Body, dt: number): boolean {
    const slot = body.slot;
    const library = body.rest.mode === 'library';
    const limit = limitsOf(body);
    const slow = this.#simulation.bodies.slower(slot, limit.linearSpeed, limit.angularSpeed);
    if (!slow || (library && this.#drifted(body))) {
      this.#quiet[slot] = 0;
      return false;
    }
    const before = this.#quiet[slot]!;
    const now = (this.#quiet[slot] = before + dt);
    // What drifts is measured against where it was at most so long ago.
    if (before === 0 || windowsIn(now) > windowsIn(before)) this.#setAnchor(slot);
    return now >= limit.time;
  }

  #setAnchor(slot: number): void {
    const { current } = this.#simulation.poses;
    for (let i = slot * POSE; i < (slot + 1) * POSE; i++) this.#anchor[i] = current[i]!;
  }

  #drifted(body: Body): boolean {
    if (this.#quiet[body.slot] === 0) return false;
    const drift = this.#driftOf(body.slot);
    return drift > LIBRARY.drift && (drift > HEAP.drift || !this.heaps.has(body.pointer));
  }

  /** Since it was slow, metres, or of its quaternion. */
  #driftOf(slot: number): number {
    const { current } = this.#simulation.poses;
    const at = slot * POSE;
    // A quaternion and its opposite are the same orientation; Bullet's goes over where its matrix has no trace, at 120°.
    const sign = dot4(current, at + 3, this.#anchor, at + 3) < 0 ? -1 : 1;
    let drift = 0;
    for (let i = at; i < at + POSE; i++) {
      const now = i < at + 3 ? current[i]! : sign * current[i]!;
      drift = Math.max(drift, Math.abs(now - this.#anchor[i]!));
    }
    return drift;
  }

  #mayRest(body: Body): boolean {
    if (body.rest.mode === 'never') return false;
    const time = body.rest.mode === 'library' ? LIBRARY.time : body.rest.time;
    return this.#quiet[body.slot]! > 0 && this.#quiet[body.slot]! >= time;
  }

  /** Slow again, in a heap where single bodies slip. */
  #slipped(body: Body): boolean {
    return (
      body.rest.mode === 'library' && this.#quiet[body.slot]! > 0 && this.heaps.has(body.pointer)
    );
  }

  #sleepReadyIslands(): void {
    const { reader } = this.#simulation.engine;
    const islands = new Map<number, Island>();
    for (const body of this.#simulation.bodies) {
      if (!body.active || !body.movable) continue;
      const number = reader.island(body.body, body.pointer);
      let island = islands.get(number);
      if (!island) islands.set(number, (island = { bodies: [], awake: number < 0, slipped: 0 }));
      island.bodies.push(body);
      if (body.sleeping || this.#mayRest(body)) continue;
      if (this.#slipped(body)) island.slipped++;
      else island.awake = true;
    }
    for (const { bodies, awake, slipped } of islands.values()) {
      if (awake || slipped > HEAP.slipped * bodies.length) continue;
      if (bodies.some((body) => !body.sleeping)) this.#sleep(bodies);
    }
  }

  /** Those that slept already belong to it, too. */
  #sleep(island: readonly Body[]): void {
    for (const body of island) {
      if (!body.sleeping) body.sleep();
      this.#islands[body.slot] = island;
    }
  }
}

const windowsIn = (seconds: number): number => Math.floor(seconds / LIBRARY.time);

const REASONS = {
  never: undefined,
  library: 'autoDisable not authored',
  authored: 'autoDisable',
};

export const resting: EffectDescriptor<Resting> = {
  name: 'rest',
  causes: 'a body that may sleep: autoDisable TRUE, or written by nobody',
  after: { 'given contacts': 'contacts that page code gives wake bodies' },
  body: {
    on: ['rest'],
    // What the world stands for a collidable never moves.
    reason: ({ rest, isObstacle }) => (isObstacle ? undefined : REASONS[rest.mode]),
  },
  load: (simulation) => new Resting(simulation),
};
