import { carrying } from '../../effects/drag/effects.js';
import { debugging } from '../../effects/debug/debugging.js';
import { contacts } from '../../effects/effect/chunks.js';
import { continuousCollision, FAR, sweptEnds } from '../../effects/hits/effects.js';
import { resting } from '../../effects/rest/resting.js';
import { keepAwake, putToSleep } from '../../engine/body-state.js';
import { MovingBodies, VELOCITY } from '../../engine/moving-bodies.js';
import { loadState } from '../../engine/kept-bodies.js';
import { StatePass } from '../../engine/state-pass.js';
import { guards } from '../../base/guards.js';
import { compose7, dot3 } from '../../base/flat-math.js';
import type { Effect } from '../../effects/effect/effect.js';
import { fullTurns } from '../../effects/flight/full-turns.js';
import { FAR_TURN } from '../../engine/turns.js';
import { invert, type Pose } from '../../base/math.js';
import { originFor } from './origin.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from '../../nodes/body/body.js';
import { POSE, type Poses } from '../../dynamics/poses.js';
import type { BodyTable, NodeWorld } from '../../nodes/node/node-world.js';

/** No body is sane at this speed or spin, m/s or rad/s. */
const WILD = 1e6;

/** The built bodies of a world by slot, and what is read of them after every step. */
export class BodySlots implements BodyTable {
  readonly #world: NodeWorld;
  #origin: Vec3 | undefined;
  readonly #poses: Poses;
  readonly #bySlot: (BodyNode | undefined)[] = [];
  readonly #byPointer = new Map<number, BodyNode>();
  readonly moving = new MovingBodies();
  readonly #pass = new StatePass();
  readonly #centre = new Float64Array(POSE);
  readonly #origin7 = new Float64Array(POSE);
  readonly #velocity = new Float64Array(VELOCITY);
  /** Of bodies in the frame of their centre of mass, by slot, once that was asked for. */
  readonly #origins: (Pose | undefined)[] = [];
  /** How many move, as far as that is known. */
  #awake = 0;
  /** Something else than bodies moves. */
  #goesOn = false;

  constructor(world: NodeWorld, poses: Poses) {
    this.#world = world;
    this.#poses = poses;
  }

