import { hypot } from '../../base/exact/index.js';
import { BoxTree } from './box-tree.js';
import { dropBeside } from './beside.js';
import { BOX } from './layout.js';
import { Seams } from './seams.js';

/** A surface of triangles: where each lies, which are near, and how they hang together. */
export class Surface {
  readonly points: Float64Array;
  readonly index: Int32Array;
  /** Of each triangle, against the clock seen from outside; zeros where it has no area. */
  readonly normals: Float64Array;
  readonly seams: Seams;
  readonly #tree: BoxTree;

  /** `points`: x, y, z of each corner; `index`: three corners of each triangle. */
  constructor(points: readonly number[], index: readonly number[]) {
    this.points = Float64Array.from(points);
    this.index = Int32Array.from(index);
    this.normals = normalsOf(this.points, this.index);
    this.seams = new Seams(this.points, this.index, this.normals);
    this.#tree = new BoxTree(boxesOf(this.points, this.index));
  }

  get count(): number {
    return this.index.length / 3;
  }

  /** The numbers of triangles near a box; their count. */
  near(box: Float64Array, out: Int32Array): number {
    return this.#tree.find(box, out);
  }

  /** Of those the ones that the box is not wholly beside, by more than `limit`, metres. */
  notBeside(box: Float64Array, limit: number, out: Int32Array): number {
    return dropBeside(this, box, limit, out, this.near(box, out));
  }
}

function normalsOf(points: Float64Array, index: Int32Array): Float64Array {
  const normals = new Float64Array(index.length);
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = [3 * index[t]!, 3 * index[t + 1]!, 3 * index[t + 2]!];
    const u = (i: number): number => points[b + i]! - points[a + i]!;
    const v = (i: number): number => points[c + i]! - points[a + i]!;
    const x = u(1) * v(2) - u(2) * v(1);
    const y = u(2) * v(0) - u(0) * v(2);
    const z = u(0) * v(1) - u(1) * v(0);
    const size = hypot(x, y, z);
    if (size > 0) normals.set([x / size, y / size, z / size], t);
  }
  return normals;
}

function boxesOf(points: Float64Array, index: Int32Array): Float64Array {
  const boxes = new Float64Array(2 * index.length);
  for (let t = 0; t < index.length / 3; t++)
    for (let k = 0; k < 3; k++) {
      const all = [0, 1, 2].map((i) => points[3 * index[3 * t + i]! + k]!);
      boxes[BOX * t + k] = Math.min(...all);
      boxes[BOX * t + 3 + k] = Math.max(...all);
    }
  return boxes;
}
