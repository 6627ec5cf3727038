import { compose, identityPose, invert, type Pose } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Motor, RowCorrection, Spring, Stop } from '../../dynamics/joint.js';
import { leverRatio } from '../../effects/joints/joint-frames.js';
import { jointSolve } from '../../effects/joints/effects.js';
import { reportBodies, reportMassRatio } from '../../effects/joints/joint-reports.js';
import { areNear } from '../../effects/joints/near.js';
import { JointConstraint, type Side } from '../../engine/joint-constraint.js';
import type { Limit } from '../../engine/limits.js';
import type { BodyNode } from '../body/body.js';
import type { BodyJoint } from '../body/body-joint.js';
import { correctionAt, softnessInBullet, type OwnCorrection } from './joint-corrections.js';
import { PlacedJoint, UNMET, type JointRowsState, type JointZero } from './placed-joint.js';

export { between, FREE, LOCKED, type Limit } from '../../engine/limits.js';
export type { OwnCorrection } from './joint-corrections.js';
export type { JointFrame } from '../../effects/joints/joint-frames.js';

/** Lever arms that differ by less than this erp ask alike: rounding is not to decide. */
const ALIKE = 1e-3;

const ROW_NAMES = ['along x', 'along y', 'along z', 'about x', 'about y', 'about z'];
const ROWS = ROW_NAMES.length;

/**
 * A joint as one btGeneric6DofConstraint, the one constraint of Bullet 2.82 whose every row takes an error
 * correction. Angles and separations are zero at the poses the bodies have when the joint is made.
 */
export abstract class JointNode extends PlacedJoint implements BodyJoint {
  /** The joint's frame from each centre of mass, along its principal axes. */
  centred1: Pose = identityPose();
  centred2: Pose = identityPose();
  /** The rows that hold, as the 6-DoF numbers them: 0 to 2 along x, y, z; 3 to 5 about them. */
  lockedRows: readonly number[] = [];
  limits: readonly Limit[] = [];
  /** Per row: erp of the error repaired per step, and compliance, velocity per impulse. */
  readonly corrections: RowCorrection[] = [];
  stops: readonly Stop[] = [];
  motors: readonly Motor[] = [];
  spring: Spring | undefined;
  /** Just created: the first round of patches finds everything in place already. */
  protected fresh = false;
  readonly #softs: number[] = [];
  #constraint: JointConstraint | undefined;

  /** Linear then angular limits along the joint frame's axes. */
  protected abstract linearLimits(): [Limit, Limit, Limit];
  protected abstract angularLimits(): [Limit, Limit, Limit];

  /** Whether its bodies may move apart along an axis. */
  protected get slides(): boolean {
    return false;
  }

  // ---- life -----------------------------------------------------------------------------------------------------

  protected override create(): boolean {
    this.forgetZero();
    this.fresh = true;
    this.body1 = this.asked<BodyNode | null>('body1') ?? undefined;
    this.body2 = this.asked<BodyNode | null>('body2') ?? undefined;
    for (const body of [this.body1, this.body2]) body?.addJoint(this);
    reportBodies(this);
    this.attach();
    return true;
  }

  protected override created(): void {
    this.fresh = false;
  }

  protected override destroy(): void {
    this.detach();
    this.forgetZero();
    for (const body of [this.body1, this.body2]) body?.joints.delete(this);
    this.body1 = this.body2 = undefined;
    this.world.registry.unmade(this);
  }

  /** Not its body's fault, if it fails. */
  bodyReady(): void {
    if (this.built) this.world.failures.attempt(this, () => this.attach());
  }

  bodyGone(): void {
    this.detach();
  }

