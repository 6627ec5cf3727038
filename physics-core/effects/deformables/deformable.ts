import { exp } from '../../base/exact/index.js';
import { pack, bytesOf } from '../../base/packed.js';
import type { Vec3 } from '../../fields/types.js';
import type { SoftDrag, SoftGrip } from '../drag/soft-drag.js';
import { nearestOnSurface } from '../drag/soft-places.js';
import type { Masses } from '../../solver/deformables/masses.js';
import type { Surface } from '../../solver/deformables/surface.js';
import { blow } from '../../solver/deformables/air.js';
import type { Material } from '../../solver/deformables/material.js';
import { MOST_SOFT_PARTS } from '../../solver/tolerances.js';
import type { Matter, WetSurface } from '../water/matter.js';
import type { Swimmer } from '../water/swimmer.js';
import { LIBRARY } from '../rest/resting.js';
import { samplesOf, type Samples } from './samples.js';
import type { DeformableSettings, DeformableSource } from './settings.js';
import { SETTLING, STRAINED, TAUT, WHIPS } from './tolerances.js';
import { Touches } from './touches.js';

/** One as another thread is told of it, by the number of its node. */
export interface ToldDeformable {
  readonly id: number;
  readonly places: Float64Array;
}

/** For a snapshot. */
export interface KeptDeformable {
  /** Seconds of its last part, seconds that it was slow for, and whether it rests. */
  last: number;
  quiet: number;
  strain: number;
  softness: number;
  asleep: boolean;
  /** Places and velocities, and what its material keeps. */
  state: string[];
}

/** A cloth or a soft body as the world has it. */
export class Deformable implements Matter, WetSurface {
  readonly source: DeformableSource;
  material: Material;
  settings: DeformableSettings;
  readonly touches = new Touches();
  /** Where it is looked at beside its points. */
  samples: Samples;
  /** Points of its surface that are tied within a body do not touch that: its slot. */
  readonly within = new Map<number, number>();
  /** What was said of it since it was read. */
  stale = false;
  asleep = false;
  /** It takes part in this step. */
  moves = false;
  /** What water does to it in this step; undefined: none is near. */
  water: Swimmer<WetSurface> | undefined;
  #last = 0;
  #quiet = 0;
  /** How far it was stretched lately, as a share. */
  #strain = 0;
  /** Which share of its stiffness it had lately. */
  #softness = 1;
  /** Another number whenever its points are elsewhere. */
  version = 0;
  /** Of the points of its surface, m/s. */
  velocities: Float64Array;
  #before: Float64Array;
  /** What hands hold in this part of a step, and how it gives way without. */
  readonly #held = new Map<number, number>();
  /** Where what has mass was when the step began. */
  #good: Float64Array;

  constructor(source: DeformableSource) {
    this.source = source;
    this.settings = source.settings;
    this.material = source.lay();
    this.samples = this.#sampled();
    this.#good = this.material.masses.places.slice();
    this.velocities = new Float64Array(3 * this.material.surface.shown);
    this.#before = this.places.slice();
  }

