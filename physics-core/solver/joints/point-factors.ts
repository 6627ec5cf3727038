import { BODY_BLOCK } from './blocks.js';

/** Numbers of a pin that stand while its factors do. */
export const FACTORS = 21;
/** Of these: the spin that the child takes on per speed of the point, per torque about it, and the mass it has there. */
export const GIVE = 0;
export const INVERSE_INERTIA = 9;
export const MASS = 15;

/** Numbers of both arms of a pin; that of the parent begins half-way. */
export const ARMS = 6;
export const PARENT = 3;

/** What of the inertia of bodies acts at the points of pins: of a body with all that hangs on it. */
export class PointFactors {
  /** From the centre of mass of child and parent to the point. */
  arms = new Float64Array(0);
  numbers = new Float64Array(0);
  /** How spin and the speed of the point go together in the child, and its inertia about the point. */
  readonly #couple = new Float64Array(9);
  readonly #about = new Float64Array(6);

  grow(room: number): void {
    this.arms = new Float64Array(room * ARMS);
    this.numbers = new Float64Array(room * FACTORS);
  }

  /**
   * Takes a child's inertia, a triangle of `bodies`, to the point, and what of it the parent feels on to the parent (-1:
   * the world). False: it is none.
   */
  factor(pin: number, bodies: Float64Array, child: number, parent: number): boolean {
    this.#seeFromPoint(pin, bodies, child * BODY_BLOCK);
    if (!this.#letTurn(pin * FACTORS + INVERSE_INERTIA)) return false;
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
    const f = this.numbers;
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
    const f = this.numbers;
    const c = this.#couple;
    const t00 = f[at + INVERSE_INERTIA]!;
    const t10 = f[at + INVERSE_INERTIA + 1]!;
    const t11 = f[at + INVERSE_INERTIA + 2]!;
    const t20 = f[at + INVERSE_INERTIA + 3]!;
    const t21 = f[at + INVERSE_INERTIA + 4]!;
    const t22 = f[at + INVERSE_INERTIA + 5]!;
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
    const f = this.numbers;
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
}
