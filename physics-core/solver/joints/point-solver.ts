import { SIDE } from './blocks.js';
import { ARMS, INVERSE_INERTIA, FACTORS, MASS, PARENT, PointFactors } from './point-factors.js';

/** Numbers of a pin that come of a load: the spin the child takes on with the point at rest, and the push on the parent. */
const LOADS = 6;
const PUSH = 3;

/**
 * Points that a body shares with its parent in the tree: those of joints that don't slide and are not soft. The general rows
 * can do that too, at three times the cost (measured). Here the velocity of the point takes the place of that of the child's
 * centre of mass: the parent tells it, and what is left to find is the child's spin.
 */
export class PointSolver {
  readonly factors = new PointFactors();
  /** Velocity that the child's point is to have against the parent's. */
  targetVelocity = new Float64Array(0);
  #loads = new Float64Array(0);

  grow(room: number): void {
    this.factors.grow(room);
    this.targetVelocity = new Float64Array(room * 3);
    this.#loads = new Float64Array(room * LOADS);
  }

  // ---- rows about axes ------------------------------------------------------------------------------------------------

  /** The child's velocity per impulse of a row that turns it, with the point held. */
  respond(pin: number, row: Float64Array, from: number, out: Float64Array, to: number): void {
    const { arms, numbers: f } = this.factors;
    const t = pin * FACTORS + INVERSE_INERTIA;
    const x = row[from + 3]!;
    const y = row[from + 4]!;
    const z = row[from + 5]!;
    const wx = f[t]! * x + f[t + 1]! * y + f[t + 3]! * z;
    const wy = f[t + 1]! * x + f[t + 2]! * y + f[t + 4]! * z;
    const wz = f[t + 3]! * x + f[t + 4]! * y + f[t + 5]! * z;
    const a = pin * ARMS;
    out[to] = arms[a + 1]! * wz - arms[a + 2]! * wy;
    out[to + 1] = arms[a + 2]! * wx - arms[a]! * wz;
    out[to + 2] = arms[a]! * wy - arms[a + 1]! * wx;
    out[to + 3] = wx;
    out[to + 4] = wy;
    out[to + 5] = wz;
  }

  /** The same row as the parent sees it, who takes the point along. */
  see(pin: number, row: Float64Array, from: number, out: Float64Array, to: number): void {
    const { arms, numbers: f } = this.factors;
    const g = pin * FACTORS;
    const x = row[from + 3]!;
    const y = row[from + 4]!;
    const z = row[from + 5]!;
    const hx = f[g]! * x + f[g + 3]! * y + f[g + 6]! * z;
    const hy = f[g + 1]! * x + f[g + 4]! * y + f[g + 7]! * z;
    const hz = f[g + 2]! * x + f[g + 5]! * y + f[g + 8]! * z;
    const a = pin * ARMS + PARENT;
    out[to] = -hx;
    out[to + 1] = -hy;
    out[to + 2] = -hz;
    out[to + 3] = -x - arms[a + 1]! * hz + arms[a + 2]! * hy;
    out[to + 4] = -y - arms[a + 2]! * hx + arms[a]! * hz;
    out[to + 5] = -z - arms[a]! * hy + arms[a + 1]! * hx;
  }

  /** What a row as `see` has it wants because of the velocity targetVelocity at the point. */
  wants(pin: number, seen: Float64Array, at: number): number {
    const { targetVelocity } = this;
    const w = pin * 3;
    return (
      seen[at]! * targetVelocity[w]! +
      seen[at + 1]! * targetVelocity[w + 1]! +
      seen[at + 2]! * targetVelocity[w + 2]!
    );
  }

  /** The impulse of a row is found: the pin pulls against it. */
  note(pin: number, seen: Float64Array, at: number, impulse: number): void {
    const s = pin * LOADS + PUSH;
    for (let x = 0; x < 3; x++) this.#loads[s + x]! += impulse * seen[at + x]!;
  }

  // ---- from the leaves: momenta ---------------------------------------------------------------------------------------

