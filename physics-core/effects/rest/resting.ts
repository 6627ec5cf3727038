import { dot4 } from '../../base/flat-math.js';
import { doublesOf, pack } from '../../base/packed.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { Effect, type Cause, type EffectDescriptor, type Numbered } from '../effect/effect.js';

/**
 * When nobody wrote autoDisable: below these for this long, and not drifting meanwhile, an island may sleep unseen.
 * The drift bound keeps a slow slide awake, which the speeds alone would freeze.
 */
export const LIBRARY = { time: 2, linearSpeed: 0.01, angularSpeed: 0.01, drift: 1e-4 };

/**
 * Where a heap is so large that its contacts are gone over one at a time all creep a little, and single bodies slip for long.
 * There this is no drift, and this share may have moved farther within the time, as long as they are slow again.
 */
const HEAP = { drift: 5e-4, slipped: 0.01 };

/** Islands are looked at this often, seconds of simulated time. */
const LOOK = 0.25;

const limitsOf = ({ rest }: Body) => (rest.mode === 'library' ? LIBRARY : rest);

/** How bodies rest, for a snapshot. */
interface RestState {
  sinceLook: number;
  /** Those that are slow; of each since when, seconds, and the pose it was slow at, packed. */
  quiet: number[];
  times: string;
  /** What fell asleep together. */
  islands: number[][];
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
  heaps: ReadonlySet<number> = NONE;
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

  override reset(): void {
    this.sinceLook = 0;
    this.heaps = NONE;
    this.#islands.length = 0;
    this.#quiet.fill(0);
  }

  /** What sleeps says only with whom it fell asleep. */
  override save(): RestState {
    const quiet: number[] = [];
    const times: number[] = [];
    const islands = new Set<readonly Body[]>();
    for (const { id, slot, sleeping } of this.#simulation.bodies) {
      const island = this.#islands[slot];
      if (island) islands.add(island);
      if (sleeping || !(this.#quiet[slot]! > 0)) continue;
      quiet.push(id);
      times.push(this.#quiet[slot]!, ...this.#anchor.subarray(slot * POSE, (slot + 1) * POSE));
    }
    return {
      sinceLook: this.sinceLook,
      quiet,
      times: pack(Float64Array.from(times)),
      islands: [...islands].map((island) => island.map(({ id }) => id)),
    };
  }

  override load({ sinceLook, quiet, times, islands }: RestState, nodes: Numbered): void {
    this.sinceLook = sinceLook;
    const numbers = doublesOf(times);
    quiet.forEach((id, i) => {
      const slot = nodes.body(id)?.slot ?? -1;
      if (slot < 0) return;
      if (slot >= this.#quiet.length) this.#grow(slot);
      const at = i * (POSE + 1);
      this.#quiet[slot] = numbers[at]!;
      this.#anchor.set(numbers.subarray(at + 1, at + 1 + POSE), slot * POSE);
    });
    for (const ids of islands) {
      const island = ids.map((id) => nodes.body(id)).filter((body) => body !== undefined);
      for (const { slot, sleeping } of island) if (sleeping) this.#islands[slot] = island;
    }
  }

  restart(slot: number): void {
    this.leaveIsland(slot);
    if (slot < this.#quiet.length) this.#quiet[slot] = 0;
  }

  leaveIsland(slot: number): void {
    this.#islands[slot] = undefined;
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
      const number = reader.island(body.pointer);
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

const NONE: ReadonlySet<number> = new Set();

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
