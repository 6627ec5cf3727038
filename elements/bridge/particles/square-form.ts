import type { Affine } from '../geometry/matrix.js';
import type { Form } from './form.js';
import type { Look } from './look.js';
import { stamp } from './stamp.js';

/** Of a rectangle, as shares of its sides: about its middle, to the right and up. */
const SQUARE = [
  [-0.5, -0.5],
  [0.5, -0.5],
  [0.5, 0.5],
  [-0.5, 0.5],
] as const;
const TOGETHER = [0, 1, 2, 3];
/** Two triangles, each of corners of its own. */
const APART = [0, 1, 2, 0, 2, 3];

const MIDDLE = [0, 0, 0];

export const pointForm = (): Form => ({
  primitive: 'POINTS',
  corners: 1,
  index: [0],
  normals: [],
  texCoords: [],
  reach: 0,
  write: (seen, out) => stamp(seen, MIDDLE, out),
});

/** A rectangle; in the frame's own plane of x and y, or facing who looks. */
export function squareForm({ type, size, length, frame }: Look): Form {
  const corners = (type === 'TRIANGLE' ? APART : TOGETHER).map((corner) => SQUARE[corner]!);
  const sides = size.map((side) => side / length);
  const points = new Float64Array(3 * corners.length);
  const normals = new Float32Array(3 * corners.length);
  const turn = (axes: ArrayLike<number>): void => {
    for (let corner = 0; corner < corners.length; corner++)
      for (let i = 0; i < 3; i++) {
        const [right, up] = corners[corner]!;
        points[3 * corner + i] = right * sides[0]! * axes[i]! + up * sides[1]! * axes[3 + i]!;
        normals[3 * corner + i] = axes[6 + i]!;
      }
  };
  turn(unitAxes(frame));
  return {
    primitive: 'TRIANGLES',
    corners: corners.length,
    index: type === 'TRIANGLE' ? corners.map((_, i) => i) : APART,
    normals,
    texCoords: corners.flatMap(([right, up]) => [right + 0.5, up + 0.5]),
    reach: Math.hypot(...sides) / 2,
    turn: type === 'SPRITE' ? turn : undefined,
    write: (seen, out) => stamp(seen, points, out),
  };
}

/** The axes of a frame, each as long as 1: x, y, z. */
function unitAxes(matrix: Affine): number[] {
  return [0, 1, 2].flatMap((axis) => {
    const way = [matrix[axis]!, matrix[4 + axis]!, matrix[8 + axis]!];
    const length = Math.hypot(...way) || 1;
    return way.map((each) => each / length);
  });
}
