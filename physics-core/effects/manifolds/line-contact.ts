import { hypot } from '../../base/exact/index.js';
import type { Flat } from '../../shapes/forms/form.js';
import type { FoundPoints } from './found-points.js';
import type { PlacedForm } from './placed-form.js';

/** Lines that cross at a greater angle touch in one point, by its sine. */
const PARALLEL = 0.05;

/** Shorter overlaps are one point, metres. */
const SHORT = 1e-4;

/** Where a straight line of one form lies along one of another: the two ends of what they share. */
export class LineContact {
  readonly #a = new Float64Array(6);
  readonly #b = new Float64Array(6);

  find(
    a: PlacedForm,
    b: PlacedForm,
    normal: Flat,
    limit: number,
    points: FoundPoints,
    triangle: number,
  ): boolean {
    const x = normal[0]!;
    const y = normal[1]!;
    const z = normal[2]!;
    const p = this.#a;
    const q = this.#b;
    if (a.line(-x, -y, -z, p) < 2 || b.line(x, y, z, q) < 2) return false;
    const lengthA = hypot(p[3]! - p[0]!, p[4]! - p[1]!, p[5]! - p[2]!);
    const lengthB = hypot(q[3]! - q[0]!, q[4]! - q[1]!, q[5]! - q[2]!);
    const u = (q[3]! - q[0]!) / lengthB;
    const v = (q[4]! - q[1]!) / lengthB;
    const w = (q[5]! - q[2]!) / lengthB;
    const from = (p[0]! - q[0]!) * u + (p[1]! - q[1]!) * v + (p[2]! - q[2]!) * w;
    const along = (p[3]! - p[0]!) * u + (p[4]! - p[1]!) * v + (p[5]! - p[2]!) * w;
    if (lengthA ** 2 - along ** 2 > (PARALLEL * lengthA) ** 2) return false;
    const start = Math.max(0, Math.min(from, from + along));
    const end = Math.min(lengthB, Math.max(from, from + along));
    if (end - start < SHORT) return false;
    for (const t of ENDS) {
      const onB = start + t * (end - start);
      const onA = (onB - from) / along;
      const bx = q[0]! + onB * u;
      const by = q[1]! + onB * v;
      const bz = q[2]! + onB * w;
      const distance =
        x * (p[0]! + onA * (p[3]! - p[0]!) - bx) +
        y * (p[1]! + onA * (p[4]! - p[1]!) - by) +
        z * (p[2]! + onA * (p[5]! - p[2]!) - bz);
      if (distance <= limit) points.add(bx, by, bz, x, y, z, distance, triangle);
    }
    return true;
  }
}

const ENDS = [0, 1] as const;
