import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import type { DragEnd, Hold } from '../drag/hold.js';
import type { SoftPoints, SoftWorld } from '../drag/soft.js';
import type { KeptSoftDrag } from '../drag/soft-drag.js';
import { SoftHands } from '../drag/soft-hands.js';
import { Effect, type Cause } from '../effect/effect.js';
import { Obstacles } from '../particles/collide/obstacles.js';
import { water } from '../water/effects.js';
import { resting } from '../rest/resting.js';
import type { Effects } from '../effect/effects.js';
import { Deformable, type KeptDeformable, type ToldDeformable } from './deformable.js';
import { followJumps } from './jumps.js';
import { Guests, type KeptGuests } from './guests.js';
import type { DeformableSource } from './settings.js';
import { Tied, type DeformableTie } from './ties.js';
import { ROUNDS, TAUT } from './tolerances.js';

interface Kept {
  guests: KeptGuests;
  all: [id: number, kept: KeptDeformable][];
  /** Where somebody holds one. */
  hands?: KeptSoftDrag[];
}

/** All cloth and soft bodies of a world. */
export class Deformables extends Effect implements SoftWorld {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  /** By the numbers of their nodes. */
  readonly #all = new Map<number, Deformable>();
  readonly #ties = new Set<DeformableTie>();
  /** Of those that are there, by the numbers of their nodes. */
  #tied: Tied[] = [];
  /** In this step: those that move, and what ties them. */
  readonly #moving: Deformable[] = [];
  readonly #holding: Tied[] = [];
  readonly #obstacles: Obstacles;
  readonly #guests: Guests;
  #hands: SoftHands | undefined;
  /** Which version of each another thread knows. */
  readonly #told = new WeakMap<Deformable, number>();
  /** Points are held by others than they were. */
  #stale = true;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    this.#obstacles = new Obstacles(simulation);
    this.#guests = new Guests(simulation);
  }

  get all(): Iterable<Deformable> {
    return this.#all.values();
  }

  of({ id }: DeformableSource): Deformable | undefined {
    return this.#all.get(id);
  }

  override need(source: DeformableSource, reason: string): void {
    if (!this.of(source)) this.#all.set(source.id, new Deformable(source));
    super.need(source, reason);
    this.changed(source);
  }

  override release(node: Cause): void {
    if (!this.isNeededBy(node)) return;
    const source = node as DeformableSource;
    this.#hands?.letGo(source, source.removed ? 'removed' : 'reset');
    this.#wakeWith(this.of(source)!);
    this.#all.delete((node as DeformableSource).id);
    this.#effects.find(water)?.forget((node as DeformableSource).id);
    super.release(node);
    this.#stale = true;
    if (this.active) this.#simulation.bodies.goOn();
  }

  /** An author said something about one. */
  changed(source: DeformableSource): void {
    const deformable = this.of(source);
    if (deformable) deformable.stale = true;
    if (deformable) this.#wakeWith(deformable);
    this.#stale = true;
    this.#simulation.bodies.goOn();
  }

  tie(tie: DeformableTie): void {
    this.#ties.add(tie);
    this.tieChanged(tie);
  }

  untie(tie: DeformableTie): void {
    this.#ties.delete(tie);
    this.tieChanged(tie);
  }

  tieChanged({ soft, body }: DeformableTie): void {
    this.#stale = true;
    if (soft) this.of(soft)?.wake();
    if (body?.sleeping) body.wake();
    if (this.active) this.#simulation.bodies.goOn();
  }

  override waterChanged(): void {
    const sea = this.#effects.find(water);
    for (const deformable of this.#all.values()) {
      if (!deformable.asleep || !sea?.concerns(deformable, deformable.masses)) continue;
      deformable.wake();
      this.#simulation.bodies.goOn();
    }
  }

  /** What it holds or carries wakes: it may go, or be another now. */
  #wakeWith(deformable: Deformable): void {
    const { bodies } = this.#simulation;
    for (const { tie, deformable: tied } of this.#tied)
      if (tied === deformable && tie.body?.sleeping) tie.body.wake();
    for (const slot of deformable.touches.slots) {
      const body = bodies.in(slot);
      if (body?.sleeping) body.wake();
    }
  }

  // ---- by hand --------------------------------------------------------------------------------------------------------

  /** Takes hold of the place nearest to a point; undefined where nothing of it goes anywhere. */
  grab(source: DeformableSource, point: Vec3, onend: (reason: DragEnd) => void): Hold | undefined {
    if (this.#stale) this.#divide();
    this.#hands ??= new SoftHands(this.#simulation, this);
    return this.#hands.grab(source, this.of(source)?.gripAt(point), point, onend);
  }

  /** Nobody may hold it any more. */
  letGo(source: DeformableSource): void {
    this.#hands?.letGo(source, 'disabled');
  }

  pointsOf(source: DeformableSource): SoftPoints | undefined {
    return this.of(source)?.material.masses;
  }

  *tiedTo(source: DeformableSource): Generator<Body> {
    for (const { tie, deformable } of this.#tied)
      if (deformable.source === source && tie.body?.movable) yield tie.body;
  }

  keepAwake(source: DeformableSource): void {
    this.of(source)?.wake();
    if (this.active) this.#simulation.bodies.goOn();
  }

  // ---- who is there ---------------------------------------------------------------------------------------------------

  /** Who takes part in the step that begins, by the numbers of their nodes: it adds up to the same bits, whoever came first. */
  #list(): void {
    this.#moving.length = this.#holding.length = 0;
    for (const cause of this.inOrder) {
      const deformable = this.of(cause as DeformableSource)!;
      deformable.moves = deformable.settings.enabled && !deformable.asleep;
      if (deformable.moves) this.#moving.push(deformable);
    }
    for (const tied of this.#tied)
      if (tied.tie.holds && tied.deformable.moves) this.#holding.push(tied);
  }

  /** Whether there is such a point; whether anything holds it may be another matter in the next step. */
  #hasPoint({ soft, index }: DeformableTie): boolean {
    const deformable = soft && this.of(soft);
    return deformable !== undefined && index < deformable.material.surface.shown;
  }

  #divide(): void {
    for (const deformable of this.#all.values()) {
      if (deformable.stale) deformable.read();
      deformable.hold();
      deformable.within.clear();
    }
    this.#tied = [...this.#ties]
      .filter((tie) => this.#hasPoint(tie))
      .sort((a, b) => a.id - b.id)
      .map((tie) => new Tied(tie, this.of(tie.soft!)!));
    this.#stale = false;
  }

  // ---- a step -----------------------------------------------------------------------------------------------------------

  override beforeStep(dt: number): void {
    if (this.#stale) this.#divide();
    this.#hands?.wake();
    this.#wakeTogether();
    this.#list();
    const moving = this.#moving;
    if (moving.length === 0) return;
    const guests = this.#guests;
    guests.begin();
    this.#obstacles.forget();
    this.#obstacles.take(dt);
    for (const each of this.#holding) each.begin(guests, dt);
    this.#followJumps();
    for (const deformable of moving) deformable.begin();
    this.#hands?.begin(dt);
    const sea = this.#effects.caused(water);
    let parts = 1;
    for (const deformable of moving) {
      deformable.water = sea?.swim(deformable, dt);
      deformable.touches.look(deformable, this.#obstacles, guests, dt);
      const { selfCollision, radius } = deformable.settings;
      if (selfCollision) deformable.material.lookAtItself?.(2 * radius, dt);
      parts = Math.max(parts, deformable.parts(dt));
    }
    for (let part = 1; part <= parts; part++) this.#go(dt / parts, part, dt);
    for (const deformable of moving) if (!deformable.end(dt)) deformable.stop();
    guests.end(dt, this.#wakes);
  }

  #followJumps(): void {
    for (const { jumps, deformable } of this.#holding)
      if (jumps)
        followJumps(
          deformable,
          this.#holding.filter((each) => each.deformable === deformable),
        );
  }

  /** One part of a step. */
  #go(time: number, part: number, dt: number): void {
    const guests = this.#guests;
    const moving = this.#moving;
    guests.go(time);
    const hands = this.#hands?.any ? this.#hands : undefined;
    for (const deformable of moving) {
      deformable.fall(time);
      if (hands) deformable.take(hands.on(deformable.source), time, dt - part * time);
    }
    let strain = Infinity;
    for (let round = 0; round < ROUNDS && strain > TAUT; round++) {
      strain = 0;
      for (const { material } of moving) {
        material.hold(time, round > 0);
        strain = Math.max(strain, material.strain);
      }
      for (const each of this.#holding) each.hold(guests, time);
      for (const { material, settings } of moving)
        if (settings.selfCollision) material.keepApart?.(settings.friction);
      for (const deformable of moving)
        deformable.touches.hold(deformable, guests, time, part * time);
    }
    for (const deformable of moving) {
      deformable.go(time);
      deformable.letGo();
    }
  }

  /** Who is carried by what has come to rest falls asleep there. */
  readonly #wakes = (slot: number): boolean => {
    for (const deformable of this.#all.values())
      if (!deformable.quiet && !deformable.asleep && deformable.touches.slots.includes(slot))
        return true;
    return this.#tied.some(({ deformable, slot: tied }) => tied === slot && !deformable.quiet);
  };

  #isAwake(slot: number): boolean {
    const body = this.#simulation.bodies.in(slot);
    return body !== undefined && body.movable && !body.sleeping;
  }

  /** What moves keeps awake what it is tied to, and the other way round. */
  #wakeTogether(): void {
    const sea = this.#effects.caused(water);
    for (const deformable of this.#all.values()) {
      if (!deformable.asleep) continue;
      if (sea?.isRocked(deformable.id) || this.#isMet(deformable)) deformable.wake();
    }
    for (const { tie, deformable } of this.#tied) {
      const { body } = tie;
      if (!body?.movable) continue;
      if (deformable.asleep && !body.sleeping) deformable.wake();
      else if (!deformable.quiet && body.sleeping) body.wake();
      if (!deformable.quiet) this.#effects.find(resting)?.restart(body.slot);
    }
  }

  /** Whether one that rests is about to be touched by what moves. */
  #isMet(deformable: Deformable): boolean {
    const { bodies } = this.#simulation;
    const { slots, pointers, asleep } = bodies.moving;
    for (let slot = 0; slot < slots; slot++) {
      if (pointers[slot] === 0 || asleep[slot] === 1) continue;
      const body = bodies.in(slot)!;
      if (deformable.isNear(body.centerOfMassWorld(), body.reach)) return true;
    }
    return false;
  }

  /** Whether anything that it is tied to, or touches, moves. */
  #keepsAwake(deformable: Deformable): boolean {
    for (const { tie, deformable: tied } of this.#tied)
      if (tied === deformable && tie.body?.movable && !tie.body.sleeping) return true;
    return deformable.touches.slots.some((slot) => this.#isAwake(slot));
  }

  override stepOver(): void {
    let goesOn = false;
    for (const deformable of this.#moving) {
      deformable.source.stepped();
      deformable.asleep = deformable.quiet && !this.#keepsAwake(deformable);
      if (!deformable.asleep) goesOn = true;
    }
    if (goesOn) this.#simulation.bodies.goOn();
  }

  // ---- on another thread ------------------------------------------------------------------------------------------------

  /** What a page is to hear whose steps are taken here: those that have moved since it was told. */
  tell(): ToldDeformable[] | undefined {
    const told: ToldDeformable[] = [];
    for (const [id, deformable] of this.#all) {
      if (this.#told.get(deformable) === deformable.version) continue;
      this.#told.set(deformable, deformable.version);
      told.push({ id, places: deformable.places.slice() });
    }
    return told.length > 0 ? told : undefined;
  }

  /** Its steps are taken elsewhere; what that side told. */
  hear(told: readonly ToldDeformable[]): void {
    for (const each of told) this.#all.get(each.id)?.hear(each);
  }

  // ---- going back -------------------------------------------------------------------------------------------------------

  override reset(reason: DragEnd): void {
    this.#hands?.reset(reason);
    for (const deformable of this.#all.values()) deformable.reset();
    this.#guests.forget();
    this.#stale = true;
  }

  override save(): Kept {
    const hands = this.#hands?.save();
    return {
      ...(hands && { hands }),
      guests: this.#guests.save(),
      all: [...this.#all].map(([id, deformable]) => [id, deformable.save()]),
    };
  }

  override load({ guests, all, hands }: Kept): void {
    if (hands) (this.#hands ??= new SoftHands(this.#simulation, this)).load(hands);
    this.#guests.load(guests);
    for (const [id, kept] of all) this.#all.get(id)?.load(kept);
    this.#simulation.bodies.goOn();
  }
}
