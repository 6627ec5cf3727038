import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Water } from '../water/water.js';
import type { Bounces } from './bounces.js';
import { Cloud, PARTICLE, type KeptCloud } from './cloud.js';
import { Draws } from './emit/draws.js';
import { Drift } from './drift.js';
import { BIRTH } from './emit/emitter.js';
import { EmitterPlace } from './emitter-place.js';
import { Pushes } from './pushes.js';
import { Schedule } from './schedule.js';
import type { Settings } from './settings.js';
import { pictureOf, type CloudPicture, type Seen } from './seen.js';
import { GUST, type Wind } from './wind.js';

/** Kinds of random numbers of a particle: what its emitter draws, and how long it lives. Those of winds come after. */
const EMITTED = 0;
const LIVES = -1;

const NO_WINDS: readonly Wind[] = [];

/** How far its births have come. */
export interface Progress {
  time: number;
  burst: boolean;
  creates: boolean;
}

/** Water, where there is some. */
type Sea = Pick<Water, 'soak'>;

/** For a snapshot. */
export interface KeptSystem extends Progress {
  due: number;
  next: number;
  cloud: KeptCloud;
  /** The winds that bodies felt in the last step; undefined: none. */
  felt?: string;
  /** It met bodies in the last step. */
  met?: true;
}

/**
 * The particles of one system: born at their own times, moved exactly between them, gone when their time is over. The n-th
 * particle is the same one at every level: what is random about it goes by its number and the seed.
 */
export class ParticleSystem {
  readonly cloud = new Cloud();
  readonly #settings: () => Settings;
  readonly #place: EmitterPlace;
  readonly #drift = new Drift();
  readonly #rest = new Drift();
  readonly #pushes = new Pushes();
  /** Seconds of the step before. */
  #dtBefore = 0;
  /** What a step does to what lies is what the one before did, but for bodies that move: what that left as it was stays. */
  #calm = false;
  readonly #birth = new Float64Array(BIRTH);
  #said!: Settings;
  #draws = new Draws(0);
  /** Seconds since it was made. */
  #time = 0;
  readonly #schedule = new Schedule();
  /** All that are born at once are. */
  #burst = false;
  #creates = false;
  /** Its author has said something since the last step; what he says now, if somebody asked for it. */
  #stale = true;
  #heard: Settings | undefined;
  /** The winds that bodies feel, in words, and what its author said when that was looked at last. */
  #felt: string | undefined;
  #looked: Settings | undefined;
  /** It met bodies in the last step. */
  #met = false;
  /** Of the moment that somebody looks back at. */
  #past: Seen | undefined;
  /** How often it has become another to who looks at it. */
  changes = 0;
  /** The last one that was due was not born, since others in the world leave it no room. */
  crowded = false;

  readonly #bounces: Bounces;

  constructor(simulation: Simulation, bounces: Bounces, settings: () => Settings) {
    this.#settings = settings;
    this.#bounces = bounces;
    this.#place = new EmitterPlace(simulation);
  }

  get stale(): boolean {
    return this.#stale;
  }

  /** What its author says is to be heard anew. */
  set stale(stale: boolean) {
    this.#stale = stale;
    this.#heard = undefined;
  }

  /** Whether it has particles, or will have some without anybody doing anything. */
  get active(): boolean {
    return this.count > 0 || this.#emits;
  }

  /** Particles that live; who asks before the step that a word acts in hears what that word leaves of them. */
  get count(): number {
    const { enabled, most } = this.#latest;
    return enabled ? Math.min(this.cloud.count, most) : 0;
  }

  /** What there is to see of it: where somebody looks back, that of then. */
  get seen(): Seen {
    const { cloud, count } = this;
    return this.#past ?? { cloud, first: cloud.count - count, time: this.#time };
  }

  get picture(): CloudPicture {
    return pictureOf(this.seen);
  }

  /** Somebody looks back; undefined: not any more. */
  lookBack(past: Seen | undefined): void {
    this.#past = past;
    this.changes++;
  }

  /** Whether bodies feel its winds. */
  get blows(): boolean {
    return this.#felt !== undefined;
  }

  /** Whether it meets bodies. */
  get collides(): boolean {
    return this.#latest.surface?.bodies === true && this.active;
  }

  get #emits(): boolean {
    const { enabled, creates, emitter, atOnce, most, lifetime, body } = this.#latest;
    if (!enabled || !creates || !emitter || most < 1 || lifetime <= 0) return false;
    // It is not there, or not any more.
    if (body && body.slot < 0) return false;
    return !(atOnce && this.#burst && this.#creates);
  }

