import { PARALLEL, TOUCH, write, type Flat, type Solid } from './solid.js';

/** A ball around the origin of its frame. */
export class BallSolid implements Solid {
  readonly box: Flat;
  readonly #radius: number;

  constructor(radius: number) {
    this.#radius = radius;
    this.box = Float64Array.of(-radius, -radius, -radius, radius, radius, radius);
  }

  meets(way: Flat, found: Flat): boolean {
    const r = this.#radius + way[6]!;
    const x = way[0]!;
    const y = way[1]!;
    const z = way[2]!;
    const u = way[3]!;
    const v = way[4]!;
    const w = way[5]!;
    const away = x * u + y * v + z * w;
    const square = x * x + y * y + z * z;
    const over = square - r * r;
    if (over <= TOUCH * r) {
      const distance = Math.sqrt(square);
      const depth = r - distance;
      if (depth <= TOUCH && !(away < -PARALLEL * r)) return false;
      // From its very middle any way out is as short.
      if (distance === 0) return write(found, 0, r, 0, 1, 0);
      return write(found, 0, Math.max(0, depth), x / distance, y / distance, z / distance);
    }
    if (!(away < 0)) return false;
    const inner = away * away - (u * u + v * v + w * w) * over;
    if (!(inner >= 0)) return false;
    const share = over / (Math.sqrt(inner) - away);
    if (!(share <= way[7]!)) return false;
    return write(found, share, 0, (x + u * share) / r, (y + v * share) / r, (z + w * share) / r);
  }
}
