import type { Ammo } from './ammo.js';
import type { BtConstraint } from './bullet-world.js';
import type { BtBody } from './heap.js';
import { CONSTRAINT_PARAM, SIX_DOF } from './offsets.js';
import { FREE, LOCKED, type Limit } from './limits.js';
import { Owner } from './owner.js';
import { compose, identityPose, quaternionOf, type Pose } from '../base/math.js';
import type { BulletWorld } from './bullet-world.js';

type SixDof = Ammo['btGeneric6DofConstraint']['prototype'];

/** The same limit seen from the other body. */
const flipped = (limit: Limit): Limit =>
  limit === FREE || limit === LOCKED ? limit : [-limit[1], -limit[0]];

/** The row about what is at right angles to z of frame 1 and x of frame 2. */
const MIDDLE = 4;

/** One side of a joint: its body, and the joint's frame from that body's centre of mass. */
export interface Side {
  body: BtBody;
  frame: Pose;
}

/**
 * The btGeneric6DofConstraint behind a joint, in the world as long as it lives. Rows are numbered as Bullet has them: 0
 * to 2 along x, y, z of the frame, 3 to 5 about them.
 */
export class JointConstraint {
  /** Whether body2 is Bullet's A, along whose frame the rows lie. */
  readonly swapped: boolean;
  /** Whether both bodies are pushed at one point; else each where its own frame is. */
  atOnePoint = false;
  readonly #world: BulletWorld;
  readonly #owner: Owner;
  readonly #bullet: SixDof;
  readonly #frameA: Pose;
  readonly pointer: number;
  #released = false;
  /** What Bullet's value of a row lacks of its own. */
  readonly #shifts = new Float64Array(6);

  constructor(world: BulletWorld, side1: Side, side2: Side, swapped: boolean) {
    const { ammo, scratch } = world.engine;
    const [a, b] = swapped ? [side2, side1] : [side1, side2];
    this.#world = world;
    this.#owner = new Owner(ammo);
    this.#frameA = a.frame;
    this.swapped = swapped;
    this.#bullet = this.#owner.own(
      new ammo.btGeneric6DofConstraint(
        a.body,
        b.body,
        scratch.transform(a.frame.p, a.frame.q, 0),
        scratch.transform(b.frame.p, b.frame.q, 1),
        true,
      ),
    );
    this.pointer = ammo.getPointer(this.#bullet);
  }

  /** Into the world, by the number of its node. `slides`: its bodies may move apart. */
  add(id: number, slides: boolean): void {
    this.atOnePoint = slides;
    if (slides) this.#pushAtOnePoint();
    this.#world.addConstraint(this.#bullet as BtConstraint, id);
  }

  /**
   * It would push each body at its own frame, and two forces that are not on one line turn a pair that has slid apart faster
   * and faster (measured).
   */
  #pushAtOnePoint(): void {
    this.#world.engine.ammo.HEAPU8[this.pointer + SIX_DOF.useOffsetForConstraintFrame] = 0;
  }

  dispose(): void {
    this.#world.removeConstraint(this.#bullet as BtConstraint);
    this.#owner.dispose();
  }

  /** Of all six rows. Bullet's angles are of A against B, its distances of B against A. */
  setLimits(limits: readonly Limit[]): void {
    const { scratch } = this.#world.engine;
    this.#released = false;
    const held = this.#lockAtZero(limits);
    const seen = held.map((limit, row) => (row < 3 === this.swapped ? limit : flipped(limit)));
    const bound = (from: number, end: 0 | 1) =>
      scratch.vector(seen[from]![end], seen[from + 1]![end], seen[from + 2]![end]);
    this.#bullet.setLinearLowerLimit(bound(0, 0));
    this.#bullet.setLinearUpperLimit(bound(0, 1));
    this.#bullet.setAngularLowerLimit(bound(3, 0));
    this.#bullet.setAngularUpperLimit(bound(3, 1));
  }

  /**
   * A row that is locked elsewhere than at 0 gets its zero there: locked at any other number, Bullet lets it go
   * whenever it stands there exactly (measured). Not the middle angle, whose frame tells the other two.
   */
  #lockAtZero(limits: readonly Limit[]): Limit[] {
    const shift = identityPose();
    this.#shifts.fill(0);
    const held = limits.map((limit, row) => {
      if (limit[0] !== limit[1] || limit === LOCKED || row === MIDDLE) return limit;
      const by = this.swapped ? limit[0] : -limit[0];
      this.#shifts[row] = row < 3 ? by : -by;
      if (row < 3) shift.p[row] = by;
      else shift.q = quaternionOf([+(row === 3), 0, +(row === 5), by]);
      return LOCKED;
    });
    const { p, q } = compose(this.#frameA, shift);
    const { scratch } = this.#world.engine;
    const frame = this.#bullet.getFrameOffsetA();
    frame.setOrigin(scratch.vector(...p));
    frame.setRotation(scratch.quaternion(q));
    return held;
  }

  /** Asks a locked row to stand elsewhere after the step: Bullet's distances are of B against A, its angles of A. */
  setTarget(row: number, value: number): void {
    this.#released = false;
    const shifted = row === MIDDLE ? value : value - this.#shifts[row]!;
    const target = shifted || LOCKED[0];
    this.#setRow(row, target, target);
  }

  /** Bounds that cross leave it free. */
  #setRow(row: number, lower: number, upper: number): void {
    const heap = this.#world.engine.ammo.HEAPF32;
    if (row < 3) {
      heap[((this.pointer + SIX_DOF.linearLower) >> 2) + row] = lower;
      heap[((this.pointer + SIX_DOF.linearUpper) >> 2) + row] = upper;
      return;
    }
    const at = (this.pointer + SIX_DOF.angularLower + (row - 3) * SIX_DOF.angularSize) >> 2;
    heap[at] = lower;
    heap[at + 1] = upper;
  }

  /** Lets go of locked rows until they are told a target or limits. */
  release(rows: readonly number[]): void {
    if (this.#released) return;
    this.#released = true;
    this.#free(rows);
  }

  /** Lets go of rows with stops until they are told limits. */
  releaseStops(rows: readonly number[]): void {
    this.#free(rows);
  }

  #free(rows: readonly number[]): void {
    for (const row of rows) this.#setRow(row, ...FREE);
  }

  /** Share of a row's error repaired per step, and its softness in Bullet's own terms. */
  setCorrection(row: number, erp: number, softness: number): void {
    this.#bullet.setParam(CONSTRAINT_PARAM.stopErp, erp, row);
    this.#bullet.setParam(CONSTRAINT_PARAM.stopCfm, softness, row);
  }
}
