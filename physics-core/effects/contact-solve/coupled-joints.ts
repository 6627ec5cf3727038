import { doublesOf, pack } from '../../base/packed.js';
import type { Numbered } from '../effect/effect.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Ahead, JointRows } from '../joints/joint-rows.js';
import type { JointSolve } from '../joints/joint-solve.js';
import type { Bound } from '../joints/bounded-rows.js';
import { R, rate, type BoundRows } from '../../solver/rows/bound-rows.js';
import type { Part } from '../../solver/part.js';
import type { TouchingBodies } from './touching-bodies.js';
import { MANY, ROW_STIFFNESS, ROW_STIFFNESS_OF_MANY } from '../../solver/tolerances.js';

/** Rows of a joint: six that may be locked, and as many bounds. */
const ROWS = 12;

/** Numbers of one row in `JointRows`. */
const WIDTH = 12;

interface KeptImpulses {
  step: number;
  values: Float64Array;
}

/**
 * The joints of what is in touch. The joint solve has found velocities at which they are whole after the step; contacts
 * change them, and the rows see to it that the rates found stay.
 */
export class CoupledJoints {
  #joints: JointRows | undefined;
  readonly #rows: BoundRows;
  readonly #bodies: TouchingBodies;
  /** Impulses by joint, and the step that found them. */
  readonly #impulses = new Map<Joint, KeptImpulses>();
  /** Of the joint whose rows are added or kept; undefined: there are none. */
  #kept: KeptImpulses | undefined;
  #keptOf: Joint | undefined;
  #step = 0;
  #stiffness = ROW_STIFFNESS;
  /** By row: its joint, and which of its rows. */
  readonly #owners: Joint[] = [];
  readonly #places: number[] = [];
  /** Its number among the six of the joint; -1: a bound. */
  readonly #numbers: number[] = [];

  constructor(rows: BoundRows, bodies: TouchingBodies) {
    this.#rows = rows;
    this.#bodies = bodies;
  }

  /** A new step: only impulses of the one before it are begun with. */
  begin(): void {
    this.#step++;
    this.#keptOf = undefined;
  }

  /** The rows of a joint, into those of its part. False: it gives way, and no row here does. */
  add(joint: Joint, solve: JointSolve, { bodies, rows: into }: Part): boolean {
    this.#stiffness = bodies.length > MANY ? ROW_STIFFNESS_OF_MANY : ROW_STIFFNESS;
    const { lockedRows, corrections, body1, body2 } = joint;
    const a = body1?.movable ? this.#bodies.numberOf(body1.pointer) : -1;
    const b = body2?.movable ? this.#bodies.numberOf(body2.pointer) : -1;
    this.#joints ??= solve.newRows();
    this.#joints.fillLocked(joint);
    this.#look(joint);
    let place = 0;
    for (const row of lockedRows) {
      if (corrections[row]!.softness > 0) return false;
      this.#add(joint, row, place++, a, b, into);
    }
    solve.eachBound(joint, (bound) => this.#addBound(joint, place++, a, b, bound, into));
    return true;
  }

  #addBound(
    joint: Joint,
    place: number,
    a: number,
    b: number,
    { row, least, most, impulse, target }: Bound,
    into: number[],
  ): void {
    this.#joints!.add(row);
    const at = this.#add(joint, row, place, a, b, into);
    this.#numbers[this.#rows.count - 1] = -1;
    const r = this.#rows.values;
    r[at + R.least] = Math.min(0, least - impulse);
    r[at + R.most] = Math.max(0, most - impulse);
    r[at + R.target] = target;
  }

  #add(joint: Joint, row: number, place: number, a: number, b: number, into: number[]): number {
    const rows = this.#rows;
    const joints = this.#joints!;
    const at = rows.add(a, b);
    const r = rows.values;
    const from = row * WIDTH;
    for (let k = 0; k < WIDTH; k++) r[at + k] = joints.jacobian[from + k]!;
    r[at + R.target] = rate(r, at, this.#bodies.free, a, b);
    r[at + R.penalty] = this.#stiffness / (joints.between(row, row) || 1);
    r[at + R.impulse] = this.#impulseOf(place);
    r[at + R.least] = -Infinity;
    r[at + R.most] = Infinity;
    into.push(rows.count - 1);
    this.#owners[rows.count - 1] = joint;
    this.#places[rows.count - 1] = place;
    this.#numbers[rows.count - 1] = row;
    return at;
  }

  /** The joint of a row, and its number among the six; -1: a bound. */
  ownerOf(row: number): Joint {
    return this.#owners[row]!;
  }

  numberOf(row: number): number {
    return this.#numbers[row]!;
  }

  /** The joints of a part are solved here. */
  tell({ rows }: Part, solve: JointSolve): void {
    let before: Joint | undefined;
    for (const i of rows) {
      const joint = this.ownerOf(i);
      if (joint !== before) solve.solvedInTouch((before = joint));
    }
  }

  /** Its rows where its bodies will be; only where they stand. */
  fillAhead(joint: Joint, ahead: Ahead): JointRows {
    this.#joints!.fillAhead(joint, ahead);
    return this.#joints!;
  }

  lookAhead(joint: Joint, ahead: Ahead): JointRows {
    this.#joints!.lookAhead(joint, ahead);
    return this.#joints!;
  }

  /** What a miss of a row costs, by the rows filled last. */
  penaltyOf(number: number): number {
    return this.#stiffness / (this.#joints!.between(number, number) || 1);
  }

  #look(joint: Joint): void {
    this.#keptOf = joint;
    this.#kept = this.#impulses.get(joint);
  }

  #impulseOf(place: number): number {
    const kept = this.#kept;
    return kept && kept.step === this.#step - 1 ? kept.values[place]! : 0;
  }

  /** For the next step. */
  keep(row: number): void {
    const joint = this.#owners[row]!;
    if (joint !== this.#keptOf) this.#look(joint);
    if (!this.#kept)
      this.#impulses.set(joint, (this.#kept = { step: 0, values: new Float64Array(ROWS) }));
    this.#kept.step = this.#step;
    this.#kept.values[this.#places[row]!] = this.#rows.values[row * R.size + R.impulse]!;
  }

  /** Of the last step, by the ids of joints. */
  save(): [id: number, impulses: string][] {
    return [...this.#impulses]
      .filter(([, { step }]) => step === this.#step)
      .map(([{ id }, { values }]) => [id, pack(values)]);
  }

  load(kept: readonly [id: number, impulses: string][], { joint }: Numbered): void {
    this.forgetAll();
    for (const [id, impulses] of kept) {
      const of = joint(id);
      if (of) this.#impulses.set(of, { step: this.#step, values: doublesOf(impulses) });
    }
  }

  forgetAll(): void {
    this.#impulses.clear();
    this.#keptOf = undefined;
  }

  /** A joint that is made anew begins anew. */
  forget(joint: Joint): void {
    this.#impulses.delete(joint);
    this.#keptOf = undefined;
  }
}
