import type { Vec3 } from '../../../fields/types.js';
import { Convex, PARALLEL, TOUCH, type Flat } from './solid.js';

/** A box around the origin of its frame. */
export class BoxSolid extends Convex {
  readonly box: Flat;
  readonly #half: Flat;

  constructor(half: Vec3) {
    super();
    this.#half = Float64Array.from(half);
    this.box = Float64Array.from([...half.map((value) => -value), ...half]);
  }

  protected cut(way: Flat, out: Flat): boolean {
    const radius = way[6]!;
    const most = way[7]!;
    const half = this.#half;
    let enter = -Infinity;
    let exit = most;
    let axis = 0;
    for (let k = 0; k < 3; k++) {
      const end = half[k]! + radius;
      const p = way[k]!;
      const d = way[3 + k]!;
      if (Math.abs(d) <= PARALLEL) {
        if (!(Math.abs(p) <= end + TOUCH)) return false;
        continue;
      }
      const first = ((d > 0 ? -end : end) - p) / d;
      const last = ((d > 0 ? end : -end) - p) / d;
      if (first > enter) {
        enter = first;
        axis = k;
      }
      if (last < exit) exit = last;
    }
    if (!(enter <= exit && exit >= 0)) return false;
    out[0] = enter;
    out[1] = out[2] = out[3] = 0;
    out[1 + axis] = way[3 + axis]! > 0 ? -1 : 1;
    out[4] = radius <= TOUCH || (enter > 0 && this.#lies(way, enter, axis)) ? 1 : 0;
    return true;
  }

  /** Whether it touches the face of an axis within its edges. */
  #lies(way: Flat, share: number, axis: number): boolean {
    for (let k = 0; k < 3; k++)
      if (k !== axis && Math.abs(way[k]! + way[3 + k]! * share) > this.#half[k]!) return false;
    return true;
  }

  gap(at: Flat, out: Flat): void {
    const x = at[0]!;
    const y = at[1]!;
    const z = at[2]!;
    const half = this.#half;
    const u = Math.abs(x) - half[0]!;
    const v = Math.abs(y) - half[1]!;
    const w = Math.abs(z) - half[2]!;
    const most = Math.max(u, v, w);
    const a = Math.max(0, u);
    const b = Math.max(0, v);
    const c = Math.max(0, w);
    const distance = Math.sqrt(a * a + b * b + c * c);
    // Above one face alone, inside, or so near that an edge has no direction.
    if (most === distance || distance <= TOUCH) {
      out[0] = out[1] = out[2] = 0;
      if (u === most) out[0] = x < 0 ? -1 : 1;
      else if (v === most) out[1] = y < 0 ? -1 : 1;
      else out[2] = z < 0 ? -1 : 1;
      out[3] = most;
      return;
    }
    out[0] = (x < 0 ? -a : a) / distance;
    out[1] = (y < 0 ? -b : b) / distance;
    out[2] = (z < 0 ? -c : c) / distance;
    out[3] = distance;
  }
}
