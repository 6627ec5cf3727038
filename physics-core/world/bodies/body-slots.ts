import { debugging } from '../../effects/debug/debugging.js';
import { contacts } from '../../effects/effect/chunks.js';
import { continuousCollision, FAR } from '../../effects/hits/effects.js';
import { resting } from '../../effects/rest/resting.js';
import { keepAwake, putToSleep } from '../../engine/body-state.js';
import { guards } from '../../base/guards.js';
import { compose, invert, type Pose } from '../../base/math.js';
import type { BodyNode } from '../../nodes/body/body.js';
import { POSE, type Poses } from '../../dynamics/poses.js';
import type { BodyTable, NodeWorld } from '../../nodes/node/node-world.js';

/** Numbers per velocity: linear, then angular. */
const VELOCITY = 6;

/** No body is sane at this speed or spin, m/s or rad/s. */
const WILD = 1e6;

/** The built bodies of a world by slot, and what is read of them after every step. */
export class BodySlots implements BodyTable {
  readonly #world: NodeWorld;
  readonly #poses: Poses;
  readonly #bySlot: (BodyNode | undefined)[] = [];
  readonly #byPointer = new Map<number, BodyNode>();
  #velocities = new Float64Array(VELOCITY * 16);
  #asleep = new Uint8Array(16);
  readonly #centre = new Float64Array(POSE);
  readonly #velocity = new Float64Array(VELOCITY);
  awake = 0;

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

