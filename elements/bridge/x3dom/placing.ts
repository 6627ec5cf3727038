import { multiplyLinear, quaternionInto, type Affine } from '../geometry/matrix.js';
import { intoX3D } from './matrices.js';
import type { X3DNode, X3DQuaternion, X3DVector } from './x3dom.js';

// Scratch: nothing is allocated while bodies move.
const scaled: Affine = new Array<number>(12).fill(0.5);

/** The matrix of what stands in a pose and has a scale, a mirror or a shear of its own beside that. */
export const matrixFor = (pose: Affine, linear: readonly number[] | undefined): Affine =>
  linear ? multiplyLinear(pose, linear, scaled) : pose;

/** Into x3dom's matrix and the fields beside it, past its attributes, so that nothing comes back as an edit. */
export function placeNode(
  node: X3DNode,
  pose: Affine,
  linear: readonly number[] | undefined,
): void {
  const matrix = matrixFor(pose, linear);
  intoX3D(matrix, node._trafo!);
  if (node._vf.translation && node._vf.center) keepFields(node, matrix, pose);
}

/**
 * A Transform's own fields, true to its matrix. Its translation is where the matrix takes its centre, less the
 * centre: rotation and scale leave that point alone.
 */
function keepFields(node: X3DNode, local: Affine, pose: Affine): void {
  const translation = node._vf.translation as X3DVector;
  const { x, y, z } = node._vf.center as X3DVector;
  translation.x = local[0] * x + local[1] * y + local[2] * z + local[3] - x;
  translation.y = local[4] * x + local[5] * y + local[6] * z + local[7] - y;
  translation.z = local[8] * x + local[9] * y + local[10] * z + local[11] - z;
  const rotation = node._vf.rotation as X3DQuaternion;
  quaternionInto(pose, rotation);
}
