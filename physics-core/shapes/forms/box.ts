import type { Vec3 } from '../../fields/types.js';
import { neighboursOf, PolytopeForm } from './polytope.js';

/** The faces of a cube whose corner `i` has the sign of x in bit 0, of y in bit 1, of z in bit 2. */
const FACES = [
  [0, 4, 6, 2],
  [1, 3, 7, 5],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 2, 3, 1],
  [4, 5, 7, 6],
];

const NORMALS = Float64Array.of(-1, 0, 0, 1, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, -1, 0, 0, 1);

const NEIGHBOURS = neighboursOf(8, FACES);

/** The most common of all: signs say what others must look for among their corners. */
export class BoxForm extends PolytopeForm {
  constructor(half: Vec3) {
    super({ points: cornersOf(half), faces: FACES, normals: NORMALS }, NEIGHBOURS);
  }

  protected override farthest(x: number, y: number, z: number): number {
    return (x > 0 ? 1 : 0) | (y > 0 ? 2 : 0) | (z > 0 ? 4 : 0);
  }

  protected override mostAlong(x: number, y: number, z: number): number {
    const u = Math.abs(x);
    const v = Math.abs(y);
    const w = Math.abs(z);
    if (u >= v && u >= w) return x > 0 ? 1 : 0;
    if (v >= w) return y > 0 ? 3 : 2;
    return z > 0 ? 5 : 4;
  }
}

function cornersOf(half: Vec3): Float64Array {
  const points = new Float64Array(24);
  for (let i = 0; i < 8; i++)
    for (let axis = 0; axis < 3; axis++)
      points[3 * i + axis] = i & (1 << axis) ? half[axis]! : -half[axis]!;
  return points;
}