  #sampled(): Samples {
    return samplesOf(this.places, this.triangles, 2 * this.settings.radius);
  }

  /** Of the points that its author gave it. */
  get places(): Float64Array {
    const { places, shown, count } = this.material.surface;
    return shown === count ? places : places.subarray(0, 3 * shown);
  }

  get triangles(): Int32Array {
    return this.material.surface.triangles;
  }

  get id(): number {
    return this.source.id;
  }

  get masses(): Masses {
    return this.material.masses;
  }

  get hull(): Surface {
    return this.material.hull;
  }

  get side(): number {
    return this.material.side;
  }

  get solid(): number | undefined {
    return this.material.solid;
  }

  get thickness(): number {
    return this.material.thickness ?? 2 * this.settings.radius;
  }

  emit(event: string, detail: unknown): void {
    this.source.emit(event, detail);
  }

  /** As it was laid. */
  reset(): void {
    this.settings = this.source.settings;
    this.material = this.source.lay();
    this.samples = this.#sampled();
    this.#good = this.material.masses.places.slice();
    this.velocities = new Float64Array(3 * this.material.surface.shown);
    this.#before = this.places.slice();
    this.#last = this.#quiet = this.#strain = 0;
    this.#softness = 1;
    this.asleep = false;
    this.version++;
  }

  /** Its author says something else. */
  read(): void {
    const { radius } = this.settings;
    this.settings = this.source.settings;
    if (radius !== this.settings.radius) this.samples = this.#sampled();
    if (!this.source.read(this.material)) this.reset();
    this.stale = false;
    this.wake();
  }

  wake(): void {
    this.asleep = false;
    this.#quiet = 0;
  }

  get quiet(): boolean {
    return this.#quiet >= LIBRARY.time;
  }

  /** Points that its author holds go nowhere; all others by what they weigh. */
  hold(): void {
    const { masses, surface } = this.material;
    masses.free();
    for (const i of this.settings.fixed) if (i < surface.shown) this.fix(i);
  }

  /** Whatever carries a point of its surface stays where it is. */
  fix(i: number): void {
    const { masses, surface } = this.material;
    for (let n = surface.width * i; n < surface.width * (i + 1); n++) {
      const carrier = surface.carriers[n]!;
      if (surface.shares[n] === 0) continue;
      masses.inverse[carrier] = 0;
      masses.velocities.fill(0, 3 * carrier, 3 * carrier + 3);
    }
  }

  // ---- by hand --------------------------------------------------------------------------------------------------------

  /** Whether a point of its surface goes anywhere. */
  readonly #isFree = (i: number): boolean => {
    const { surface, masses } = this.material;
    const { width, carriers, shares } = surface;
    for (let n = width * i; n < width * (i + 1); n++)
      if (shares[n] !== 0 && masses.inverse[carriers[n]!]! > 0) return true;
    return false;
  };

  /** What carries the place of its surface that is nearest to a point, by as much as it does. */
  gripAt(point: Vec3): SoftGrip | undefined {
    const { masses, surface } = this.material;
    const { width, carriers, shares } = surface;
    const place = nearestOnSurface(this.places, this.triangles, point, this.#isFree);
    if (!place) return undefined;
    const held = new Map<number, number>();
    let all = 0;
    place.points.forEach((i, m) => {
      for (let n = width * i; n < width * (i + 1); n++) {
        const share = Math.abs(place.shares[m]! * shares[n]!);
        if (share === 0 || masses.inverse[carriers[n]!] === 0) continue;
        held.set(carriers[n]!, (held.get(carriers[n]!) ?? 0) + share);
        all += share;
      }
    });
    return {
      points: [...held.keys()],
      shares: [...held.values()].map((share) => share / all),
      seen: place,
    };
  }

  /** Hands act in a part of a step: until `letGo` what they hold weighs more. */
  take(drags: Iterable<SoftDrag>, time: number, left: number): void {
    const { places, before, inverse } = this.material.masses;
    for (const drag of drags)
      drag.act(before, time, left, (i, weight, push) => {
        if (inverse[i] === 0) return;
        if (!this.#held.has(i)) this.#held.set(i, inverse[i]!);
        const mass = 1 / inverse[i]!;
        for (let k = 0; k < 3; k++) {
          const went = places[3 * i + k]! - before[3 * i + k]!;
          places[3 * i + k] =
            before[3 * i + k]! + (mass * went + time * push[k]!) / (mass + weight);
        }
        inverse[i] = 1 / (mass + weight);
      });
  }

  letGo(): void {
    for (const [i, inverse] of this.#held) this.material.masses.inverse[i] = inverse;
    this.#held.clear();
  }

  // ---- a step ---------------------------------------------------------------------------------------------------------

  /** In how many parts it wants a step of `dt` seconds to be taken. */
  parts(dt: number): number {
    const parts = Math.min(MOST_SOFT_PARTS, this.material.parts(dt));
    const share = Math.min(1, dt / WHIPS);
    this.#softness += share * (this.material.soften(parts, dt) - this.#softness);
    this.source.softened(this.#softness);
    return parts;
  }

  /** Threads go to their lengths, however far that is; what was stretched by more than a motion can leaves no speed. */
  settle(): void {
    const { material } = this;
    for (let round = 0; round < SETTLING; round++) {
      material.hold(Infinity, round > 0);
      if (material.strain <= TAUT) break;
      material.masses.velocities.fill(0);
    }
    this.hold();
    material.surface.follow(material.masses);
  }

  begin(): void {
    this.#before.set(this.places);
    this.#good.set(this.material.masses.places);
  }

  /** A part of a step by itself: it falls, gives way, and goes as fast as it is. Velocities belong to the middle of each part. */
  fall(time: number): void {
    const { masses } = this.material;
    const { velocities, places, before, inverse, count } = masses;
    const { gravity, damping, wind } = this.settings;
    const pushed = (this.#last + time) / 2;
    this.water?.begin();
    const left = damping > 0 ? exp(-damping * pushed) : 1;
    if (left < 1) for (let j = 0; j < velocities.length; j++) velocities[j]! *= left;
    this.material.push(pushed);
    if (wind) blow(this.material, wind, pushed);
    for (let i = 0; i < count; i++)
      if (inverse[i]! > 0)
        for (let k = 0; k < 3; k++) velocities[3 * i + k]! += pushed * gravity[k]!;
    this.water?.soak(pushed);
    for (let j = 0; j < places.length; j++) {
      before[j] = places[j]!;
      places[j]! += time * velocities[j]!;
    }
    this.#last = time;
  }

  /** How far each went is how fast it was. */
  go(time: number): void {
    const { velocities, places, before } = this.material.masses;
    for (let j = 0; j < places.length; j++) velocities[j] = (places[j]! - before[j]!) / time;
    this.water?.dry();
  }

  /** The step is over. False: its numbers are none. */
  end(dt: number): boolean {
    const { material, settings, velocities } = this;
    const { places } = material.surface;
    material.surface.follow(material.masses);
    let most = 0;
    for (let j = 0; j < velocities.length; j++) {
      const v = (velocities[j] = (places[j]! - this.#before[j]!) / dt);
      most = Math.max(most, Math.abs(v));
    }
    this.version++;
    if (!Number.isFinite(most) || !areFinite(material.masses.places)) return false;
    this.#quiet = most < LIBRARY.linearSpeed && settings.rests ? this.#quiet + dt : 0;
    // What only whips is not told.
    const share = Math.min(1, dt / WHIPS);
    this.#strain += share * ((material.stretched ?? 0) - this.#strain);
    if (this.#strain > STRAINED) this.source.strained(this.#strain);
    else if (this.#strain < STRAINED / 2) this.source.strained(0);
    return true;
  }

  /** Numbers that are none: it stands where it was when the step began. */
  stop(): void {
    const { masses, surface } = this.material;
    masses.places.set(this.#good);
    masses.velocities.fill(0);
    this.velocities.fill(0);
    surface.follow(masses);
    this.#last = 0;
    this.source.stopped();
  }

  /** Whether a ball may touch it. */
  isNear(centre: Vec3, reach: number): boolean {
    const { places } = this;
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

  // ---- on another thread ----------------------------------------------------------------------------------------------

  /** Its steps are taken there; what that side told. */
  hear({ places }: ToldDeformable): void {
    const own = this.places;
    if (places.length !== own.length) return;
    own.set(places);
    this.version++;
    this.source.stepped();
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  get #lasting(): readonly (Float64Array | Int32Array | Uint8Array)[] {
    const { places, velocities } = this.material.masses;
    return [places, velocities, this.velocities, ...this.material.lasting];
  }

  save(): KeptDeformable {
    return {
      last: this.#last,
      quiet: this.#quiet,
      strain: this.#strain,
      softness: this.#softness,
      asleep: this.asleep,
      state: this.#lasting.map((part) => pack(part)),
    };
  }

  load({ last, quiet, strain, softness, asleep, state }: KeptDeformable): void {
    this.#lasting.forEach((part, n) => {
      const bytes = bytesOf(state[n] ?? '');
      const own = new Uint8Array(part.buffer, part.byteOffset, part.byteLength);
      if (bytes.length >= own.length) own.set(bytes.subarray(0, own.length));
    });
    this.material.restored?.();
    this.material.surface.follow(this.material.masses);
    this.#last = last;
    this.#quiet = quiet;
    this.#strain = strain;
    this.#softness = softness;
    this.asleep = asleep;
    this.version++;
  }
}

function areFinite(numbers: Float64Array): boolean {
  let sum = 0;
  for (const each of numbers) sum += each;
  return Number.isFinite(sum);
}
