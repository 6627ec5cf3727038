import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { lengthOf } from '../../base/exact/index.js';
import { factor, rowOf } from '../../base/cholesky.js';
import { BODY_BLOCK, INERTIA, SIDE } from '../../solver/joints/blocks.js';
import type { RowSystem } from '../../solver/joints/row-system.js';
import { RopeSolve } from '../../solver/ropes/rope-solve.js';
import { JoinedBodies } from '../../solver/ropes/joined-bodies.js';
import type { Ahead, Pull } from '../joints/component-solve.js';
import type { JointSolve } from '../joints/joint-solve.js';
import type { Held, Whole } from './held.js';
import type { Rope } from './rope.js';
import { AGREES, HIT, SAME } from './tolerances.js';

const BLOCK = SIDE * SIDE;
const now = new Float64Array(SIDE);
const tried = new Float64Array(BODY_BLOCK);

/** Ropes that hang together by the bodies they are tied to, and those bodies. */
export class TiedGroup {
  readonly ropes: readonly Rope[];
  readonly bodies: readonly Body[];
  /** What ties their points. */
  readonly held: readonly Held[];
  readonly solve = new RopeSolve();
  /** Those bodies that joints hold, by what hangs together. */
  readonly #joined: readonly { bodies: readonly Body[]; joined: JoinedBodies }[];
  /** As found, before anything else acted on the bodies. */
  readonly #found: Float64Array;
  readonly #resists: Float64Array;

  constructor(ropes: readonly Rope[], wholes: readonly Whole[], held: readonly Held[]) {
    const bodies = wholes.flatMap((whole) => whole.bodies);
    this.ropes = ropes;
    this.bodies = bodies;
    this.#joined = wholes
      .filter(({ jointed }) => jointed)
      .map(({ bodies: own }) => {
        return { bodies: own, joined: new JoinedBodies(bodies.indexOf(own[0]!), own.length) };
      });
    this.held = held;
    this.#found = new Float64Array(SIDE * bodies.length);
    this.#resists = new Float64Array(BODY_BLOCK * bodies.length);
    this.solve.take(
      ropes.map(({ strand }) => strand),
      bodies.length,
      this.#joined.map(({ joined }) => joined),
    );
  }

  /** Whether all of it rests. */
  get asleep(): boolean {
    for (const rope of this.ropes) if (!rope.asleep) return false;
    for (const body of this.bodies) if (!body.sleeping) return false;
    return true;
  }

  /** Before a step: what its bodies would do by themselves. */
  read(joints: JointSolve | undefined, dt: number, pull: Pull): void {
    this.bodies.forEach((body, b) => {
      const ahead = joints?.ahead(body, dt);
      if (ahead) this.#take(b, ahead);
    });
    for (const { bodies, joined } of this.#joined)
      joined.active = joints?.yields(bodies, dt, pull, joined) ?? false;
  }

  #take(b: number, { inertia, momentum, velocity, i }: Ahead): void {
    const { inertias, momenta, velocities } = this.solve.bodies;
    const at = BLOCK * b;
    const from = INERTIA * i;
    inertias.fill(0, at, at + BLOCK);
    for (let k = 0; k < 3; k++) inertias[at + (SIDE + 1) * k] = inertia[from]!;
    let n = from + 1;
    for (let r = 3; r < SIDE; r++)
      for (let c = 3; c <= r; c++) {
        inertias[at + SIDE * r + c] = inertia[n]!;
        inertias[at + SIDE * c + r] = inertia[n++]!;
      }
    for (let k = 0; k < SIDE; k++) {
      momenta[SIDE * b + k] = momentum[SIDE * i + k]!;
      velocities[SIDE * b + k] = velocity[SIDE * i + k]!;
    }
  }

