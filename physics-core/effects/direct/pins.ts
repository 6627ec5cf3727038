import { BODY_BLOCK, SIDE } from './blocks.js';

/** Numbers of a pin that stand while its factors do. */
const FACTORS = 21;
/** Of these: the spin that the child takes on per speed of the point, per torque about it, and the mass it has there. */
const GIVE = 0;
const EASE = 9;
const MASS = 15;

/** Numbers of a pin that come of a load: the spin the child takes on with the point at rest, and the push on the parent. */
const LOADS = 6;
const PUSH = 3;

const ARMS = 6;
const PARENT = 3;

/**
 * Points that a body shares with its parent in the tree: ball joints without softness. The general rows can do that too, at
 * three times the cost (measured). Here the velocity of the point takes the place of that of the child's centre of mass:
 * the parent tells it, and what is left to find is the child's spin.
 */
export class Pins {
  /** From the centre of mass of child and parent to the point. */
  arms = new Float64Array(0);
  /** Velocity that the child's point is to have against the parent's. */
  wanted = new Float64Array(0);
  #factors = new Float64Array(0);
  #loads = new Float64Array(0);
  /** How spin and the speed of the point go together in the child, and its inertia about the point. */
  readonly #couple = new Float64Array(9);
  readonly #about = new Float64Array(6);

  grow(room: number): void {
    this.arms = new Float64Array(room * ARMS);
    this.wanted = new Float64Array(room * 3);
    this.#factors = new Float64Array(room * FACTORS);
    this.#loads = new Float64Array(room * LOADS);
  }

  // ---- from the leaves: inertia ---------------------------------------------------------------------------------------

  /**
   * Takes a child's inertia, a triangle of `bodies`, to the point, and what of it the parent feels on to the parent (-1:
   * the world). False: it is none.
   */
  factor(pin: number, bodies: Float64Array, child: number, parent: number): boolean {
    this.#seeFromPoint(pin, bodies, child * BODY_BLOCK);
    if (!this.#letTurn(pin * FACTORS + EASE)) return false;
    this.#give(pin * FACTORS, bodies, child * BODY_BLOCK);
    if (parent >= 0) this.#loadParent(pin, bodies, parent * BODY_BLOCK);
    return true;
  }

  #seeFromPoint(pin: number, m: Float64Array, b: number): void {
    const { arms } = this;
    const c = this.#couple;
    const x = arms[pin * ARMS]!;
    const y = arms[pin * ARMS + 1]!;
    const z = arms[pin * ARMS + 2]!;
    const b00 = m[b + 6]!;
    const b01 = m[b + 7]!;
    const b02 = m[b + 8]!;
    const b10 = m[b + 10]!;
    const b11 = m[b + 11]!;
    const b12 = m[b + 12]!;
    const b20 = m[b + 15]!;
    const b21 = m[b + 16]!;
    const v00 = m[b]!;
    const v10 = m[b + 1]!;
    const v11 = m[b + 2]!;
    const v20 = m[b + 3]!;
    const v21 = m[b + 4]!;
    const v22 = m[b + 5]!;
    const c01 = b01 + z * v11 - y * v21;
    const c02 = b02 + z * v21 - y * v22;
    const c10 = b10 - z * v00 + x * v20;
    const c11 = b11 - z * v10 + x * v21;
    const c12 = b12 - z * v20 + x * v22;
    const c20 = b20 + y * v00 - x * v10;
    const c21 = b21 + y * v10 - x * v11;
    const c22 = m[b + 17]! + y * v20 - x * v21;
    c[0] = b00 + z * v10 - y * v20;
    c[1] = c01;
    c[2] = c02;
    c[3] = c10;
    c[4] = c11;
    c[5] = c12;
    c[6] = c20;
    c[7] = c21;
    c[8] = c22;
    const n = this.#about;
    n[0] = m[b + 9]! + z * (c01 + b01) - y * (c02 + b02);
    n[1] = m[b + 13]! + z * (c11 - b00) - y * c12 + x * b02;
    n[2] = m[b + 14]! + x * (c12 + b12) - z * (c10 + b10);
    n[3] = m[b + 18]! + z * c21 - y * (c22 - b00) - x * b01;
    n[4] = m[b + 19]! - z * c20 + x * (c22 - b11) + y * b10;
    n[5] = m[b + 20]! + y * (c20 + b20) - x * (c21 + b21);
  }