  /** What its author says now. */
  get #latest(): Settings {
    if (!this.stale) return this.#said;
    if (!this.#heard) this.#heard = this.#settings();
    return this.#heard;
  }

  // ---- what its author says ---------------------------------------------------------------------------------------

  #read(): void {
    const said = (this.#said = this.#latest);
    this.#heard = undefined;
    this.#stale = this.#calm = false;
    this.#draws = new Draws(said.seed);
    this.#pushes.read(said, this.#draws);
    this.cloud.keep(said.enabled ? said.most : 0);
    if (this.cloud.count >= said.most) this.crowded = false;
    const creates = said.enabled && said.creates;
    if (creates && !this.#creates) this.#begin();
    this.#creates = creates;
    this.#schedule.takeRate(said.most, said.lifetime, this.#time);
  }

  /** From this moment on it emits. */
  #begin(): void {
    this.#schedule.due = this.#time;
    this.#burst = false;
  }

  // ---- a step -----------------------------------------------------------------------------------------------------

  /** `room`: so many of it may live, beside those of others. */
  step(dt: number, room = Infinity): void {
    if (this.stale) this.#read();
    this.#met = this.collides;
    this.#pushes.begin(this.#said, this.#gustOf(dt));
    if (!this.#isAsBefore(dt)) this.#calm = false;
    this.#drift.take(this.#said.damping, dt);
    this.#bury(dt);
    this.#moveAll(dt);
    const end = this.#time + dt;
    if (this.#emits) this.#bear(end, dt, room);
    else this.#rests(end);
    this.#time = end;
    this.#calm = true;
    this.changes++;
  }

  /** Those that are in water then. */
  soak(sea: Sea | undefined, dt: number): void {
    const { mass, radius } = this.#said;
    const { motion, count, still } = this.cloud;
    sea?.soak({ motion, stride: PARTICLE, count, still, mass, radius }, dt);
  }

  /** Whether all are pushed as before, for as long, and push nobody. */
  #isAsBefore(dt: number): boolean {
    const before = this.#dtBefore;
    this.#dtBefore = dt;
    return dt === before && this.#pushes.isAsBefore && this.#said.surface?.mass === 0;
  }

  /** None is due before the end of a step, and so none is kept from being born. */
  #rests(end: number): void {
    this.#schedule.due = Math.max(this.#schedule.due, end);
    this.crowded = false;
  }

  /** The number of the gust in a step that begins now. */
  #gustOf(dt: number): number {
    return Math.floor((this.#time + dt / 2) / GUST);
  }

  /** Those whose time ends in this step go, and the others close up. */
  #bury(dt: number): void {
    const { cloud } = this;
    const schedule = this.#schedule;
    schedule.beginStep();
    const end = this.#time + dt + schedule.sameTime;
    let kept = 0;
    for (let k = 0; k < cloud.count; k++)
      if (cloud.ends[k]! <= end) schedule.noteDeath(cloud.ends[k]!);
      else cloud.move(k, kept++);
    cloud.count = kept;
  }

  #moveAll(dt: number): void {
    if (!this.#said.surface && !this.#pushes.whirls) return this.#flyAll();
    for (let k = 0; k < this.cloud.count; k++) this.#move(k, this.#drift, dt, 0);
  }

