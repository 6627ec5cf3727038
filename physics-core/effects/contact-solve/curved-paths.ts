import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Ammo } from '../../engine/ammo.js';
import { readVelocity } from '../../engine/heap.js';
import { isCarried } from '../../engine/solver-body.js';
import type { Ahead, JointRows } from '../joints/joint-rows.js';
import { R, rate, type BoundRows } from '../../solver/rows/bound-rows.js';
import type { ConeContacts } from '../../solver/rows/cone-contacts.js';
import type { CoupledJoints } from './coupled-joints.js';
import type { Part } from '../../solver/part.js';
import { ProximalMasses } from '../../solver/methods/proximal-masses.js';
import type { TouchingBodies } from './touching-bodies.js';
import { SolveState } from '../../solver/methods/solve-state.js';
import { SIZE } from '../../solver/matrix/block-cholesky.js';
import {
  CLOSED,
  CURVED_MATRICES,
  CURVED_ROUNDS,
  CURVED_SLOW,
  FIRST_MISS,
  HALVES,
  HELD_BACK,
  HELD_BACK_MORE,
  LEFT_OPEN,
  MOST_HELD_BACK,
} from '../../solver/tolerances.js';

/** Solves by straight rows. */
interface Straight {
  /** False: no end, or none with so many matrices. */
  solve(part: Part, matrices?: number): boolean;
  readonly used: number;
}

/**
 * Holds joints that close loops where contacts turn their bodies far. Rows are straight: at a net that is taut, and at a
 * chain between two posts, they let all go aside that goes aside, and the joints would have to be brought together after the
 * step, which moves the net and not what lies on it: it falls through. So rows are laid anew where the velocities found lead
 * to, and the part is solved again, until it ends where its joints are whole (sequential linearisation, damped after
 * Levenberg and Marquardt).
 */
export class CurvedPaths implements Ahead {
  dt = 0;
  readonly #ammo: Ammo;
  readonly #rows: BoundRows;
  readonly #bodies: TouchingBodies;
  readonly #joints: CoupledJoints;
  readonly #masses: ProximalMasses;
  readonly #state: SolveState;
  /** How far bodies were pushed apart before the step takes them on. */
  #apart = false;
  readonly #arm = new Float64Array(3);
  readonly #pull = new Float64Array(3);

  constructor(
    ammo: Ammo,
    contacts: ConeContacts,
    rows: BoundRows,
    bodies: TouchingBodies,
    joints: CoupledJoints,
  ) {
    this.#ammo = ammo;
    this.#rows = rows;
    this.#bodies = bodies;
    this.#joints = joints;
    this.#masses = new ProximalMasses(bodies);
    this.#state = new SolveState(contacts, rows, bodies);
  }

  /** By a solver that begins with the velocities and impulses that there are. False: it finds no end. */
  solve(part: Part, dt: number, straight: Straight): boolean {
    if (!part.looped) return straight.solve(part);
    this.dt = dt;
    this.#state.keep(part);
    if (straight.solve(part) && this.#miss(part) < LEFT_OPEN) return true;
    // Velocities that straight rows lead to may be far off; with the pulls of the last step one round mostly is enough.
    this.#state.putBack(part);
    part.curved = true;
    return this.#search(part, straight);
  }

  #search(part: Part, straight: Straight): boolean {
    let any = false;
    let give = 0;
    let before = Infinity;
    let matrices = CURVED_MATRICES;
    for (let round = 0; round < CURVED_ROUNDS && give < MOST_HELD_BACK && matrices > 0; round++) {
      this.#state.keep(part);
      const found = this.#solveOnce(part, give, matrices, straight);
      matrices -= straight.used;
      any ||= found;
      const miss = found ? this.#miss(part) : Infinity;
      if (miss < CLOSED || (miss < LEFT_OPEN && miss > CURVED_SLOW * before)) break;
      if (miss > Math.max(before, FIRST_MISS)) {
        this.#state.putBack(part);
        give = Math.max(HELD_BACK, HELD_BACK_MORE * give);
      } else {
        give = give > HELD_BACK ? give / HELD_BACK_MORE : 0;
        before = miss;
      }
    }
    return any;
  }

