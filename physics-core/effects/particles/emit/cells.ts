import { cross, dot, subtract } from '../../../base/math.js';
import type { Vec3 } from '../../../fields/types.js';
import type { Draws } from './draws.js';
import { CELLS, Columns, MARGIN, reachOf } from './columns.js';
import { TRIANGLE, type Box } from './triangles.js';

/**
 * How many places are drawn before one is given up. Of the cells that a surface goes through about half is inside, of a plate
 * askew that is a thousandth as thick as wide, one in a hundred: so only what is as good as flat is given up.
 */
const TRIES = 10_000;

/** Where a cell is looked at, as shares of its sides: on no line that a mesh is likely to have. */
const LOOK: Vec3 = [0.4142135, 0.6180339, 0.7320508];

const cellAt = (x: number, y: number, z: number): number => (x * CELLS + y) * CELLS + z;

/** The cells of a closed mesh's box that are not wholly outside. */
export class Cells {
  readonly #box: Box;
  readonly #columns: Columns;
  /** Those, and whether the surface goes through each. */
  readonly #cells: Int32Array;
  readonly #crossed: Uint8Array;

  constructor(triangles: Float64Array, oriented: boolean, box: Box) {
    this.#box = box;
    this.#columns = new Columns(triangles, oriented, box);
    this.#crossed = crossedBy(triangles, box);
    this.#cells = Int32Array.from(this.#notOutside());
  }

  /** FALSE: none was found. */
  place(draws: Draws, birth: Float64Array): boolean {
    for (let i = 0; i < TRIES; i++) {
      const cell = this.#cells[Math.floor(draws.next() * this.#cells.length)]!;
      this.#write(birth, cell, draws.next(), draws.next(), draws.next());
      if (this.#crossed[cell] === 0 || this.#holds(cell, birth)) return true;
    }
    return false;
  }

  /** The place at these shares of a cell's sides. */
  #write(place: Float64Array | Vec3, cell: number, x: number, y: number, z: number): void {
    const { least, sides } = this.#box;
    const column = Math.floor(cell / CELLS);
    place[0] = least[0] + ((Math.floor(column / CELLS) + x) / CELLS) * sides[0];
    place[1] = least[1] + (((column % CELLS) + y) / CELLS) * sides[1];
    place[2] = least[2] + (((cell % CELLS) + z) / CELLS) * sides[2];
  }

  #holds(cell: number, place: Float64Array | Vec3): boolean {
    return this.#columns.holds(Math.floor(cell / CELLS), place[0]!, place[1]!, place[2]!);
  }

  /**
   * Cells of a column are all inside or none, as long as no surface comes between; columns begin and end outside, or with the
   * surface.
   */
  #notOutside(): number[] {
    const place: Vec3 = [0, 0, 0];
    const cells: number[] = [];
    let inside = false;
    for (let cell = 0; cell < this.#crossed.length; cell++) {
      const crossed = this.#crossed[cell] === 1;
      if (!crossed && this.#crossed[cell - 1] === 1) {
        this.#write(place, cell, ...LOOK);
        inside = this.#holds(cell, place);
      }
      if (crossed || inside) cells.push(cell);
    }
    return cells;
  }
}

/** 1 for each cell that a triangle may go through, else 0. */
function crossedBy(triangles: Float64Array, box: Box): Uint8Array {
  const crossed = new Uint8Array(CELLS ** 3);
  const half = box.sides.map((side) => side / CELLS / 2) as Vec3;
  for (let at = 0; at < triangles.length; at += TRIANGLE) {
    const [a, b, c] = [0, 3, 6].map((i) => [...triangles.subarray(at + i, at + i + 3)]) as Vec3[];
    const normal = cross(subtract(b!, a!), subtract(c!, a!));
    // How far along the normal a cell's corners are from its middle.
    const reach = (1 + MARGIN) * dot(normal.map(Math.abs) as Vec3, half);
    const offset = dot(normal, subtract(a!, box.least));
    const [xs, ys, zs] = [0, 1, 2].map((k) => reachOf(triangles, at, k, box)) as Reach[];
    for (let x = xs![0]; x <= xs![1]; x++)
      for (let y = ys![0]; y <= ys![1]; y++)
        for (let z = zs![0]; z <= zs![1]; z++) {
          const middle: Vec3 = [
            (2 * x + 1) * half[0],
            (2 * y + 1) * half[1],
            (2 * z + 1) * half[2],
          ];
          if (Math.abs(dot(normal, middle) - offset) <= reach) crossed[cellAt(x, y, z)] = 1;
        }
  }
  return crossed;
}

type Reach = [number, number];