  /** Nothing but drag and what pushes all alike moves them. */
  #flyAll(): void {
    const { motion, count } = this.cloud;
    const { left, speedOfPush, wayOfSpeed, wayOfPush } = this.#drift;
    for (let axis = 0; axis < 3; axis++) {
      const a = this.#pushes.all[axis]!;
      const way = a * wayOfPush;
      const gain = a * speedOfPush;
      for (let at = axis, end = count * PARTICLE; at < end; at += PARTICLE) {
        const speed = motion[at + 3]!;
        motion[at] = motion[at]! + speed * wayOfSpeed + way;
        motion[at + 3] = speed * left + gain;
      }
    }
  }

  /** Through the step of `dt` seconds from the share `since` of it on, which takes as long as `drift` is for. */
  #move(k: number, drift: Drift, dt: number, since: number): void {
    const { motion, numbers, still } = this.cloud;
    const { surface, damping } = this.#said;
    const push = this.#pushes.of(numbers[k]!);
    const at = k * PARTICLE;
    if (still[k] === 1 && this.#calm && this.#bounces.isCalm(motion, at, push, drift, surface!))
      return;
    if (surface && this.#bounces.isNear(motion, at, push, drift, surface)) {
      still[k] = Number(this.#bounces.follow(motion, at, push, damping, surface, dt, since));
      return;
    }
    still[k] = 0;
    for (let i = at; i < at + 3; i++) {
      const speed = motion[i + 3]!;
      const a = push[i - at]!;
      motion[i] = motion[i]! + speed * drift.wayOfSpeed + a * drift.wayOfPush;
      motion[i + 3] = speed * drift.left + a * drift.speedOfPush;
    }
  }

  // ---- bodies in its winds ----------------------------------------------------------------------------------------

  /** Before a step: whether bodies feel other winds in it than in the one before. */
  windsChange(): boolean {
    if (this.stale) this.#read();
    const said = this.#said;
    if (said === this.#looked) return false;
    this.#looked = said;
    const felt = said.blows ? JSON.stringify(said.winds) : undefined;
    if (felt === this.#felt) return false;
    this.#felt = felt;
    return true;
  }

  /** The winds that push bodies in a step of `dt` seconds that begins. */
  windsIn(dt: number): readonly Wind[] {
    if (!this.#said.blows) return NO_WINDS;
    const { winds } = this.#pushes;
    for (const wind of winds) wind.begin(this.#gustOf(dt));
    return winds;
  }

  // ---- births -----------------------------------------------------------------------------------------------------

  /** All that are due before the step ends, and live to its end. */
  #bear(end: number, dt: number, room: number): void {
    const { atOnce, body, most, lifetime, lifetimeVariation } = this.#said;
    const schedule = this.#schedule;
    if (body) this.#place.begin(body);
    schedule.sortDeaths();
    if (!atOnce) schedule.passOver(end, lifetime * (1 + lifetimeVariation));
    // Of a longest life at most twice as many are due as may live at once.
    const atMost = atOnce ? most : 2 * most + 2;
    const last = end + schedule.sameTime;
    for (let tries = 0; tries < atMost && schedule.due <= last; tries++) {
      // Those of this step that died later still lived then.
      const living = this.cloud.count + schedule.stillLiving;
      if (living < most) this.crowded = living >= room;
      if (living < most && !this.crowded) this.#bearOne(schedule.due, end, dt);
      schedule.pass(atOnce);
    }
    if (atOnce) this.#burst = true;
    else schedule.due = Math.max(schedule.due, end);
  }

  #bearOne(due: number, end: number, dt: number): void {
    const { emitter, lifetime, lifetimeVariation, body, damping } = this.#said;
    const number = this.#schedule.next;
    const lives = lifetime * (1 + lifetimeVariation * this.#draws.of(number, LIVES).either());
    if (due + lives <= end) return;
    if (!emitter!.emit(this.#draws.of(number, EMITTED), this.#birth)) return;
    if (body) this.#carry(body, (due - this.#time) / dt);
    const { cloud } = this;
    const k = cloud.add();
    cloud.motion.set(this.#birth, k * PARTICLE);
    cloud.born[k] = due;
    cloud.ends[k] = due + lives;
    cloud.numbers[k] = number;
    const left = Math.max(0, end - due);
    this.#move(k, this.#rest.take(damping, left), dt, 1 - left / dt);
    // A whole step does more.
    cloud.still[k] = 0;
  }

  /** Whoever pushes what it meets pushes what it is thrown from, too. */
  #carry(body: Body, share: number): void {
    const thrown = this.#place.carry(body, share, this.#birth);
    const { surface } = this.#said;
    if (surface) this.#bounces.recoil(body, this.#birth, thrown, surface.mass, share);
  }

  // ---- going back -------------------------------------------------------------------------------------------------

  reset(): void {
    this.cloud.clear();
    this.#time = this.#schedule.due = this.#schedule.next = 0;
    this.#creates = this.#burst = false;
    this.#felt = undefined;
    this.#met = false;
    this.#begun();
  }

  /** It goes on from elsewhere. */
  #begun(): void {
    this.stale = true;
    this.crowded = false;
    this.lookBack(undefined);
  }

  save(): KeptSystem {
    const kept: KeptSystem = {
      ...this.progress,
      due: this.#schedule.due,
      next: this.#schedule.next,
      cloud: this.cloud.save(),
    };
    if (this.#felt !== undefined) kept.felt = this.#felt;
    if (this.#met) kept.met = true;
    return kept;
  }

  get progress(): Progress {
    return { time: this.#time, burst: this.#burst, creates: this.#creates };
  }

  /** Somebody else takes its steps. */
  set progress({ time, burst, creates }: Progress) {
    this.#time = time;
    this.#burst = burst;
    this.#creates = creates;
  }

  load(kept: KeptSystem): void {
    this.cloud.load(kept.cloud);
    this.progress = kept;
    this.#schedule.due = kept.due;
    this.#schedule.next = kept.next;
    this.#felt = kept.felt;
    this.#met = kept.met === true;
    this.#begun();
  }
}