  /** The inverse of the inertia about the point. */
  #letTurn(at: number): boolean {
    const n = this.#about;
    const f = this.#factors;
    const d0 = n[0]!;
    const l10 = n[1]! / d0;
    const l20 = n[3]! / d0;
    const d1 = n[2]! - l10 * n[1]!;
    const s = n[4]! - l20 * n[1]!;
    const l21 = s / d1;
    const d2 = n[5]! - l20 * n[3]! - l21 * s;
    if (!(d0 > 0 && d1 > 0 && d2 > 0)) return false;
    const k = l10 * l21 - l20;
    const t22 = 1 / d2;
    const t21 = -l21 * t22;
    const t20 = k * t22;
    const e1 = 1 / d1;
    f[at] = 1 / d0 + l10 * l10 * e1 + k * t20;
    f[at + 1] = -l10 * e1 - l21 * t20;
    f[at + 2] = e1 - l21 * t21;
    f[at + 3] = t20;
    f[at + 4] = t21;
    f[at + 5] = t22;
    return true;
  }

  #give(at: number, m: Float64Array, b: number): void {
    const f = this.#factors;
    const c = this.#couple;
    const t00 = f[at + EASE]!;
    const t10 = f[at + EASE + 1]!;
    const t11 = f[at + EASE + 2]!;
    const t20 = f[at + EASE + 3]!;
    const t21 = f[at + EASE + 4]!;
    const t22 = f[at + EASE + 5]!;
    for (let j = 0; j < 3; j++) {
      const c0 = c[j]!;
      const c1 = c[3 + j]!;
      const c2 = c[6 + j]!;
      const g0 = t00 * c0 + t10 * c1 + t20 * c2;
      const g1 = t10 * c0 + t11 * c1 + t21 * c2;
      const g2 = t20 * c0 + t21 * c1 + t22 * c2;
      f[at + GIVE + j] = g0;
      f[at + GIVE + 3 + j] = g1;
      f[at + GIVE + 6 + j] = g2;
      const row = (j * (j + 1)) >> 1;
      for (let i = 0; i <= j; i++)
        f[at + MASS + row + i] = m[b + row + i]! - c[i]! * g0 - c[3 + i]! * g1 - c[6 + i]! * g2;
    }
  }

  #loadParent(pin: number, m: Float64Array, b: number): void {
    const { arms } = this;
    const f = this.#factors;
    const at = pin * FACTORS + MASS;
    const x = arms[pin * ARMS + PARENT]!;
    const y = arms[pin * ARMS + PARENT + 1]!;
    const z = arms[pin * ARMS + PARENT + 2]!;
    const a00 = f[at]!;
    const a10 = f[at + 1]!;
    const a11 = f[at + 2]!;
    const a20 = f[at + 3]!;
    const a21 = f[at + 4]!;
    const a22 = f[at + 5]!;
    const d00 = y * a20 - z * a10;
    const d01 = y * a21 - z * a11;
    const d02 = y * a22 - z * a21;
    const d10 = z * a00 - x * a20;
    const d11 = z * a10 - x * a21;
    const d12 = z * a20 - x * a22;
    const d20 = x * a10 - y * a00;
    const d21 = x * a11 - y * a10;
    const d22 = x * a21 - y * a20;
    m[b]! += a00;
    m[b + 1]! += a10;
    m[b + 2]! += a11;
    m[b + 3]! += a20;
    m[b + 4]! += a21;
    m[b + 5]! += a22;
    m[b + 6]! += d00;
    m[b + 7]! += d01;
    m[b + 8]! += d02;
    m[b + 9]! += y * d02 - z * d01;
    m[b + 10]! += d10;
    m[b + 11]! += d11;
    m[b + 12]! += d12;
    m[b + 13]! += y * d12 - z * d11;
    m[b + 14]! += z * d10 - x * d12;
    m[b + 15]! += d20;
    m[b + 16]! += d21;
    m[b + 17]! += d22;
    m[b + 18]! += y * d22 - z * d21;
    m[b + 19]! += z * d20 - x * d22;
    m[b + 20]! += x * d21 - y * d20;
  }

  // ---- rows about axes ------------------------------------------------------------------------------------------------

  /** The child's velocity per impulse of a row that turns it, with the point held. */
  respond(pin: number, row: Float64Array, from: number, out: Float64Array, to: number): void {
    const { arms } = this;
    const f = this.#factors;
    const t = pin * FACTORS + EASE;
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
    const { arms } = this;
    const f = this.#factors;
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

  /** What a row as `see` has it wants because of the velocity wanted at the point. */
  wants(pin: number, seen: Float64Array, at: number): number {
    const { wanted } = this;
    const w = pin * 3;
    return seen[at]! * wanted[w]! + seen[at + 1]! * wanted[w + 1]! + seen[at + 2]! * wanted[w + 2]!;
  }

  /** The impulse of a row is found: the pin pulls against it. */
  note(pin: number, seen: Float64Array, at: number, impulse: number): void {
    const s = pin * LOADS + PUSH;
    for (let x = 0; x < 3; x++) this.#loads[s + x]! += impulse * seen[at + x]!;
  }

  // ---- from the leaves: momenta ---------------------------------------------------------------------------------------

  /** What of the child's load the parent feels. `share` 0 leaves the wanted velocities out. */
  gather(pin: number, load: Float64Array, child: number, parent: number, share: 0 | 1): void {
    const { arms, wanted } = this;
    const f = this.#factors;
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
    const t10 = f[g + EASE + 1]!;
    const t20 = f[g + EASE + 3]!;
    const t21 = f[g + EASE + 4]!;
    s[to] = f[g + EASE]! * x + t10 * y + t20 * z;
    s[to + 1] = t10 * x + f[g + EASE + 2]! * y + t21 * z;
    s[to + 2] = t20 * x + t21 * y + f[g + EASE + 5]! * z;
    const wx = share * wanted[pin * 3]!;
    const wy = share * wanted[pin * 3 + 1]!;
    const wz = share * wanted[pin * 3 + 2]!;
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
  release(pin: number, velocity: Float64Array, child: number, parent: number, share: 0 | 1): void {
    const { arms, wanted } = this;
    const f = this.#factors;
    const a = pin * ARMS;
    const g = pin * FACTORS;
    let x = share * wanted[pin * 3]!;
    let y = share * wanted[pin * 3 + 1]!;
    let z = share * wanted[pin * 3 + 2]!;
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
    const { arms } = this;
    const f = this.#factors;
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
