import type { ShownSurface } from '../../../../physics-core/water.js';

/** Where a volume of water is, as x3dom draws it. */
export interface Place {
  /** Its axes, one after the other, each of length 1. */
  axes: readonly number[];
  /** Its middle, metres. */
  middle: readonly number[];
  depth: number;
  /** Metres of one unit of what x3dom draws. */
  unit: number;
}

/** What lies around the surface: four walls, two corners a side, and a bottom. */
const AROUND = 4;

/**
 * The mesh of a box of water whose upper side moves: a corner for each corner of its cells, walls that go down from its edges,
 * and a bottom. What has no height of its own lies between those of the cells around it.
 */
export class SurfaceMesh {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly texCoords: Float32Array;
  readonly index: Uint16Array | Uint32Array;
  readonly #columns: number;
  readonly #rows: number;
  /** The first corner of each wall; those of its upper edge come first. */
  readonly #walls: number[] = [];
  readonly #bottom: number;
  /** Of the surface's corners, metres above the still water. */
  readonly #heights: Float64Array;

  constructor({ columns, rows }: ShownSurface) {
    this.#columns = columns;
    this.#rows = rows;
    const top = (columns + 1) * (rows + 1);
    let corners = top;
    for (let side = 0; side < AROUND; side++) {
      this.#walls.push(corners);
      corners += 2 * (this.#along(side) + 1);
    }
    this.#bottom = corners;
    corners += 4;
    this.#heights = new Float64Array(top);
    this.positions = new Float32Array(3 * corners);
    this.normals = new Float32Array(3 * corners);
    this.texCoords = new Float32Array(2 * corners);
    this.index = this.#indexOf(corners);
    this.#spreadTexture();
  }

  /** Cells along a wall: first the one at the least x, then at the greatest, then the same of z. */
  #along(side: number): number {
    return side < 2 ? this.#rows : this.#columns;
  }

  /** The corner of the surface at such a place of a wall. */
  #cornerOf(side: number, i: number): number {
    const columns = this.#columns;
    if (side < 2) return i * (columns + 1) + (side === 0 ? 0 : columns);
    return (side === 2 ? 0 : this.#rows * (columns + 1)) + i;
  }

  #indexOf(corners: number): Uint16Array | Uint32Array {
    const all: number[] = [];
    const quad = (a: number, b: number, c: number, d: number): unknown =>
      all.push(a, b, c, a, c, d);
    const wide = this.#columns + 1;
    for (let row = 0; row < this.#rows; row++)
      for (let i = 0; i < this.#columns; i++) {
        const at = row * wide + i;
        quad(at, at + wide, at + wide + 1, at + 1);
      }
    this.#walls.forEach((first, side) => {
      const count = this.#along(side);
      const low = first + count + 1;
      for (let i = 0; i < count; i++)
        if (side === 0 || side === 3) quad(first + i, low + i, low + i + 1, first + i + 1);
        else quad(first + i, first + i + 1, low + i + 1, low + i);
    });
    const b = this.#bottom;
    quad(b, b + 1, b + 3, b + 2);
    // As wide as x3dom makes them.
    return corners > 65535 ? Uint32Array.from(all) : Uint16Array.from(all);
  }

  #spreadTexture(): void {
    const { texCoords } = this;
    const write = (corner: number, u: number, v: number): void => {
      texCoords[2 * corner] = u;
      texCoords[2 * corner + 1] = v;
    };
    for (let row = 0; row <= this.#rows; row++)
      for (let i = 0; i <= this.#columns; i++)
        write(row * (this.#columns + 1) + i, i / this.#columns, 1 - row / this.#rows);
    this.#walls.forEach((first, side) => {
      const count = this.#along(side);
      for (let i = 0; i <= count; i++) {
        write(first + i, i / count, 1);
        write(first + count + 1 + i, i / count, 0);
      }
    });
    for (let i = 0; i < 4; i++) write(this.#bottom + i, i & 1, i >> 1);
  }

  write(shown: ShownSurface, place: Place): void {
    this.#rise(shown);
    this.#writeTop(shown, place);
    this.#writeWalls(shown, place);
  }

  /** A corner is as high as the cells around it in the middle. */
  #rise({ heights }: ShownSurface): void {
    const columns = this.#columns;
    const rows = this.#rows;
    const wide = columns + 1;
    for (let row = 0; row <= rows; row++) {
      const near = (row > 0 ? row - 1 : 0) * columns;
      const far = (row < rows ? row : rows - 1) * columns;
      for (let i = 0; i <= columns; i++) {
        const left = i > 0 ? i - 1 : 0;
        const right = i < columns ? i : columns - 1;
        this.#heights[row * wide + i] =
          (heights[near + left]! +
            heights[near + right]! +
            heights[far + left]! +
            heights[far + right]!) /
          4;
      }
    }
  }

  #writeTop({ width, length }: ShownSurface, { axes, middle, depth, unit }: Place): void {
    const { positions, normals } = this;
    const h = this.#heights;
    const columns = this.#columns;
    const rows = this.#rows;
    const wide = columns + 1;
    const cellWidth = width / columns;
    const cellLength = length / rows;
    let to = 0;
    for (let row = 0, at = 0; row <= rows; row++) {
      const z = row * cellLength - length / 2;
      const near = row > 0 ? wide : 0;
      const far = row < rows ? wide : 0;
      const perLength = wide / (cellLength * (near + far));
      for (let i = 0; i <= columns; i++, at++, to += 3) {
        const x = i * cellWidth - width / 2;
        const y = depth / 2 + h[at]!;
        const left = i > 0 ? 1 : 0;
        const right = i < columns ? 1 : 0;
        const across = (h[at - left]! - h[at + right]!) / (cellWidth * (left + right));
        const along = (h[at - near]! - h[at + far]!) * perLength;
        const upright = 1 / Math.sqrt(1 + across * across + along * along);
        for (let k = 0; k < 3; k++) {
          positions[to + k] =
            (middle[k]! + axes[k]! * x + axes[3 + k]! * y + axes[6 + k]! * z) / unit;
          normals[to + k] = upright * (axes[k]! * across + axes[3 + k]! + axes[6 + k]! * along);
        }
      }
    }
  }

  #writeWalls({ width, length }: ShownSurface, { axes, middle, depth, unit }: Place): void {
    const { positions, normals } = this;
    for (let side = 0; side < AROUND; side++) {
      const axis = side < 2 ? 0 : 6;
      const sign = side % 2 === 0 ? -1 : 1;
      const count = this.#along(side) + 1;
      const first = this.#walls[side]!;
      for (let i = 0; i < count; i++) {
        const corner = this.#cornerOf(side, i);
        const down = (depth + this.#heights[corner]!) / unit;
        for (let k = 0; k < 3; k++) {
          const high = positions[3 * corner + k]!;
          positions[3 * (first + i) + k] = high;
          positions[3 * (first + count + i) + k] = high - axes[3 + k]! * down;
          normals[3 * (first + i) + k] = normals[3 * (first + count + i) + k] =
            sign * axes[axis + k]!;
        }
      }
    }
    for (let i = 0; i < 4; i++) {
      const x = ((i & 1) - 0.5) * width;
      const z = ((i >> 1) - 0.5) * length;
      for (let k = 0; k < 3; k++) {
        const at = 3 * (this.#bottom + i) + k;
        positions[at] =
          (middle[k]! + axes[k]! * x - (axes[3 + k]! * depth) / 2 + axes[6 + k]! * z) / unit;
        normals[at] = -axes[3 + k]!;
      }
    }
  }
}