  /** The same joint at the same places of the bodies: after a change of mass or centre of mass. */
  reattach(): void {
    if (!this.#constraint) return;
    this.detach();
    this.attach();
  }

  massChanged(): void {
    if (this.#constraint && this.shouldSwap() !== this.#constraint.swapped) this.reattach();
    else this.updateCorrection();
  }

  get constraint(): JointConstraint | undefined {
    return this.#constraint;
  }

  /** Bullet's rows are to hold by themselves. */
  resetTargets(): void {
    this.#constraint?.setLimits(this.limits);
  }

  get attached(): boolean {
    return this.#constraint !== undefined;
  }

  attach(): void {
    if (this.#constraint || this.removed) return;
    const bodies = [this.body1, this.body2].filter((body) => body !== undefined);
    if (bodies.length === 0 || bodies[0] === bodies[1] || bodies.some((body) => !body.active))
      return;
    if (!this.zeroKnown) this.stops = [];
    this.takeZero();
    this.#constraint = this.#make();
    this.#setRows(this.#constraint);
    this.#constraint.add(this.id, this.slides);
    if (bodies.length === 2) this.#part(bodies[0]!, bodies[1]!);
    for (const body of bodies) body.wake();
    reportMassRatio(this);
    this.#changed();
  }

  detach(): void {
    if (!this.#constraint) return;
    this.#constraint.dispose();
    this.#constraint = undefined;
    this.wakeBodies();
    this.#changed();
  }

  /** From now on its bodies don't collide, and if they touch they let go of each other. */
  #part(a: BodyNode, b: BodyNode): void {
    if (areNear(this.world, a, b)) (a.movable ? a : b).presence.partContacts();
  }

  protected wakeBodies(): void {
    for (const body of [this.body1, this.body2]) body?.wake();
  }

  /** The constraint came or went, or its stops, motors or rows are others. */
  #changed(): void {
    this.body1?.motion.loadChanges();
    this.body2?.motion.loadChanges();
    this.stops = this.attached ? this.wantedStops() : [];
    this.motors = this.attached ? this.wantedMotors() : [];
    this.world.registry.jointChanged(this);
  }

  /** Stops and motors, of a joint that stands in the world. */
  protected wantedStops(): readonly Stop[] {
    return [];
  }

  protected wantedMotors(): readonly Motor[] {
    return [];
  }

  /** The one stop of a joint; where it stood stays known. */
  protected stopAt(fields: Omit<Stop, 'at'>): readonly Stop[] {
    return fields.low < fields.high ? [{ ...fields, at: this.stops[0]?.at }] : [];
  }

  get drivenBy(): string | undefined {
    return undefined;
  }

  push(_dt: number): void {}

  // ---- the constraint -----------------------------------------------------------------------------------------------

  /** Bullet's rows lie along body A's frame: A is the body whose lever arm asks for it. */
  protected shouldSwap(): boolean {
    const anchor = (body: BodyNode | undefined, frame: Pose): number =>
      body ? leverRatio(body, compose(body.pose(), frame).p) : -1;
    const first = anchor(this.body1, this.frame1);
    return anchor(this.body2, this.frame2) > first + Math.abs(first) * ALIKE;
  }

  #make(): JointConstraint {
    const side = (body: BodyNode | undefined, which: 1 | 2): Side =>
      body
        ? {
            body: body.body,
            frame: compose(invert(body.centerOfMass), which === 1 ? this.frame1 : this.frame2),
          }
        : { body: this.world.bullet.ground, frame: this.frameInBullet(which) };
    const sides = [side(this.body1, 1), side(this.body2, 2)] as const;
    [this.centred1, this.centred2] = [sides[0].frame, sides[1].frame];
    const swapped = this.kept?.rows?.swapped ?? this.shouldSwap();
    return new JointConstraint(this.world.bullet, ...sides, swapped);
  }

  // ---- limits and softness ------------------------------------------------------------------------------------------

  /** What its rows are is looked at before they are set. */
  protected chooseRows(): void {}

  #setRows(constraint: JointConstraint): void {
    this.#chooseRows();
    this.#setLimits(constraint);
    this.#setCorrections(constraint);
  }

