import { hypot } from '../../base/exact/index.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { multiply4, writeTurn } from '../../base/flat-math.js';
import { SIDE } from '../../solver/joints/blocks.js';
import type { Component } from '../../solver/joints/forest.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/** Share of a velocity, or of a place, that single precision may change in a step. */
const SAME = 1e-5;

/** What weight and contacts may add in a step to bodies at rest, m/s and rad/s. */
const GENTLE = 2;

const speedIn = (v: Float64Array, at: number): number => hypot(v[at]!, v[at + 1]!, v[at + 2]!);
/** Radians that joints are brought together by at once: beyond, straight ways lead away from where they are whole. */
const FARTHEST = 0.5;

/** What Bullet's step made of the velocities it was given, and what is put right of it. */
export class PostStabilization {
  readonly #simulation: Simulation;
  readonly #system: RowSystem;
  readonly #jointed: JointedBodies;
  /** Of velocities given to Bullet, what is motion: the rest closes what an edit tore. Then that rest. */
  #kept = new Float64Array(0);
  /** What of them is motion. */
  #motion = new Float64Array(0);
  /** Poses before joints are brought together by another round. */
  #saved = new Float64Array(0);
  readonly #pose = new Float64Array(POSE);
  readonly #now = new Float64Array(SIDE);
  readonly #displacement = new Float64Array(3);
  readonly #turn = new Float64Array(4);

  constructor(simulation: Simulation, system: RowSystem, jointed: JointedBodies) {
    this.#simulation = simulation;
    this.#system = system;
    this.#jointed = jointed;
  }