  #solveOnce(part: Part, give: number, matrices: number, straight: Straight): boolean {
    const masses = this.#masses;
    masses.begin(part.bodies);
    this.#layRows(part);
    this.#readPulls(part);
    masses.apply(part.bodies, this.dt, give);
    const found = straight.solve(part, matrices);
    masses.end(part.bodies);
    return found;
  }

  // ---- where the step leads -------------------------------------------------------------------------------------------

  readVelocity(body: Body, out: Float64Array): void {
    const i = body.movable ? this.#bodies.numberOf(body.pointer) : -1;
    if (i >= 0) this.#read(this.#bodies.velocities, i, out);
    else if (isCarried(this.#ammo, body.pointer)) readVelocity(this.#ammo, body.pointer, out, 0);
    else out.fill(0);
  }

  readDisplacement(body: Body, out: Float64Array): boolean {
    const i = this.#apart && body.movable ? this.#bodies.numberOf(body.pointer) : -1;
    if (i >= 0) this.#read(this.#bodies.change, i, out);
    return i >= 0;
  }

  #read(from: Float64Array, body: number, out: Float64Array): void {
    for (let k = 0; k < SIZE; k++) out[k] = from[body * SIZE + k]!;
  }

  /** By how much a joint misses, at most, m or rad. */
  #miss({ rows }: Part): number {
    let worst = 0;
    let joint: Joint | undefined;
    let values!: Float64Array;
    for (const i of rows) {
      const number = this.#joints.numberOf(i);
      if (number < 0) continue;
      const owner = this.#joints.ownerOf(i);
      if (owner !== joint) ({ values } = this.#joints.lookAhead((joint = owner), this));
      const miss = Math.abs(missOf(values, number, owner));
      if (!(miss <= worst)) worst = miss;
    }
    return Number.isNaN(worst) ? Infinity : worst;
  }

  // ---- a round --------------------------------------------------------------------------------------------------------

  /** As they are at the end of the step, aiming at where joints are whole. */
  #layRows({ rows }: Part): void {
    const { values: r, a, b } = this.#rows;
    let joint: Joint | undefined;
    let ahead!: JointRows;
    for (const i of rows) {
      const number = this.#joints.numberOf(i);
      if (number < 0) continue;
      const owner = this.#joints.ownerOf(i);
      if (owner !== joint) ahead = this.#joints.fillAhead((joint = owner), this);
      const at = i * R.size;
      for (let k = 0; k < 2 * SIZE; k++) r[at + k] = ahead.jacobian[number * 2 * SIZE + k]!;
      const now = rate(r, at, this.#bodies.velocities, a[i]!, b[i]!);
      r[at + R.target] = now - missOf(ahead.values, number, owner) / this.dt;
      r[at + R.penalty] = this.#joints.penaltyOf(number);
    }
  }

  /** What joints pull by, as far as that is known. */
  #readPulls(part: Part): void {
    const { values: r, a, b } = this.#rows;
    const pull = this.#pull;
    const { rows } = part;
    for (let j = 0; j < rows.length;) {
      const joint = this.#joints.ownerOf(rows[j]!);
      const i = rows[j]!;
      pull.fill(0);
      for (; j < rows.length && this.#joints.ownerOf(rows[j]!) === joint; j++) {
        const at = rows[j]! * R.size;
        for (let x = 0; x < 3; x++) pull[x]! += r[at + x]! * r[at + R.impulse]!;
      }
      if (pull[0] === 0 && pull[1] === 0 && pull[2] === 0) continue;
      const ahead = this.#joints.fillAhead(joint, this);
      if (a[i]! >= 0) this.#pullAt(a[i]!, ahead, 1);
      if (b[i]! >= 0) this.#pullAt(b[i]!, ahead, 2);
    }
  }

  #pullAt(body: number, rows: JointRows, which: 1 | 2): void {
    rows.readArm(which, this.#arm);
    this.#masses.pull(body, this.#arm, this.#pull, which === 1 ? 1 : -1);
  }

  // ---- overlaps -------------------------------------------------------------------------------------------------------

  /** How bodies are pushed apart (`change`), too, goes only as far as joints stay whole. */
  limitApart(part: Part): void {
    if (!part.looped) return;
    const most = Math.max(FIRST_MISS, this.#miss(part));
    this.#apart = true;
    for (let i = 1; i <= HALVES && this.#miss(part) > most; i++)
      this.#shorten(part, i < HALVES ? 0.5 : 0);
    this.#apart = false;
  }

  #shorten({ bodies }: Part, share: number): void {
    const { change } = this.#bodies;
    for (const body of bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) change[k]! *= share;
  }
}

const missOf = (values: Float64Array, number: number, joint: Joint): number =>
  values[number]! - joint.limits[number]![0];