  /** As the last step, `wake` and `sleep` left it; where that says none, counted anew. */
  get anyAwake(): boolean {
    return this.awake > 0 || this.countAwake() > 0;
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

  /** The author's body in a slot. */
  at(slot: number): BodyNode | undefined {
    const body = this.#bySlot[slot];
    return body?.isObstacle ? undefined : body;
  }

  take(body: BodyNode): number {
    const slot = this.#poses.take();
    this.#bySlot[slot] = body;
    if (slot >= this.#asleep.length) this.#grow();
    this.#asleep[slot] = 0;
    this.#velocities.fill(0, slot * VELOCITY, (slot + 1) * VELOCITY);
    return slot;
  }

  release(body: BodyNode): void {
    if (this.#byPointer.get(body.pointer) === body) this.#byPointer.delete(body.pointer);
    if (body.slot < 0) return;
    this.#bySlot[body.slot] = undefined;
    this.#poses.release(body.slot);
  }

  #grow(): void {
    const velocities = new Float64Array(this.#velocities.length * 2);
    velocities.set(this.#velocities);
    this.#velocities = velocities;
    const asleep = new Uint8Array(this.#asleep.length * 2);
    asleep.set(this.#asleep);
    this.#asleep = asleep;
  }

  velocityOf(body: BodyNode): Float64Array {
    return this.#velocities.subarray(body.slot * VELOCITY, (body.slot + 1) * VELOCITY);
  }

  /** Of all slots, as they were read last: at the end of the last step, or after an edit. */
  get velocities(): Float64Array {
    return this.#velocities;
  }

  /** Whether a body's speeds lie below both limits. */
  slower(slot: number, linear: number, angular: number): boolean {
    const v = this.#velocities;
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
    this.#world.engine.reader.velocity(
      body.body,
      body.pointer,
      this.#velocities,
      body.slot * VELOCITY,
    );
    this.#judge(this.#bySlot[body.slot]!, body.slot);
  }

  /** What goes far in a step is looked after. */
  #judge(body: BodyNode, slot: number): void {
    const { timeStep, registry: effects } = this.#world;
    const v = this.#velocities;
    const at = slot * VELOCITY;
    const square = (v[at]! ** 2 + v[at + 1]! ** 2 + v[at + 2]! ** 2) * timeStep * timeStep;
    const far = square > 0 && square > (FAR * body.leastExtent) ** 2;
    if (far && contacts.here) effects.get(continuousCollision).need(body);
    else effects.caused(continuousCollision)?.release(body);
  }

  // ---- sleep ----------------------------------------------------------------------------------------------------

  asleep(body: BodyNode): boolean {
    return this.#asleep[body.slot] === 1;
  }

  wake(body: BodyNode): void {
    keepAwake(body.body);
    this.#world.registry.find(resting)?.restart(body.slot);
    if (this.#asleep[body.slot]) this.#setAsleep(body, false);
    // So that the page's loop starts again at once, not at the next step.
    this.awake = Math.max(this.awake, 1);
    this.#world.work();
  }

  sleep(body: BodyNode): void {
    putToSleep(body.body);
    this.#world.registry.find(resting)?.leaveIsland(body.slot);
    if (!this.#asleep[body.slot]) this.#setAsleep(body, true);
  }

  /** Falls asleep without a word, if it was asleep before the world was restored. */
  restoreSleep(body: BodyNode): void {
    putToSleep(body.body);
    this.#asleep[body.slot] = 1;
  }

  #setAsleep(body: BodyNode, asleep: boolean): void {
    this.#asleep[body.slot] = asleep ? 1 : 0;
    this.#world.registry.find(debugging)?.stale();
    if (asleep) {
      this.#velocities.fill(0, body.slot * VELOCITY, (body.slot + 1) * VELOCITY);
      body.setVelocityAtOrigin({ linear: [0, 0, 0], angular: [0, 0, 0] });
    }
    body.emit(asleep ? 'sleep' : 'wake', { time: this.#world.time });
    // What this leaves too low is counted anew.
    if (asleep) this.awake = Math.max(0, this.awake - 1);
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
    let awake = 0;
    let broken: BodyNode[] | undefined;
    for (let slot = 0; slot < this.#bySlot.length; slot++) {
      const body = this.#bySlot[slot];
      if (!body?.active) continue;
      if (body.kinematic) awake++;
      if (!body.isDynamic) continue;
      if (!this.#stayedAwake(body, slot)) continue;
      if (this.#readBody(body, slot)) awake++;
      else (broken ??= []).push(body);
    }
    this.awake = awake;
    if (broken) this.#mend(broken);
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
    if (this.#world.engine.reader.sleeps(body.body, body.pointer)) return false;
    if (this.#asleep[slot]) this.wake(body);
    return true;
  }

  /** False: not finite. The last good pose and velocity then still stand. */
  #readBody(body: BodyNode, slot: number): boolean {
    const { reader } = this.#world.engine;
    const centre = this.#centre;
    reader.pose(body.body, body.pointer, centre, 0);
    reader.velocity(body.body, body.pointer, this.#velocity, 0);
    let sum = 0;
    for (let i = 0; i < POSE; i++) sum += centre[i]!;
    for (let i = 0; i < VELOCITY; i++) sum += this.#velocity[i]!;
    if (!guards.finiteState(sum)) return false;
    this.#velocities.set(this.#velocity, slot * VELOCITY);
    this.#judge(body, slot);
    this.#store(body.centerOfMass, slot * POSE);
    this.#poses.mark(slot);
    return true;
  }

  /** From the centre of mass, which Bullet moves, to the body's origin. */
  #store(centerOfMass: Pose, at: number): void {
    const c = this.#centre;
    const { current } = this.#poses;
    const { p, q } = centerOfMass;
    if (p[0] === 0 && p[1] === 0 && p[2] === 0 && q[3] === 1) {
      current.set(c, at);
      return;
    }
    const pose = compose(
      { p: [c[0]!, c[1]!, c[2]!], q: [c[3]!, c[4]!, c[5]!, c[6]!] },
      invert(centerOfMass),
    );
    for (let i = 0; i < 3; i++) current[at + i] = pose.p[i]!;
    for (let i = 0; i < 4; i++) current[at + 3 + i] = pose.q[i]!;
  }
}