  take(bodies: number): void {
    if (this.#kept.length >= bodies * SIDE) return;
    this.#kept = new Float64Array(bodies * 2 * SIDE);
    this.#motion = new Float64Array(bodies * 2 * SIDE);
    this.#saved = new Float64Array(bodies * 2 * POSE);
  }

  /** Notes the velocities found: what is found beyond them is taken back after the step. */
  keep({ bodies }: Component): void {
    const { velocity } = this.#system;
    for (const i of bodies)
      for (let x = i * SIDE; x < (i + 1) * SIDE; x++)
        this.#kept[x] = this.#motion[x] = velocity[x]!;
  }

  /**
   * The velocities noted, less what Bullet has pushed bodies by already, go to Bullet: they take them to where joints are whole.
   * Those that are found are what of that is motion.
   */
  lead({ bodies }: Component, dt: number): void {
    const { reader, velocities } = this.#simulation.engine;
    const { velocity } = this.#system;
    const now = this.#now;
    for (const i of bodies) {
      const { pointer } = this.#jointed.bodies[i]!;
      reader.pose(pointer, this.#pose, 0);
      for (let x = 0; x < SIDE; x++) now[x] = this.#kept[i * SIDE + x]!;
      for (let x = 0; x < 3; x++)
        now[x]! -= (this.#pose[x]! - this.#jointed.place[i * 3 + x]!) / dt;
      velocities.write(pointer, now, 0);
      for (let x = 0; x < SIDE; x++) {
        this.#motion[i * SIDE + x] = velocity[i * SIDE + x]!;
        this.#kept[i * SIDE + x] = velocity[i * SIDE + x]! - now[x]!;
      }
    }
  }

  /** Those that close joints are found: notes what of them is to be taken back. */
  note({ bodies }: Component): void {
    const { velocity } = this.#system;
    for (const i of bodies)
      for (let x = i * SIDE; x < (i + 1) * SIDE; x++) this.#kept[x]! -= velocity[x]!;
  }

  /**
   * Returns the greatest speed (m/s, rad/s) that the way together left beyond what could be motion: it goes, too. `apart`:
   * Bullet's step did not see that way, and all it left is motion.
   */
  takeBack({ bodies }: Component, apart: boolean): number {
    const { engine, bodies: all } = this.#simulation;
    const now = this.#now;
    const most = apart ? Infinity : this.#mostSpeed(bodies);
    let left = 0;
    for (const i of bodies) {
      const node = this.#jointed.bodies[i]!;
      if (!node.active) continue;
      engine.reader.velocity(node.pointer, now, 0);
      for (let x = 0; x < SIDE; x++) now[x]! += this.#kept[i * SIDE + x]!;
      const speed = Math.max(speedIn(now, 0), speedIn(now, 3));
      if (speed > most) {
        left = Math.max(left, speed);
        for (let x = 0; x < SIDE; x++) now[x] = this.#motion[i * SIDE + x]!;
      }
      engine.velocities.write(node.pointer, now, 0);
      all.readVelocity(node);
    }
    return left;
  }

  /** A hit may turn a body round, or hand on what another one had. */
  #mostSpeed(bodies: Int32Array): number {
    let most = 0;
    for (const i of bodies)
      for (const part of [0, 3]) most = Math.max(most, speedIn(this.#motion, i * SIDE + part));
    return 2 * most + GENTLE;
  }

  /** Whether something else than joints and forces acted on a body in the step. */
  disturbed({ bodies }: Component, dt: number): boolean {
    for (const i of bodies) if (this.#swerved(i) || this.#pushed(i, dt)) return true;
    return false;
  }

  /** Whether a body has another velocity than was found. */
  swerved({ bodies }: Component): boolean {
    for (const i of bodies) if (this.#swerved(i)) return true;
    return false;
  }

  #swerved(i: number): boolean {
    const { velocity } = this.#system;
    const now = this.#now;
    const { pointer } = this.#jointed.bodies[i]!;
    this.#simulation.engine.reader.velocity(pointer, now, 0);
    let off = 0;
    let size = 1;
    for (let x = 0; x < SIDE; x++) {
      off += Math.abs(now[x]! - velocity[i * SIDE + x]!);
      size += Math.abs(now[x]!);
    }
    return off > SAME * size;
  }

  /** Out of a contact it had sunk into: Bullet moves a body for that without giving it a velocity. */
  #pushed(i: number, dt: number): boolean {
    const { velocity } = this.#system;
    const { pointer } = this.#jointed.bodies[i]!;
    this.#simulation.engine.reader.pose(pointer, this.#pose, 0);
    let off = 0;
    let size = 1;
    for (let x = 0; x < 3; x++) {
      const now = this.#pose[x]!;
      off += Math.abs(now - this.#jointed.place[i * 3 + x]! - dt * velocity[i * SIDE + x]!);
      size += Math.abs(now);
    }
    return off > SAME * size;
  }

  /** Where bodies are, to go back to. */
  save({ bodies }: Component): void {
    for (const i of bodies) this.#readPose(i, this.#saved, i * POSE);
  }

  restore({ bodies }: Component): void {
    const { scratch } = this.#simulation.engine;
    for (const i of bodies) {
      const saved = this.#saved;
      for (let x = 0; x < POSE; x++) this.#pose[x] = saved[i * POSE + x]!;
      for (let x = 0; x < 4; x++) this.#turn[x] = this.#pose[3 + x]!;
      this.#jointed.bodies[i]!.body.setCenterOfMassTransform(
        scratch.transform(this.#pose, this.#turn),
      );
    }
  }

  #readPose(i: number, out: Float64Array, at: number): void {
    const { pointer } = this.#jointed.bodies[i]!;
    this.#simulation.engine.reader.pose(pointer, out, at);
  }

  clearMomentum({ bodies }: Component): void {
    const { momentum } = this.#system;
    for (const i of bodies) momentum.fill(0, i * SIDE, (i + 1) * SIDE);
  }

  /** By the velocities found, taken as ways; where they turn a body far, by a share of them only: they are straight. */
  move({ bodies }: Component): void {
    const { velocity } = this.#system;
    let most = 0;
    for (const i of bodies)
      for (let x = i * SIDE + 3; x < (i + 1) * SIDE; x++)
        most = Math.max(most, Math.abs(velocity[x]!));
    const share = Math.min(1, FARTHEST / most);
    for (const i of bodies) this.#moveBody(i, this.#jointed.bodies[i]!, share);
  }

  #moveBody(i: number, { body, pointer }: Body, share: number): void {
    const { reader, scratch } = this.#simulation.engine;
    const { velocity } = this.#system;
    const v = i * SIDE;
    reader.pose(pointer, this.#pose, 0);
    for (let x = 0; x < 3; x++) {
      this.#pose[x]! += share * velocity[v + x]!;
      this.#displacement[x] = share * velocity[v + 3 + x]!;
    }
    writeTurn(this.#turn, this.#displacement, 1);
    multiply4(this.#turn, this.#turn, 0, this.#pose, 3);
    body.setCenterOfMassTransform(scratch.transform(this.#pose, this.#turn));
  }
}
