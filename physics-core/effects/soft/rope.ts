import { exp } from '../../base/exact/index.js';
import { doublesOf, pack } from '../../base/packed.js';
import { Coils } from '../../solver/ropes/coils.js';
import { FREE, HELD, Strand } from '../../solver/ropes/strand.js';
import type { Vec3 } from '../../fields/types.js';
import type { SoftDrag, SoftGrip } from '../drag/soft-drag.js';
import { nearestOnLine } from '../drag/soft-places.js';
import type { Matter, Points, WetLine } from '../water/matter.js';
import type { Swimmer } from '../water/swimmer.js';
import { LIBRARY } from '../rest/resting.js';
import { Bending } from './bending.js';
import type { RopeSettings, RopeSource } from './settings.js';

const NOTHING = new Float64Array(0);

/** One as another thread is told of it, by the number of its node. */
export interface ToldRope {
  readonly id: number;
  readonly places: Float64Array;
}

/** For a snapshot. */
export interface KeptRope {
  /** Seconds of its last step, seconds that it was slow for, and whether it rests. */
  last: number;
  quiet: number;
  asleep: boolean;
  /** Places, velocities, pulls, and of what it touches and is tied to. */
  state: string;
  /** What it meets of itself. */
  coils?: string;
}

/** A rope as the world has it. */
export class Rope implements Matter, WetLine {
  readonly source: RopeSource;
  strand = new Strand(2);
  settings: RopeSettings;
  /** What was said of it since it was read. */
  stale = false;
  #last = 0;
  #quiet = 0;
  asleep = false;
  /** Of each point, and of each spot between points, the slot of the body that it may touch in this step; -1: none. */
  touched = new Int32Array(2);
  touchedBetween = new Int32Array(2);
  /** Points that come out of a body they are tied within, by its slot: they do not touch it. Which one is tied, and for how far. */
  readonly within: { slot: number; index: number; most: number; first: number; last: number }[] =
    [];
  /** Another number whenever its points are elsewhere. */
  version = 0;
  #bending = new Bending(this.strand);
  /** What hands hold in this step, and what it weighs without. */
  readonly #held = new Map<number, number>();
  /** What water does to it in this step; undefined: none is near. */
  water: Swimmer<WetLine> | undefined;
  /** As water pushes them. */
  points!: Points;
  /** It has the masses of its points, or those with the water that they have to move. */
  #heavier = false;

  constructor(source: RopeSource) {
    this.source = source;
    this.settings = source.settings;
    this.reset();
  }

  get places(): Float64Array {
    return this.strand.places;
  }

  /** As it was laid. */
  reset(): void {
    this.settings = this.source.settings;
    this.#lay();
  }

