import { direction } from '../../effects/joints/axes.js';
import type { Stop } from '../../dynamics/joint.js';
import type { Vec3 } from '../../fields/types.js';
import { add, invert, scale, type Pose } from '../../base/math.js';
import {
  between,
  JointNode,
  LOCKED,
  type JointFrame,
  type Limit,
  type OwnCorrection,
} from './joint.js';

/** The row along the frame's x. */
const ALONG = 0;

/** Metres along the axis from which two bodies count as lying one behind the other. */
const APART = 1e-6;

/** Lets two bodies slide along one axis; neither turns against the other. */
export class SliderJointNode extends JointNode {
  /** Whether body1 moves against the axis when the bodies move apart. */
  mirrored = false;

  /** Between the centres of mass, where a force along the axis turns both bodies alike. */
  protected override wantedFrame(): JointFrame {
    const centres = [this.body1, this.body2].flatMap((body) => body?.centerOfMassWorld() ?? []);
    const moving = [this.body1, this.body2].flatMap((body) =>
      body?.movable ? [body.centerOfMassWorld()] : [],
    );
    const anchor =
      moving.length === 2
        ? scale(add(moving[0]!, moving[1]!), 0.5)
        : (moving[0] ?? (centres.slice(0, 3) as Vec3));
    return { anchor, axis: direction(this, 'axis') };
  }

  /** Bullet pushes at the point that its B carries: where only one body moves, that one does, at its centre. */
  protected override shouldSwap(): boolean {
    return !this.body2?.movable;
  }

  protected override get slides(): boolean {
    return true;
  }

  /** Apart is positive where the bodies lie one behind the other, else body1 along the axis is. */
  protected override zeroed(): void {
    const along = (frame: Pose): number => invert(frame).p[0];
    const offset = this.body1 && this.body2 ? along(this.frame2) - along(this.frame1) : 0;
    this.mirrored = offset > APART;
  }

  /** Of body1 against body2 along the axis. */
  get #limit(): Limit {
    const [low, high] = [this.asked<number>('minSeparation'), this.asked<number>('maxSeparation')];
    return this.mirrored && low <= high ? between(-high, -low) : between(low, high);
  }

  protected override linearLimits(): [Limit, Limit, Limit] {
    return [this.#limit, LOCKED, LOCKED];
  }

  protected override angularLimits(): [Limit, Limit, Limit] {
    return [LOCKED, LOCKED, LOCKED];
  }

  protected override correctionOf(row: number): OwnCorrection | undefined {
    return row === ALONG ? { erp: this.asked('stopErrorCorrection') } : undefined;
  }

  protected override wantedStops(): readonly Stop[] {
    const [low, high] = this.#limit;
    return this.stopAt({
      row: ALONG,
      low,
      high,
      bounce: this.asked('stopBounce'),
      correction: this.asked('stopErrorCorrection'),
      softness: 0,
      mirrored: this.mirrored,
      reason: 'minSeparation, maxSeparation',
    });
  }

  override get drivenBy(): string | undefined {
    return this.asked<number>('sliderForce') === 0 ? undefined : 'sliderForce';
  }

  /** The force along the axis, equal and opposite on one line, so that it turns nothing. */
  override push(dt: number): void {
    const { jointRows: rows } = this;
    if (this.drivenBy === undefined || !rows.read(this, dt)) return;
    rows.look(ALONG);
    rows.push(ALONG, this.#sign * this.asked<number>('sliderForce') * dt);
  }

  get #sign(): 1 | -1 {
    return this.mirrored ? -1 : 1;
  }

  /** Metres since the joint was made. */
  get separation(): number {
    return this.#sign * this.valueOf(ALONG);
  }

  /** m/s. */
  get separationRate(): number {
    return this.#sign * this.rateOf(ALONG);
  }
}