  /** What of the child's load the parent feels. */
  gather(pin: number, load: Float64Array, child: number, parent: number): void {
    const { targetVelocity } = this;
    const { arms, numbers: f } = this.factors;
    const s = this.#loads;
    const a = pin * ARMS;
    const g = pin * FACTORS;
    const p = child * SIDE;
    const to = pin * LOADS;
    const lx = load[p]!;
    const ly = load[p + 1]!;
    const lz = load[p + 2]!;
    const rx = arms[a]!;
    const ry = arms[a + 1]!;
    const rz = arms[a + 2]!;
    // The torque about the point.
    const x = load[p + 3]! - ry * lz + rz * ly;
    const y = load[p + 4]! - rz * lx + rx * lz;
    const z = load[p + 5]! - rx * ly + ry * lx;
    const t10 = f[g + INVERSE_INERTIA + 1]!;
    const t20 = f[g + INVERSE_INERTIA + 3]!;
    const t21 = f[g + INVERSE_INERTIA + 4]!;
    s[to] = f[g + INVERSE_INERTIA]! * x + t10 * y + t20 * z;
    s[to + 1] = t10 * x + f[g + INVERSE_INERTIA + 2]! * y + t21 * z;
    s[to + 2] = t20 * x + t21 * y + f[g + INVERSE_INERTIA + 5]! * z;
    const wx = targetVelocity[pin * 3]!;
    const wy = targetVelocity[pin * 3 + 1]!;
    const wz = targetVelocity[pin * 3 + 2]!;
    const m10 = f[g + MASS + 1]!;
    const m20 = f[g + MASS + 3]!;
    const m21 = f[g + MASS + 4]!;
    const px =
      lx - f[g]! * x - f[g + 3]! * y - f[g + 6]! * z - f[g + MASS]! * wx - m10 * wy - m20 * wz;
    const py =
      ly -
      f[g + 1]! * x -
      f[g + 4]! * y -
      f[g + 7]! * z -
      m10 * wx -
      f[g + MASS + 2]! * wy -
      m21 * wz;
    const pz =
      lz -
      f[g + 2]! * x -
      f[g + 5]! * y -
      f[g + 8]! * z -
      m20 * wx -
      m21 * wy -
      f[g + MASS + 5]! * wz;
    s[to + PUSH] = px;
    s[to + PUSH + 1] = py;
    s[to + PUSH + 2] = pz;
    if (parent < 0) return;
    const qx = arms[a + PARENT]!;
    const qy = arms[a + PARENT + 1]!;
    const qz = arms[a + PARENT + 2]!;
    const o = parent * SIDE;
    load[o]! += px;
    load[o + 1]! += py;
    load[o + 2]! += pz;
    load[o + 3]! += qy * pz - qz * py;
    load[o + 4]! += qz * px - qx * pz;
    load[o + 5]! += qx * py - qy * px;
  }

  // ---- from the root: velocities --------------------------------------------------------------------------------------

  /** The child's velocity: that of the parent is known. */
  release(pin: number, velocity: Float64Array, child: number, parent: number): void {
    const { targetVelocity } = this;
    const { arms, numbers: f } = this.factors;
    const a = pin * ARMS;
    const g = pin * FACTORS;
    let x = targetVelocity[pin * 3]!;
    let y = targetVelocity[pin * 3 + 1]!;
    let z = targetVelocity[pin * 3 + 2]!;
    if (parent >= 0) {
      const o = parent * SIDE;
      const qx = arms[a + PARENT]!;
      const qy = arms[a + PARENT + 1]!;
      const qz = arms[a + PARENT + 2]!;
      const wx = velocity[o + 3]!;
      const wy = velocity[o + 4]!;
      const wz = velocity[o + 5]!;
      x += velocity[o]! + wy * qz - wz * qy;
      y += velocity[o + 1]! + wz * qx - wx * qz;
      z += velocity[o + 2]! + wx * qy - wy * qx;
    }
    const s = pin * LOADS;
    const wx = this.#loads[s]! - f[g]! * x - f[g + 1]! * y - f[g + 2]! * z;
    const wy = this.#loads[s + 1]! - f[g + 3]! * x - f[g + 4]! * y - f[g + 5]! * z;
    const wz = this.#loads[s + 2]! - f[g + 6]! * x - f[g + 7]! * y - f[g + 8]! * z;
    const rx = arms[a]!;
    const ry = arms[a + 1]!;
    const rz = arms[a + 2]!;
    const v = child * SIDE;
    velocity[v] = x - wy * rz + wz * ry;
    velocity[v + 1] = y - wz * rx + wx * rz;
    velocity[v + 2] = z - wx * ry + wy * rx;
    velocity[v + 3] = wx;
    velocity[v + 4] = wy;
    velocity[v + 5] = wz;
  }

  /** The impulse on the child, once the velocities are found: times `sign`, into three numbers from `out[at]` on. */
  pull(
    pin: number,
    velocity: Float64Array,
    parent: number,
    out: Float64Array,
    at: number,
    sign: number,
  ): void {
    const { arms, numbers: f } = this.factors;
    const s = pin * LOADS + PUSH;
    out[at] = -sign * this.#loads[s]!;
    out[at + 1] = -sign * this.#loads[s + 1]!;
    out[at + 2] = -sign * this.#loads[s + 2]!;
    if (parent < 0) return;
    const a = pin * ARMS + PARENT;
    const g = pin * FACTORS + MASS;
    const o = parent * SIDE;
    const wx = velocity[o + 3]!;
    const wy = velocity[o + 4]!;
    const wz = velocity[o + 5]!;
    const x = velocity[o]! + wy * arms[a + 2]! - wz * arms[a + 1]!;
    const y = velocity[o + 1]! + wz * arms[a]! - wx * arms[a + 2]!;
    const z = velocity[o + 2]! + wx * arms[a + 1]! - wy * arms[a]!;
    out[at]! += sign * (f[g]! * x + f[g + 1]! * y + f[g + 3]! * z);
    out[at + 1]! += sign * (f[g + 1]! * x + f[g + 2]! * y + f[g + 4]! * z);
    out[at + 2]! += sign * (f[g + 3]! * x + f[g + 4]! * y + f[g + 5]! * z);
  }
}
