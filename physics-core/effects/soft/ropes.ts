import { add, compose, cross, length, subtract } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import type { Vec3 } from '../../fields/types.js';
import { HELD } from '../../solver/ropes/strand.js';
import type { RowSystem } from '../../solver/joints/row-system.js';
import type { DragEnd, Hold } from '../drag/hold.js';
import type { SoftPoints, SoftWorld } from '../drag/soft.js';
import type { KeptSoftDrag } from '../drag/soft-drag.js';
import { SoftHands } from '../drag/soft-hands.js';
import { Effect, type Cause } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import type { Pull } from '../joints/component-solve.js';
import { jointSolve } from '../joints/effects.js';
import type { JointSolve } from '../joints/joint-solve.js';
import { water } from '../water/effects.js';
import { resting } from '../rest/resting.js';
import { Holding, together, wholesOf } from './held.js';
import { Rope, type KeptRope, type ToldRope } from './rope.js';
import { RopeTouch } from './rope-touch.js';
import type { RopeSource, Tie } from './settings.js';
import { TiedGroup } from './tied-group.js';
import { CARRIED } from './tolerances.js';

interface Kept {
  all: [id: number, kept: KeptRope][];
  /** Where somebody holds one. */
  hands?: KeptSoftDrag[];
}

/** All ropes of a world. */
export class Ropes extends Effect implements Pull, SoftWorld {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  /** By the numbers of their nodes. */
  readonly #ropes = new Map<number, Rope>();
  readonly #holding = new Holding((source) => this.of(source));
  readonly #touch: RopeTouch;
  /** Which version of each another thread knows. */
  readonly #told = new WeakMap<Rope, number>();
  #hands: SoftHands | undefined;
  #groups: TiedGroup[] = [];
  /** Which bodies the joint solve has for what ties them. */
  #tied = new Map<Tie, Body>();
  /** Groups are to be made anew. */
  #stale = true;
  /** By which numbering of joints they were made. */
  #numbering: number | undefined;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    this.#touch = new RopeTouch(simulation);
  }

  get all(): Iterable<Rope> {
    return this.#ropes.values();
  }

  of({ id }: RopeSource): Rope | undefined {
    return this.#ropes.get(id);
  }

  override need(source: RopeSource, reason: string): void {
    if (!this.of(source)) this.#ropes.set(source.id, new Rope(source));
    this.#stale = true;
    super.need(source, reason);
    this.changed(source);
  }

  override release(node: Cause): void {
    if (!this.isNeededBy(node)) return;
    const source = node as RopeSource;
    this.#hands?.letGo(source, source.removed ? 'removed' : 'reset');
    this.#ropes.delete((node as RopeSource).id);
    this.#effects.find(water)?.forget((node as RopeSource).id);
    super.release(node);
    this.#letGo();
    if (this.active) this.#simulation.bodies.goOn();
  }

  /** An author said something about a rope. */
  changed(source: RopeSource): void {
    const rope = this.of(source);
    if (rope) rope.stale = true;
    this.#wakeTied(source);
    this.#simulation.bodies.goOn();
  }

  tie(tie: Tie): void {
    this.#holding.add(tie);
    tie.body?.wake();
    this.tieChanged(tie);
  }

  untie(tie: Tie): void {
    this.#holding.delete(tie);
    this.tieChanged(tie);
    this.#letGo();
  }

  /** Who is tied no more is let go at once; groups are made before the next step, when all edits are in. */
  #letGo(): void {
    this.#stale = true;
    this.#holding.list();
    this.#tieBodies();
    if (!this.active) this.#groups = [];
  }

  tieChanged({ rope }: Tie): void {
    this.#stale = true;
    if (rope) this.of(rope)?.wake();
    if (rope) this.#wakeTied(rope);
    if (this.active) this.#simulation.bodies.goOn();
  }

  override waterChanged(): void {
    const sea = this.#effects.find(water);
    for (const rope of this.#ropes.values()) {
      if (!rope.asleep || !sea?.concerns(rope, rope.points)) continue;
      rope.wake();
      this.#simulation.bodies.goOn();
    }
  }

  #wakeTied(source: RopeSource): void {
    for (const { rope, body } of this.#holding.ties)
      if (rope === source && body?.sleeping) body.wake();
  }

  // ---- by hand --------------------------------------------------------------------------------------------------------

  /** Takes hold of the place nearest to a point; undefined where nothing of it goes anywhere. */
  grab(source: RopeSource, point: Vec3, onend: (reason: DragEnd) => void): Hold | undefined {
    this.#takeEdits();
    this.#hands ??= new SoftHands(this.#simulation, this);
    return this.#hands.grab(source, this.of(source)?.gripAt(point), point, onend);
  }

  /** Nobody may hold it any more. */
  letGo(source: RopeSource): void {
    this.#hands?.letGo(source, 'disabled');
  }

  pointsOf(source: RopeSource): SoftPoints | undefined {
    return this.of(source)?.strand;
  }

  *tiedTo(source: RopeSource): Generator<Body> {
    for (const { rope, body, movable } of this.#holding.held)
      if (rope.source === source && body && movable) yield body;
  }

  keepAwake(source: RopeSource): void {
    this.of(source)?.wake();
    if (this.active) this.#simulation.bodies.goOn();
  }

  // ---- who holds what -------------------------------------------------------------------------------------------------

  /** Groups are made anew where other bodies hold other points. */
  #divide(): void {
    const numbering = this.#effects.find(jointSolve)?.numbering;
    if (!this.#stale && !this.#holding.changed && numbering === this.#numbering) return;
    this.#stale = false;
    this.#holding.list();
    const { held } = this.#holding;
    const ropes = (this.inOrder as readonly RopeSource[])
      .map((source) => this.of(source)!)
      .filter(({ settings }) => settings.enabled);
    for (const rope of ropes) rope.hold();
    this.#tieBodies();
    const joints = this.#effects.find(jointSolve);
    this.#numbering = joints?.numbering;
    const componentOf = (body: Body) => joints?.togetherWith(body);
    this.#groups = [...together(ropes, held, componentOf)].map((members) => {
      const own = held.filter(({ rope }) => members.has(rope));
      const wholes = wholesOf(own, componentOf);
      const bodies = wholes.flatMap((whole) => whole.bodies);
      for (const { tie, rope, body, movable } of own)
        rope.strand.holders[tie.index] = movable ? bodies.indexOf(body!) : HELD;
      return new TiedGroup([...members], wholes, own);
    });
  }

  /** What is tied no more falls. */
  #tieBodies(): void {
    const tied = new Map(
      this.#holding.held.flatMap(({ tie, body, movable }) => (movable ? [[tie, body!]] : [])),
    );
    const joints = this.#effects[tied.size > 0 ? 'get' : 'find'](jointSolve);
    for (const [tie, body] of this.#tied) {
      if (tied.get(tie) === body) continue;
      joints?.release(tie);
      if (body.sleeping) body.wake();
    }
    for (const [tie, body] of tied) joints!.tie(tie, body, 'a rope');
    joints?.pulls[tied.size > 0 ? 'add' : 'delete'](this);
    this.#tied = tied;
  }

  // ---- a step -----------------------------------------------------------------------------------------------------------

  /** Before anything of the step begins: the joint solve may have to come for what is tied. */
  override parts(): number {
    this.#takeEdits();
    this.#hands?.wake();
    this.#wakeTogether();
    return 1;
  }

  #takeEdits(): void {
    for (const rope of this.#ropes.values()) {
      if (!rope.stale) continue;
      rope.read();
      this.#stale = true;
    }
    this.#divide();
  }

  override beforeStep(dt: number): void {
    const joints = this.#effects.caused(jointSolve);
    this.#touch.take(dt);
    this.#hands?.begin(dt);
    for (const group of this.#groups) {
      if (group.asleep) continue;
      group.read(joints, dt, this);
      this.#begin(group, dt);
      this.#touch.look(group, dt);
      this.#solve(group, joints, dt);
      group.note();
      this.#touch.push(group, dt);
    }
  }

  /** Round ways of joints go by what ropes give, and ropes by those: asked once, both find the same to a millionth. */
  #solve(group: TiedGroup, joints: JointSolve | undefined, dt: number): void {
    const { solve } = group;
    let found = solve.solve(dt);
    if (found && group.differs(joints, dt)) found = solve.solveAgain(dt);
    if (!found) this.#stop(group);
  }

  /** What moves keeps awake what it is tied to, and the other way round. */
  #wakeTogether(): void {
    const rest = this.#effects.find(resting);
    for (const { ropes, bodies } of this.#groups) {
      const moves =
        ropes.some((rope) => !rope.quiet || this.#isMet(rope)) ||
        bodies.some((body) => !body.sleeping);
      if (!moves) continue;
      for (const rope of ropes) rope.asleep = false;
      if (ropes.every(({ quiet }) => quiet)) continue;
      for (const body of bodies) {
        if (body.sleeping) body.wake();
        rest?.restart(body.slot);
      }
    }
  }

  /** Whether a rope that rests is about to be touched by what moves. */
  #isMet(rope: Rope): boolean {
    if (!rope.asleep) return false;
    if (this.#effects.caused(water)?.isRocked(rope.id)) {
      rope.wake();
      return true;
    }
    const { bodies } = this.#simulation;
    const { slots, pointers, asleep } = bodies.moving;
    for (let slot = 0; slot < slots; slot++) {
      if (pointers[slot] === 0 || asleep[slot] === 1) continue;
      const body = bodies.in(slot)!;
      if (!rope.isNear(body.centerOfMassWorld(), body.reach)) continue;
      rope.wake();
      return true;
    }
    return false;
  }

  #begin({ ropes, held }: TiedGroup, dt: number): void {
    for (const rope of ropes) rope.stand();
    for (const { tie, rope, body, movable } of held) {
      this.#place(rope, tie, body, movable, dt);
      if (body) this.#touch.comeOut(rope, tie.index, body.slot);
    }
    const hands = this.#hands?.any ? this.#hands : undefined;
    const sea = this.#effects.caused(water);
    for (const rope of ropes) {
      rope.water = sea?.swimLine(rope, dt);
      rope.begin(dt);
      if (hands) rope.take(hands.on(rope.source), dt);
    }
  }

  /** A tied point is where its body has it; one that others move is on its way there. */
  #place(
    rope: Rope,
    { position, index }: Tie,
    body: Body | undefined,
    movable: boolean,
    dt: number,
  ): void {
    const { places, found, arms } = rope.strand;
    const at = body ? compose(body.pose(), { p: position, q: [0, 0, 0, 1] }).p : position;
    const arm = body ? subtract(at, body.centerOfMassWorld()) : at;
    const v = movable ? undefined : this.#speedAt(body, arm);
    const off = length(
      subtract(at, [places[3 * index]!, places[3 * index + 1]!, places[3 * index + 2]!]),
    );
    if (off > CARRIED * dt) rope.jump(index, at);
    for (let k = 0; k < 3; k++) {
      const j = 3 * index + k;
      if (v) found[j] = (at[k]! - places[j]!) / dt + v[k]!;
      else places[j] = at[k]!;
      arms[j] = arm[k]!;
    }
  }

  #speedAt(body: Body | undefined, arm: Vec3): Vec3 {
    if (!body) return [0, 0, 0];
    const { velocities } = this.#simulation.bodies;
    const [x, y, z, u, v, w] = velocities.subarray(body.slot * VELOCITY) as unknown as number[];
    return add([x!, y!, z!], cross([u!, v!, w!], arm));
  }

  /** Numbers that are none go nowhere. */
  #stop({ ropes, solve }: TiedGroup): void {
    solve.forget();
    for (const rope of ropes) {
      rope.stop();
      rope.source.stopped();
    }
  }

  pullsAt(body: Body): boolean {
    return body.ties.size > 0;
  }

  pullIn(body: Body, system: RowSystem, i: number): void {
    for (const group of this.#groups) group.pullIn(body, system, i);
  }

  override solved(dt: number): void {
    this.goOn(dt);
  }

  /** Bodies have other velocities in this step than were found: their ropes go on from those. */
  goOn(dt: number): void {
    for (const group of this.#groups) if (!group.asleep) group.goOn(this.#simulation, dt);
  }

  override settle(dt: number): void {
    for (const group of this.#groups) {
      if (group.asleep) continue;
      for (const rope of group.ropes) rope.move(dt);
    }
  }

  override stepOver(): void {
    let goesOn = false;
    for (const { ropes, bodies } of this.#groups) {
      const rests = ropes.every(({ quiet }) => quiet) && bodies.every(({ sleeping }) => sleeping);
      for (const rope of ropes) {
        if (!rope.asleep) rope.source.stepped();
        rope.asleep = rests;
      }
      if (!rests) goesOn = true;
    }
    if (goesOn) this.#simulation.bodies.goOn();
  }

  // ---- on another thread ------------------------------------------------------------------------------------------------

  /** What a page is to hear whose steps are taken here: those that have moved since it was told. */
  tell(): ToldRope[] | undefined {
    const told: ToldRope[] = [];
    for (const [id, rope] of this.#ropes) {
      if (this.#told.get(rope) === rope.version) continue;
      this.#told.set(rope, rope.version);
      told.push({ id, places: rope.strand.places.slice() });
    }
    return told.length > 0 ? told : undefined;
  }

  /** Its steps are taken elsewhere; what that side told. */
  hear(told: readonly ToldRope[]): void {
    for (const each of told) this.#ropes.get(each.id)?.hear(each);
  }

  // ---- going back -------------------------------------------------------------------------------------------------------

  override reset(reason: DragEnd): void {
    this.#hands?.reset(reason);
    for (const rope of this.#ropes.values()) rope.reset();
    this.#stale = true;
  }

  /** What waits to be tied is, so that joints are numbered in what is kept of them as they are in the next step. */
  override save(): Kept {
    this.#takeEdits();
    const hands = this.#hands?.save();
    return {
      ...(hands && { hands }),
      all: [...this.#ropes].map(([id, rope]) => [id, rope.save()]),
    };
  }

  override load({ all, hands }: Kept): void {
    this.#takeEdits();
    if (hands) (this.#hands ??= new SoftHands(this.#simulation, this)).load(hands);
    for (const [id, kept] of all) this.#ropes.get(id)?.load(kept);
    this.#simulation.bodies.goOn();
  }
}