  #chooseRows(): void {
    if (this.kept?.rows) this.spring = this.kept.rows.spring;
    else this.chooseRows();
  }

  #setLimits(constraint: JointConstraint): void {
    const limits = [...this.linearLimits(), ...this.angularLimits()];
    this.limits = limits;
    this.lockedRows = limits.flatMap(([low, high], row) => (low === high ? [row] : []));
    constraint.setLimits(limits);
  }

  /** Error correction and softness of every row. */
  #setCorrections(constraint: JointConstraint): void {
    const { solver } = this.world;
    const { jointRows } = this;
    jointRows.fill(this, solver.stepSeconds);
    const kept = this.kept?.rows?.corrections;
    for (let row = 0; row < ROWS; row++) {
      if (kept) {
        this.#correct(constraint, row, ...kept[row]!);
        continue;
      }
      const { erp, softness } = correctionAt(solver, this.correctionOf(row));
      const response = jointRows.between(row, row);
      const soft = softnessInBullet(softness, response, solver.stepSeconds);
      this.#correct(constraint, row, erp, soft * response, soft);
    }
  }

  #correct(constraint: JointConstraint, row: number, erp: number, softness: number, soft: number) {
    this.corrections[row] = { erp, softness };
    this.#softs[row] = soft;
    constraint.setCorrection(row, erp, soft);
  }

  /** For a snapshot. */
  save(): JointZero & { rows: JointRowsState } {
    const { frame1, frame2, spring, corrections } = this;
    return structuredClone({
      frame1,
      frame2,
      rows: {
        swapped: this.#constraint?.swapped ?? false,
        ...(spring && { spring }),
        corrections: corrections.map(({ erp, softness }, row) => [
          erp,
          softness,
          this.#softs[row]!,
        ]),
        stops: this.stops.map(({ at }) => at ?? UNMET),
      },
    });
  }

  /** Its limits, corrections, stops or motors are others. */
  updateRows(): void {
    if (this.fresh) return;
    if (this.#constraint) {
      this.#setRows(this.#constraint);
      this.wakeBodies();
    }
    this.#changed();
  }

  /** Only its motors are. */
  updateMotors(): void {
    if (this.fresh) return;
    this.wakeBodies();
    this.#changed();
  }

  /** The level or a mass changed: other rows may serve its fields now. */
  updateCorrection(): void {
    const constraint = this.#constraint;
    if (!constraint) return;
    const { spring } = this;
    this.#chooseRows();
    if (!spring !== !this.spring) this.#setLimits(constraint);
    this.#setCorrections(constraint);
    this.#changed();
  }

  /** Steps are of another length, for as long as something spins: its own softness may be another. */
  lengthenSteps(): void {
    if (this.#constraint && this.corrections.some(({ softness }) => softness > 0))
      this.updateCorrection();
  }

  /** Where a row has its own; undefined: the collection's. */
  protected correctionOf(_row: number): OwnCorrection | undefined {
    return undefined;
  }

  // ---- outputs ------------------------------------------------------------------------------------------------------

  /** Whether forceOutput asks for an output: only then is it sent along ROUTEs. Who reads one has asked. */
  outputs(name: string): boolean {
    const wanted = this.asked<string[]>('forceOutput');
    return wanted.includes('ALL') || wanted.includes(name);
  }

  /** Where a row stands now, metres or radians; 0 at the poses the joint was made at. */
  valueOf(row: number): number {
    return this.placed ? this.jointRows.valueOf(this, row) : 0;
  }

  /** Its rate, per second. */
  rateOf(row: number): number {
    const joints = this.world.registry.find(jointSolve);
    const shown = (body: Body) => joints?.velocityOf(body);
    return this.placed ? this.jointRows.rateOf(this, row, shown) : 0;
  }

  /** What Bullet has for it, as plain data. */
  get inBullet(): Record<string, unknown> | undefined {
    if (!this.attached) return undefined;
    const rows = this.limits.map(([low, high], row) => ({
      row: ROW_NAMES[row],
      holds: low > high ? 'nothing' : low < high ? [low, high] : low,
    }));
    const { p, q } = this.worldFrame(1);
    return { anchor: p, frame: q, gap: this.gap, rows };
  }
}