  /** Whether joints, by what ropes give their bodies, would go other round ways than those that these were found by. */
  differs(joints: JointSolve | undefined, dt: number): boolean {
    let most = 0;
    for (const { bodies, joined } of this.#joined)
      if (joined.active)
        most = Math.max(most, joints!.yieldsBy(bodies[0]!, joined.impulse, dt, joined));
    return most > AGREES;
  }

  /** What was found, and what its ropes resist each body by: a symmetric block that half of its own inertia keeps positive. */
  note(): void {
    const { velocities, inertias } = this.solve.bodies;
    const { resistance } = this.solve;
    const resists = this.#resists;
    for (let i = 0; i < this.#found.length; i++) this.#found[i] = velocities[i]!;
    for (let b = 0; b < this.bodies.length; b++) {
      const at = BODY_BLOCK * b;
      const from = BLOCK * b;
      for (let r = 0; r < SIDE; r++)
        for (let c = 0; c <= r; c++) {
          const one = resistance[from + SIDE * r + c]!;
          const other = resistance[from + SIDE * c + r]!;
          resists[at + rowOf(r) + c] = (one + other) / 2;
          tried[rowOf(r) + c] = (one + other + inertias[from + SIDE * r + c]!) / 2;
        }
      if (!factor(tried, 0, SIDE)) resists.fill(0, at, at + BODY_BLOCK);
    }
  }

  /** What its ropes give a body, and resist it by, in the solve of what that hangs together with. */
  pullIn(body: Body, { resisting, momentum }: RowSystem, i: number): void {
    const b = this.bodies.indexOf(body);
    if (b < 0) return;
    const { impulse } = this.solve;
    const found = this.#found;
    const at = BODY_BLOCK * b;
    const block = resisting.get(i) ?? new Float64Array(BODY_BLOCK);
    for (let n = 0; n < BODY_BLOCK; n++) block[n]! += this.#resists[at + n]!;
    for (let r = 0; r < SIDE; r++) {
      let push = impulse[SIDE * b + r]!;
      for (let c = 0; c < SIDE; c++)
        push += this.#resists[at + (c <= r ? rowOf(r) + c : rowOf(c) + r)]! * found[SIDE * b + c]!;
      momentum[SIDE * i + r]! += push;
    }
    resisting.set(i, block);
  }

  /** Hits gave its bodies other velocities than were found: its ropes go on from those. */
  goOn(simulation: Simulation, dt: number): void {
    if (!this.#struck(simulation, dt)) return;
    const { inertias, momenta, velocities } = this.solve.bodies;
    this.bodies.forEach((body, b) => {
      const at = SIDE * b;
      simulation.engine.reader.velocity(body.pointer, now, 0);
      for (let r = 0; r < SIDE; r++) {
        velocities[at + r] = now[r]!;
        // It has what the ropes gave it before: they give all of it again.
        momenta[at + r] = -this.solve.impulse[at + r]!;
        for (let c = 0; c < SIDE; c++)
          momenta[at + r]! += inertias[BLOCK * b + SIDE * r + c]! * now[c]!;
      }
    });
    for (const { joined } of this.#joined)
      for (let r = 0; r < joined.width; r++)
        joined.free[r] = velocities[joined.from + r]! - joined.yield(r, joined.impulse);
    if (!this.solve.solve(dt)) return;
    this.note();
    this.bodies.forEach(({ pointer, joints }, b) => {
      if (joints.size === 0) simulation.engine.velocities.write(pointer, velocities, SIDE * b);
    });
  }

  /** What rubs or bears it is no hit: it acts by and by, and ropes answer in the next step. */
  #struck({ engine }: Simulation, dt: number): boolean {
    return this.bodies.some(({ pointer, appliedGravity }, b) => {
      engine.reader.velocity(pointer, now, 0);
      let off = 0;
      let size = 1;
      for (let k = 0; k < SIDE; k++) {
        off += Math.abs(now[k]! - this.#found[SIDE * b + k]!);
        size += Math.abs(now[k]!);
      }
      return off > SAME * size + HIT * dt * lengthOf(appliedGravity);
    });
  }
}
