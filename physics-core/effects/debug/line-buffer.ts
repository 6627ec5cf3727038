import type { Vec3 } from '../../fields/types.js';
import { add, subtract } from '../../base/math.js';
import type { Color } from './colors.js';

/** Numbers per line: both its ends. */
const LINE = 6;

/** Coloured lines, drawn anew time and again into the same arrays, which grow by doubling. */
export class LineBuffer {
  /** Of each line both ends, x y z. The first `count` lines count. */
  positions = new Float32Array(LINE * 256);
  /** Of each line the colour of both ends, r g b. */
  colors = new Float32Array(LINE * 256);
  count = 0;

  clear(): void {
    this.count = 0;
  }

  line(a: Vec3, b: Vec3, color: Color): void {
    this.put(a[0], a[1], a[2], b[0], b[1], b[2], color);
  }

  /** A cross of three lines; `axes` are half their lengths and directions. */
  cross(at: Vec3, axes: readonly Vec3[], color: Color): void {
    for (const axis of axes) this.line(subtract(at, axis), add(at, axis), color);
  }

  put(
    ax: number,
    ay: number,
    az: number,
    bx: number,
    by: number,
    bz: number,
    [r, g, b]: Color,
  ): void {
    const at = LINE * this.count++;
    if (at >= this.positions.length) this.#grow();
    const { positions, colors } = this;
    positions[at] = ax;
    positions[at + 1] = ay;
    positions[at + 2] = az;
    positions[at + 3] = bx;
    positions[at + 4] = by;
    positions[at + 5] = bz;
    colors[at] = colors[at + 3] = r;
    colors[at + 1] = colors[at + 4] = g;
    colors[at + 2] = colors[at + 5] = b;
  }

  #grow(): void {
    const { positions, colors } = this;
    this.positions = new Float32Array(2 * positions.length);
    this.positions.set(positions);
    this.colors = new Float32Array(2 * colors.length);
    this.colors.set(colors);
  }
}
