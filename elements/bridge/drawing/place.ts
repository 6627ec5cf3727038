import type { Binding } from '../nodes/binding.js';
import { matrixOf, quaternionOf } from '../geometry/matrix.js';
import { intoX3D } from '../x3dom/matrices.js';
import type { X3DNode } from '../x3dom/x3dom.js';

/** Until a body moves it, a collidable stands where its fields say: lengths of its file, angles in radians. */
export function placeAsWritten(collidable: Binding, node: X3DNode | undefined): void {
  if (!node?._trafo) return;
  const [x, y, z] = collidable.get('translation') as number[];
  const [ax, ay, az, angle] = collidable.get('rotation') as number[];
  const quaternion = quaternionOf([ax, ay, az, angle * collidable.units.angle]);
  intoX3D(matrixOf({ position: [x, y, z], quaternion }), node._trafo);
  node.invalidateVolume();
}