  *[Symbol.iterator](): Generator<BodyNode> {
    for (const body of this.#bySlot) if (body) yield body;
  }

  get count(): number {
    let count = 0;
    for (const body of this.#bySlot) if (body && !body.isObstacle) count++;
    return count;
  }

  /** Whether the next step has anything to do: as the last one, `wake` and `sleep` left it; where that says no, counted anew. */
  get goesOn(): boolean {
    return this.#goesOn || this.#awake > 0 || this.countAwake() > 0;
  }

  goOn(): void {
    this.#goesOn = true;
    this.#world.work();
  }

  /** The body behind a heap pointer that Bullet hands us. */
  behind(pointer: number): BodyNode | undefined {
    return this.#byPointer.get(pointer);
  }

  register(body: BodyNode): void {
    this.#byPointer.set(body.pointer, body);
  }

  /** Bodies in the world that do not sleep, counted anew. One that is carried along may push others. */
  countAwake(): number {
    let awake = 0;
    for (const body of this)
      if (body.active && (body.movable ? !this.asleep(body) : body.kinematic)) awake++;
    return awake;
  }

  in(slot: number): BodyNode | undefined {
    return this.#bySlot[slot];
  }

  /** The author's body in a slot. */
  at(slot: number): BodyNode | undefined {
    const body = this.#bySlot[slot];
    return body?.isObstacle ? undefined : body;
  }

  /** Where Bullet is to count from; undefined: the first body says, with all that are to come. */
  countFrom(origin: Vec3 | undefined): void {
    this.#origin = origin;
  }

  take(body: BodyNode): number {
    if (!this.#bySlot.some(Boolean))
      this.#poses.origin = this.#origin ?? originFor(body, this.#world.nodes);
    const slot = this.#poses.take();
    this.#bySlot[slot] = body;
    this.moving.take(slot);
    return slot;
  }

  /** Whether Bullet has it among what moves may be another, and so may its size, mass, centre of mass and gravity. */
  review({ slot, object, isDynamic }: BodyNode): void {
    if (slot < 0) return;
    this.moving.reviews++;
    this.moving.pointers[slot] = object.inWorld && isDynamic ? object.pointer : 0;
    this.moving.limits[slot] = NaN;
    this.#origins[slot] = undefined;
  }

  release(body: BodyNode): void {
    if (this.#byPointer.get(body.pointer) === body) this.#byPointer.delete(body.pointer);
    if (body.slot < 0) return;
    this.#bySlot[body.slot] = undefined;
    this.moving.pointers[body.slot] = 0;
    this.#poses.release(body.slot);
  }

  velocityOf(body: BodyNode): Float64Array {
    return this.moving.velocities.subarray(body.slot * VELOCITY, (body.slot + 1) * VELOCITY);
  }

  /** Of all slots, as they were read last: at the end of the last step, or after an edit. */
  get velocities(): Float64Array {
    return this.moving.velocities;
  }

  /** Whether a body's speeds lie below both limits. */
  slower(slot: number, linear: number, angular: number): boolean {
    const v = this.moving.velocities;
    const at = slot * VELOCITY;
    const speed = v[at]! ** 2 + v[at + 1]! ** 2 + v[at + 2]! ** 2;
    const spin = v[at + 3]! ** 2 + v[at + 4]! ** 2 + v[at + 5]! ** 2;
    return speed < linear * linear && spin < angular * angular;
  }

  /** Whether any body that moves is faster, m/s. */
  anyFaster(speed: number): boolean {
    for (let slot = 0; slot < this.#bySlot.length; slot++)
      if (this.#bySlot[slot]?.isDynamic && !this.slower(slot, speed, Infinity)) return true;
    return false;
  }

  readVelocity(body: BodyNode): void {
    this.#world.engine.reader.velocity(body.pointer, this.moving.velocities, body.slot * VELOCITY);
    this.#judge(this.#bySlot[body.slot]!, body.slot);
  }

  /** What goes far in a step is looked after. */
  #judge(body: BodyNode, slot: number): void {
    const { timeStep, registry: effects } = this.#world;
    const v = this.moving.velocities;
    const at = slot * VELOCITY;
    const square = dot3(v, at, v, at) * timeStep * timeStep;
    const far = square > 0 && square > (FAR * body.leastExtent) ** 2;
    if (far && contacts.here) effects.get(continuousCollision).need(body);
    else effects.caused(continuousCollision)?.release(body);
    const spin = dot3(v, at + 3, v, at + 3) * timeStep * timeStep;
    if (spin > FAR_TURN ** 2) effects.get(fullTurns).need(body);
    else effects.caused(fullTurns)?.release(body);
    if (spin > 0 && spin > turnOfEnds(body) ** 2 && contacts.here)
      effects.get(sweptEnds).need(body);
    else effects.caused(sweptEnds)?.release(body);
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  /** Whether its pose is the one that Bullet has, to the last bit. */
  isAsInBullet(body: BodyNode): boolean {
    const at = body.slot * POSE;
    const pose = this.#readPose(body);
    for (let i = 0; i < POSE; i++)
      if (!Object.is(pose[i], this.#poses.current[at + i])) return false;
    return true;
  }

  /**
   * Puts it as a snapshot has it, from `states[at]` on; `pose`: where it is said to be, seen from Bullet's origin, which
   * Bullet has rounded.
   */
  load(body: BodyNode, states: Float32Array, at: number, pose?: Pose): void {
    const { engine } = this.#world;
    if (pose) body.motion.placeInBullet(pose);
    loadState(engine.ammo, body.body, body.pointer, states, at);
    if (!pose) {
      this.#poses.current.set(this.#readPose(body), body.slot * POSE);
      this.#poses.snap(body.slot);
      this.#world.rays.moved();
    }
    this.readVelocity(body);
  }

  /** Of its origin, from Bullet. */
  #readPose({ pointer, slot, centerOfMass }: BodyNode): Float64Array {
    const out = this.#origin7;
    this.#world.engine.reader.pose(pointer, this.#centre, 0);
    if (isCentred(centerOfMass)) out.set(this.#centre);
    else compose7(out, 0, this.#centre, 0, (this.#origins[slot] ??= invert(centerOfMass)));
    return out;
  }

  // ---- sleep ----------------------------------------------------------------------------------------------------

  asleep(body: BodyNode): boolean {
    return this.moving.asleep[body.slot] === 1;
  }

  /** And all that it fell asleep together with: they bear each other, and go in the same step. */
  wake(body: BodyNode): void {
    const island = this.asleep(body) && this.#world.registry.find(resting)?.islandOf(body.slot);
    this.#wakeAlone(body);
    if (!island) return;
    for (const other of island)
      if (this.asleep(other as BodyNode)) this.#wakeAlone(other as BodyNode);
  }

  #wakeAlone(body: BodyNode): void {
    keepAwake(body.body);
    this.#world.registry.find(resting)?.restart(body.slot);
    if (this.moving.asleep[body.slot]) this.#setAsleep(body, false);
    // So that the page's loop starts again at once, not at the next step.
    this.#awake = Math.max(this.#awake, 1);
    this.#world.work();
  }

  sleep(body: BodyNode): void {
    putToSleep(body.body);
    this.#world.registry.find(resting)?.leaveIsland(body.slot);
    if (!this.moving.asleep[body.slot]) this.#setAsleep(body, true);
  }

  /** Falls asleep without a word, if it was asleep before the world was restored. */
  restoreSleep(body: BodyNode): void {
    putToSleep(body.body);
    this.moving.asleep[body.slot] = 1;
    this.moving.limits[body.slot] = NaN;
  }

  #setAsleep(body: BodyNode, asleep: boolean): void {
    this.moving.asleep[body.slot] = asleep ? 1 : 0;
    this.moving.limits[body.slot] = NaN;
    this.#world.registry.find(debugging)?.stale();
    if (asleep) {
      this.moving.stop(body.slot);
      body.setVelocityAtOrigin({ linear: [0, 0, 0], angular: [0, 0, 0] });
    }
    body.emit(asleep ? 'sleep' : 'wake', { time: this.#world.time });
    // What this leaves too low is counted anew.
    if (asleep) this.#awake = Math.max(0, this.#awake - 1);
  }

  /** All are taken down: nobody is to hear of whom that would wake. */
  forgetSleep(): void {
    this.moving.asleep.fill(0);
  }

  /** Those that sleep now, and what tells of them later that they were woken: by a world made again. */
  sleepers(): () => void {
    const slept = [...this].filter((body) => body.sleeping);
    return () => {
      for (const body of slept)
        if (body.built && !body.sleeping) body.emit('wake', { time: this.#world.time });
    };
  }

  // ---- after a step -----------------------------------------------------------------------------------------------

  /** Reads poses and velocities of everything awake; parks what is no longer finite. */
  read(): void {
    const pass = this.#pass;
    const { engine, timeStep } = this.#world;
    pass.all(engine.ammo, this.moving, this.#poses, timeStep);
    let awake = pass.count;
    let broken: BodyNode[] | undefined;
    for (let i = 0; i < pass.asideCount; i++) {
      const slot = pass.aside[i]!;
      const body = this.#bySlot[slot]!;
      if (!this.#stayedAwake(body, slot)) continue;
      if (this.#readBody(body, slot)) awake++;
      else (broken ??= []).push(body);
    }
    this.#judgeFast();
    this.#awake = awake + this.#countCarried();
    this.#goesOn = false;
    if (broken) this.#mend(broken);
  }

  /** Who went or turned far in the step before may do so no more. */
  #judgeFast(): void {
    const { registry: effects } = this.#world;
    this.#judgeCauses(effects.caused(continuousCollision));
    this.#judgeCauses(effects.caused(sweptEnds));
    this.#judgeCauses(effects.caused(fullTurns));
  }

  #judgeCauses(effect: Effect | undefined): void {
    if (!effect) return;
    for (const node of effect.causes) {
      const body = node as BodyNode;
      if (body.active && body.isDynamic && !this.asleep(body)) this.#judge(body, body.slot);
    }
  }

  /** What is carried along may push others. */
  #countCarried(): number {
    const effect = this.#world.registry.caused(carrying);
    if (!effect) return 0;
    let count = 0;
    for (const node of effect.causes) {
      const { active, kinematic } = node as BodyNode;
      if (active && kinematic) count++;
    }
    return count;
  }

  /**
   * A body without finite numbers breaks what it touches or is joined to. What was sane before the step goes on from
   * there; where nothing else stands out, all of them are parked.
   */
  #mend(broken: BodyNode[]): void {
    const sane = broken.filter((body) => this.slower(body.slot, WILD, WILD));
    for (const body of broken) {
      if (sane.length < broken.length && sane.includes(body)) body.presence.recover();
      else body.presence.park();
    }
  }

  /** Bullet wakes a sleeping island that something hits by changing its state. */
  #stayedAwake(body: BodyNode, slot: number): boolean {
    if (this.#world.engine.reader.sleeps(body.pointer)) return false;
    if (this.moving.asleep[slot]) this.wake(body);
    return true;
  }

  /** False: not finite. The last good pose and velocity then still stand. */
  #readBody(body: BodyNode, slot: number): boolean {
    const { reader } = this.#world.engine;
    const centre = this.#centre;
    reader.pose(body.pointer, centre, 0);
    reader.velocity(body.pointer, this.#velocity, 0);
    let sum = 0;
    for (let i = 0; i < POSE; i++) sum += centre[i]!;
    for (let i = 0; i < VELOCITY; i++) sum += this.#velocity[i]!;
    if (!guards.finiteState(sum)) return false;
    this.moving.velocities.set(this.#velocity, slot * VELOCITY);
    this.#judge(body, slot);
    const { centerOfMass } = body;
    const { current } = this.#poses;
    if (isCentred(centerOfMass)) {
      this.moving.limits[slot] = (FAR * body.leastExtent) ** 2;
      this.moving.turnLimits[slot] = Math.min(FAR_TURN, turnOfEnds(body)) ** 2;
      current.set(centre, slot * POSE);
    } else {
      // From the centre of mass, which Bullet moves, to the body's origin.
      const origin = (this.#origins[slot] ??= invert(centerOfMass));
      compose7(current, slot * POSE, centre, 0, origin);
    }
    this.#poses.mark(slot);
    return true;
  }
}

/** Radians by which a body may turn before its ends go far, if they are as far out as anything of it. */
const turnOfEnds = ({ leastExtent, reach }: BodyNode): number => (FAR * leastExtent) / reach;

/** Whether the centre of mass is the body's origin, and its axes are the body's. */
const isCentred = ({ p, q }: Pose): boolean => p[0] === 0 && p[1] === 0 && p[2] === 0 && q[3] === 1;
