import { hypot } from '../../base/exact/index.js';
import { multiply4, writeTurn } from '../../base/flat-math.js';
import { rotate, type Quaternion } from '../../base/math.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { SIDE } from '../../solver/joints/blocks.js';
import type { Component } from '../../solver/joints/forest.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/**
 * What brings joints together that an edit tore apart. It is no motion: Bullet's step never sees it, so that nobody is struck
 * by it; bodies are put there after the step, and their spins turn with them, which keeps the energy.
 */
export class TornJoints {
  readonly #simulation: Simulation;
  readonly #system: RowSystem;
  readonly #jointed: JointedBodies;
  /** Velocities that would close the joints in the step. */
  #closing = new Float64Array(0);
  /** Where Bullet's step left the bodies. */
  #left = new Float64Array(0);
  readonly #pose = new Float64Array(POSE);
  readonly #velocity = new Float64Array(SIDE);
  readonly #spin = new Float64Array(3);
  readonly #turn = new Float64Array(4);
  readonly #back = new Float64Array(4);

  constructor(simulation: Simulation, system: RowSystem, jointed: JointedBodies) {
    this.#simulation = simulation;
    this.#system = system;
    this.#jointed = jointed;
  }

  take(bodies: number): void {
    if (this.#closing.length >= bodies * SIDE) return;
    this.#closing = new Float64Array(bodies * 2 * SIDE);
    this.#left = new Float64Array(bodies * 2 * POSE);
  }

  /** The velocities found would close the joints. */
  note({ bodies }: Component): void {
    const { velocity } = this.#system;
    for (const i of bodies)
      for (let x = i * SIDE; x < (i + 1) * SIDE; x++) this.#closing[x] = velocity[x]!;
  }

  /** Whether a body is put so far away by it that what it touches before is nothing that it meets. */
  leaves(i: number, dt: number): boolean {
    const { velocity } = this.#system;
    const at = i * SIDE;
    const [x, y, z] = [0, 1, 2].map((k) => this.#closing[at + k]! - velocity[at + k]!);
    return dt * hypot(x!, y!, z!) > this.#jointed.bodies[i]!.leastExtent / 2;
  }

  // ---- after Bullet's step ------------------------------------------------------------------------------------------

  /** It took the bodies along the velocities found since: the rest of the way. */
  close({ bodies }: Component, dt: number): void {
    for (const i of bodies) this.#move(i, dt);
  }

  #move(i: number, dt: number): void {
    const { reader, scratch } = this.#simulation.engine;
    const { body, pointer } = this.#jointed.bodies[i]!;
    const { velocity } = this.#system;
    const pose = this.#pose;
    const turn = this.#turn;
    const at = i * SIDE;
    reader.pose(pointer, pose, 0);
    this.#left.set(pose, i * POSE);
    for (let x = 0; x < 3; x++) pose[x]! += dt * (this.#closing[at + x]! - velocity[at + x]!);
    this.#writeTurn(this.#back, velocity, at, -dt);
    this.#writeTurn(turn, this.#closing, at, dt);
    multiply4(turn, turn, 0, this.#back, 0);
    multiply4(turn, turn, 0, pose, 3);
    body.setCenterOfMassTransform(scratch.transform(pose, turn));
  }

  #writeTurn(out: Float64Array, velocity: Float64Array, at: number, dt: number): void {
    for (let x = 0; x < 3; x++) this.#spin[x] = velocity[at + 3 + x]!;
    writeTurn(out, this.#spin, dt);
  }

  /** Once all is where it belongs. */
  turnSpins({ bodies }: Component): void {
    for (const i of bodies) if (this.#jointed.bodies[i]!.active) this.#turnSpin(i);
  }

  #turnSpin(i: number): void {
    const { engine, bodies } = this.#simulation;
    const node = this.#jointed.bodies[i]!;
    const pose = this.#pose;
    const v = this.#velocity;
    const back = this.#back;
    engine.reader.pose(node.pointer, pose, 0);
    for (let x = 0; x < 3; x++) back[x] = -this.#left[i * POSE + 3 + x]!;
    back[3] = this.#left[i * POSE + 6]!;
    multiply4(this.#turn, pose, 3, back, 0);
    engine.reader.velocity(node.pointer, v, 0);
    v.set(rotate([...this.#turn] as Quaternion, [v[3]!, v[4]!, v[5]!]), 3);
    engine.velocities.write(node.pointer, v, 0);
    bodies.readVelocity(node);
  }
}
