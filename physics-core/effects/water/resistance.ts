import type { Flat } from '../../shapes/cut/cut.js';
import type { SeePiece, Skin } from './skin.js';
import { SIX } from './six.js';

/** The water's drag and lift, per square metre and m/s: half of its density times their coefficients. */
export interface Thickness {
  drag: number;
  lift: number;
}

/**
 * How a body is braked that moves through water, in the frame of its centre of mass: a piece of skin that goes against the
 * water at a speed u, and turns its normal n to it, is pushed by c = ½ ρ C (u · n) A: with -c u by drag, and by lift with
 * -g × u, where g = c (u × n) / |u|, which takes no energy. Both are linear in u beside c, so that all pieces together
 * make one matrix of six by six of the velocity and the spin.
 */
export class Resistance {
  readonly matrix = new Float64Array(SIX * SIX);
  // Sums over pieces at p: c, c p and c p pᵀ; g, p gᵀ and (p · g) p.
  readonly #c = new Float64Array(10);
  readonly #g = new Float64Array(15);
  #velocity: Flat = new Float64Array(SIX);
  #drag = 0;
  #lift = 0;

  /** Of what lies below a plane and above a floor. Velocity and spin are those of the body, seen from the water. */
  reckon(
    skin: Skin,
    plane: Flat,
    floor: Flat | undefined,
    velocity: Flat,
    { drag, lift }: Thickness,
  ): Flat {
    this.#velocity = velocity;
    this.#drag = drag;
    this.#lift = lift;
    this.#c.fill(0);
    this.#g.fill(0);
    skin.below(plane, floor, this.#see);
    return this.#assemble();
  }

  readonly #see: SeePiece = (area, f, normal, at) => {
    const v = this.#velocity;
    const x = f[at]!;
    const y = f[at + 1]!;
    const z = f[at + 2]!;
    const ux = v[0]! + v[4]! * z - v[5]! * y;
    const uy = v[1]! + v[5]! * x - v[3]! * z;
    const uz = v[2]! + v[3]! * y - v[4]! * x;
    const nx = f[normal]!;
    const ny = f[normal + 1]!;
    const nz = f[normal + 2]!;
    const against = (ux * nx + uy * ny + uz * nz) * area;
    if (!(against > 0)) return;
    const c = this.#c;
    const drag = this.#drag * against;
    c[0]! += drag;
    c[1]! += drag * x;
    c[2]! += drag * y;
    c[3]! += drag * z;
    c[4]! += drag * x * x;
    c[5]! += drag * y * y;
    c[6]! += drag * z * z;
    c[7]! += drag * x * y;
    c[8]! += drag * x * z;
    c[9]! += drag * y * z;
    if (this.#lift === 0) return;
    const lift = (this.#lift * against) / Math.sqrt(ux * ux + uy * uy + uz * uz);
    const gx = lift * (uy * nz - uz * ny);
    const gy = lift * (uz * nx - ux * nz);
    const gz = lift * (ux * ny - uy * nx);
    const g = this.#g;
    const along = x * gx + y * gy + z * gz;
    g[0]! += gx;
    g[1]! += gy;
    g[2]! += gz;
    g[3]! += x * gx;
    g[4]! += x * gy;
    g[5]! += x * gz;
    g[6]! += y * gx;
    g[7]! += y * gy;
    g[8]! += y * gz;
    g[9]! += z * gx;
    g[10]! += z * gy;
    g[11]! += z * gz;
    g[12]! += along * x;
    g[13]! += along * y;
    g[14]! += along * z;
  };

  /** The matrix D: the push is -D times velocity and spin. */
  #assemble(): Flat {
    const m = this.matrix;
    m.fill(0);
    this.#addDrag(m);
    this.#addLift(m);
    return m;
  }

  #addDrag(m: Flat): void {
    const c = this.#c;
    for (let k = 0; k < 3; k++) m[7 * k] = c[0]!;
    // -[p]× to the right, [p]× below, -[p]×² at the end.
    addCross(m, 0, 3, -c[1]!, -c[2]!, -c[3]!);
    addCross(m, 3, 0, c[1]!, c[2]!, c[3]!);
    const xx = c[4]!;
    const yy = c[5]!;
    const zz = c[6]!;
    addSymmetric(m, yy + zz, xx + zz, xx + yy, -c[7]!, -c[8]!, -c[9]!);
  }

  #addLift(m: Flat): void {
    const g = this.#g;
    addCross(m, 0, 0, g[0]!, g[1]!, g[2]!);
    const trace = g[3]! + g[7]! + g[11]!;
    for (let i = 0; i < 3; i++)
      for (let j = 0; j < 3; j++) {
        const diagonal = i === j ? trace : 0;
        // -[g]× [p]× = (p · g) - p gᵀ, and [p]× [g]× = g pᵀ - (p · g).
        m[SIX * i + 3 + j]! += diagonal - g[3 + 3 * i + j]!;
        m[SIX * (3 + i) + j]! += g[3 + 3 * j + i]! - diagonal;
      }
    // -[p]× [g]× [p]× = (p · g) [p]×.
    addCross(m, 3, 3, g[12]!, g[13]!, g[14]!);
  }
}

/** [v]× with its first number there. */
function addCross(m: Flat, row: number, column: number, x: number, y: number, z: number): void {
  const at = SIX * row + column;
  m[at + 1]! -= z;
  m[at + 2]! += y;
  m[at + SIX]! += z;
  m[at + SIX + 2]! -= x;
  m[at + 2 * SIX]! -= y;
  m[at + 2 * SIX + 1]! += x;
}

function addSymmetric(
  m: Flat,
  xx: number,
  yy: number,
  zz: number,
  xy: number,
  xz: number,
  yz: number,
): void {
  m[21]! += xx;
  m[22]! += xy;
  m[23]! += xz;
  m[27]! += xy;
  m[28]! += yy;
  m[29]! += yz;
  m[33]! += xz;
  m[34]! += yz;
  m[35]! += zz;
}
