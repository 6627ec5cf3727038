import { x3dom, type NodeContext, type X3DNode, type X3DVector } from '../x3dom/x3dom.js';
import { ownMesh } from './meshes.js';
import { typeOf } from './types.js';

// Boxes of all sizes look alike: each is the one of x3dom's own size, whose corners are one away from its middle.

const ONE: X3DVector = { x: 1, y: 1, z: 1 };

export const isScaled = (geometry: X3DNode): boolean =>
  typeOf(geometry) === 'Box' && geometry._vf.ccw === true && geometry._vf.hasHelperColors === false;

/** What the corners of what `drawnFor` gives are multiplied with. x3dom halves a Box's size, too. */
export function halfSizeOf(geometry: X3DNode): X3DVector {
  if (!isScaled(geometry)) return ONE;
  const { x, y, z } = geometry._vf.size as X3DVector;
  return { x: x / 2, y: y / 2, z: z / 2 };
}

/** What is drawn for all whose geometry is alike. */
export function drawnFor(geometry: X3DNode): X3DNode {
  if (!isScaled(geometry)) return geometry;
  const nameSpace = geometry._nameSpace!;
  const context: NodeContext = { doc: nameSpace.doc, runtime: undefined, xmlNode: null, nameSpace };
  const box = new (x3dom()!.nodeTypes.Box)(context);
  box._nameSpace = nameSpace;
  Object.assign(box._vf, { solid: geometry._vf.solid, lit: geometry._vf.lit });
  // Others may have written into the mesh that all of this size share.
  box._mesh = ownMesh(box);
  box.fieldChanged('size');
  return box;
}