  #lay(): void {
    const { points, mass, softness } = this.settings;
    this.strand = new Strand(Math.max(2, points.length / 3));
    this.strand.lay(points, mass);
    this.#coil();
    this.strand.softness.fill(softness);
    this.touched = new Int32Array(this.strand.points).fill(-1);
    this.touchedBetween = new Int32Array(this.strand.between.count).fill(-1);
    this.#bending = new Bending(this.strand);
    const { masses, places, free: velocities } = this.strand;
    this.points = {
      count: this.strand.points,
      masses: masses.slice(),
      inverse: masses.map((each) => 1 / each),
      places,
      velocities,
    };
    this.#heavier = false;
    this.#last = this.#quiet = 0;
    this.asleep = false;
    this.version++;
  }

  get id(): number {
    return this.source.id;
  }

  get lengths(): Float64Array {
    return this.strand.lengths;
  }

  get radius(): number {
    return this.settings.radius;
  }

  emit(event: string, detail: unknown): void {
    this.source.emit(event, detail);
  }

  /** Its author says something else. */
  read(): void {
    const before = this.settings;
    this.settings = this.source.settings;
    this.stale = false;
    this.wake();
    const { mass, softness } = this.settings;
    this.#coil();
    if (mass !== before.mass) this.#weigh(mass / before.mass);
    this.strand.softness.fill(softness);
  }

  /** It meets itself, or no more. */
  #coil(): void {
    const { selfCollision, radius } = this.settings;
    const { strand } = this;
    if (!selfCollision || !(radius > 0)) strand.coils = undefined;
    else strand.coils ??= new Coils(strand);
  }

  #weigh(share: number): void {
    if (this.#heavier) this.#lighten();
    const { masses, inverse } = this.points;
    for (let i = 0; i < masses.length; i++) {
      this.strand.masses[i]! *= share;
      masses[i] = this.strand.masses[i]!;
      inverse[i] = 1 / masses[i]!;
    }
  }

  wake(): void {
    this.asleep = false;
    this.#quiet = 0;
  }

  /** A point is put elsewhere: what hangs on it comes along as far as it has to, without any speed of that. */
  jump(index: number, place: readonly number[]): void {
    const { places, holders, points } = this.strand;
    places.set(place, 3 * index);
    for (const way of [1, -1])
      for (let i = index + way; i >= 0 && i < points && holders[i] === FREE; i += way)
        this.#pull(i, i - way, Math.min(i, i - way));
    this.version++;
  }

  /** Point `i` comes as near to point `to` as link `link` is long. */
  #pull(i: number, to: number, link: number): void {
    const { places, lengths } = this.strand;
    let square = 0;
    for (let k = 0; k < 3; k++) square += (places[3 * i + k]! - places[3 * to + k]!) ** 2;
    const share = lengths[link]! / Math.sqrt(square);
    if (!(share < 1)) return;
    for (let k = 0; k < 3; k++) {
      const from = places[3 * to + k]!;
      places[3 * i + k] = from + share * (places[3 * i + k]! - from);
    }
  }

  /** Whether a ball may touch it. */
  isNear(centre: Vec3, reach: number): boolean {
    const { places } = this.strand;
    const near = 2 * this.settings.radius + reach;
    for (let axis = 0; axis < 3; axis++) {
      let least = Infinity;
      let most = -Infinity;
      for (let j = axis; j < places.length; j += 3) {
        least = Math.min(least, places[j]!);
        most = Math.max(most, places[j]!);
      }
      if (centre[axis]! < least - near || centre[axis]! > most + near) return false;
    }
    return true;
  }

  get quiet(): boolean {
    return this.#quiet >= LIBRARY.time;
  }

  /** What it would do in a step if nothing pulled. Velocities belong to the middle of each step: the first is half a one. */
  begin(dt: number): void {
    const { gravity, damping } = this.settings;
    const { strand } = this;
    const time = (this.#last + dt) / 2;
    const left = damping > 0 ? exp(-damping * time) : 1;
    if (this.#heavier) this.#lighten();
    strand.begin(dt);
    for (let j = 0; j < strand.free.length; j++) strand.free[j] = strand.velocities[j]! * left;
    this.water?.begin();
    for (let j = 0; j < strand.free.length; j += 3)
      for (let k = 0; k < 3; k++) strand.free[j + k]! += time * gravity[k]!;
    if (this.settings.bending > 0) this.#bend(dt, time);
    if (this.water) this.#swim(this.water, time);
  }

  #lighten(): void {
    this.strand.masses.set(this.points.masses);
    this.#heavier = false;
  }

  /** For what pulls it its points are as much heavier as water brakes them. */
  #swim(water: Swimmer<WetLine>, time: number): void {
    water.soak(time);
    const { inverse, masses, count } = this.points;
    for (let i = 0; i < count; i++)
      if (inverse[i]! < 1 / masses[i]!) this.strand.masses[i] = 1 / inverse[i]!;
    this.#heavier = true;
    water.dry();
  }

  #bend(dt: number, time: number): void {
    const { bending } = this.settings;
    const most = this.#bending.most(dt);
    this.source.bends(most);
    this.#bending.push(Math.min(bending, most), time);
  }

  // ---- by hand --------------------------------------------------------------------------------------------------------

  /** The place of it that is nearest to a point. */
  gripAt(point: Vec3): SoftGrip | undefined {
    const { places, holders } = this.strand;
    const place = nearestOnLine(places, point, (i) => holders[i] !== HELD);
    return place && { ...place, seen: place };
  }

  /** Hands act in a step that begins: to its end what they hold weighs more. */
  take(drags: Iterable<SoftDrag>, dt: number): void {
    const { masses, free, places, holders } = this.strand;
    for (const drag of drags)
      drag.act(places, dt, 0, (i, weight, push) => {
        if (holders[i] === HELD) return;
        const mass = masses[i]!;
        if (!this.#held.has(i)) this.#held.set(i, mass);
        for (let k = 0; k < 3; k++)
          free[3 * i + k] = (mass * free[3 * i + k]! + push[k]!) / (mass + weight);
        masses[i] = mass + weight;
      });
  }

  letGo(): void {
    for (const [i, mass] of this.#held) this.strand.masses[i] = mass;
    this.#held.clear();
  }

  // ---- a step ---------------------------------------------------------------------------------------------------------

  /** It goes where it was found to go. */
  move(dt: number): void {
    const { strand } = this;
    this.letGo();
    const { holders, arms, armsBefore, velocities, points } = strand;
    strand.move(dt);
    for (let i = 0; i < points; i++)
      if (holders[i]! > HELD) for (let k = 3 * i; k < 3 * i + 3; k++) armsBefore[k] = arms[k]!;
    let most = 0;
    for (const v of velocities) most = Math.max(most, Math.abs(v));
    this.#quiet = most < LIBRARY.linearSpeed && this.settings.rests ? this.#quiet + dt : 0;
    this.#last = dt;
    this.version++;
  }

  /** Numbers that are none: it stands where it is. */
  stop(): void {
    const { velocities, pulls, knots, between, found } = this.strand;
    const pushes = [knots.presses, knots.rubs, between.presses, between.rubs];
    for (const all of [velocities, pulls, found, ...pushes]) all.fill(0);
    this.strand.coils?.clear();
    this.#last = 0;
  }

  /** Nobody holds it but its author, at points that stay where they are. */
  hold(): void {
    const { holders, points } = this.strand;
    holders.fill(FREE);
    for (const i of this.settings.fixed) if (i < points) holders[i] = HELD;
  }

  /** Those points go nowhere in the step that begins. */
  stand(): void {
    const { found, points } = this.strand;
    for (const i of this.settings.fixed) if (i < points) found.fill(0, 3 * i, 3 * i + 3);
    this.within.length = 0;
  }

  // ---- on another thread ----------------------------------------------------------------------------------------------

  /** Its steps are taken there; what that side told. */
  hear({ places }: ToldRope): void {
    const own = this.strand.places;
    if (places.length !== own.length) return;
    own.set(places);
    this.version++;
    this.source.stepped();
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  get #lasting(): Float64Array[] {
    const { places, velocities, pulls, knots, between, armsBefore } = this.strand;
    const held = [knots.presses, knots.rubs, armsBefore, between.presses, between.rubs];
    return [places, velocities, pulls, ...held];
  }

  save(): KeptRope {
    const coils = this.strand.coils?.save();
    return {
      ...(coils && { coils: pack(coils) }),
      last: this.#last,
      quiet: this.#quiet,
      asleep: this.asleep,
      state: pack(Float64Array.from(this.#lasting.flatMap((part) => [...part]))),
    };
  }

  load({ last, quiet, asleep, state, coils }: KeptRope): void {
    const kept = doublesOf(state);
    let at = 0;
    for (const part of this.#lasting) {
      if (at + part.length > kept.length) return;
      part.set(kept.subarray(at, at + part.length));
      at += part.length;
    }
    this.strand.knots.restore();
    this.strand.between.restore();
    this.strand.coils?.load(coils ? doublesOf(coils) : NOTHING);
    this.#last = last;
    this.#quiet = quiet;
    this.asleep = asleep;
    this.version++;
  }
}
