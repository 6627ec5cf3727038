import {
  x3dom,
  type NodeContext,
  type X3DMatrix,
  type X3DNode,
  type X3DVector,
} from '../x3dom/x3dom.js';
import { ownMesh } from './meshes.js';
import { typeOf } from './types.js';

// Boxes of all sizes look alike: each is the one of x3dom's own size, scaled.

/** Metres, or whatever lengths a file has. */
const SIZE = 2;

export const isScaled = (geometry: X3DNode): boolean =>
  typeOf(geometry) === 'Box' && geometry._vf.ccw === true && geometry._vf.hasHelperColors === false;

/** From the frame of the geometry that `drawnFor` gives to that of this one. */
export function scalingOf(geometry: X3DNode): X3DMatrix {
  const { SFMatrix4f, SFVec3f } = x3dom()!.fields;
  if (!isScaled(geometry)) return SFMatrix4f.identity();
  const { x, y, z } = geometry._vf.size as X3DVector;
  return SFMatrix4f.scale(new SFVec3f(x / SIZE, y / SIZE, z / SIZE));
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
