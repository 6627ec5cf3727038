import type { Affine } from '../geometry/matrix.js';
import type { X3DMatrix, X3DNode } from './x3dom.js';

export function fromX3D(m: X3DMatrix, out: Affine = new Array(12)): Affine {
  out[0] = m._00;
  out[1] = m._01;
  out[2] = m._02;
  out[3] = m._03;
  out[4] = m._10;
  out[5] = m._11;
  out[6] = m._12;
  out[7] = m._13;
  out[8] = m._20;
  out[9] = m._21;
  out[10] = m._22;
  out[11] = m._23;
  return out;
}

/** Into the matrix that is there: x3dom keeps hold of it, and nothing is allocated. */
export function intoX3D(m: Affine, out: X3DMatrix): void {
  out._00 = m[0];
  out._01 = m[1];
  out._02 = m[2];
  out._03 = m[3];
  out._10 = m[4];
  out._11 = m[5];
  out._12 = m[6];
  out._13 = m[7];
  out._20 = m[8];
  out._21 = m[9];
  out._22 = m[10];
  out._23 = m[11];
}

/** Nodes whose matrix comes from a body, no longer from their attributes. */
const drawn = new WeakSet<X3DNode>();

export const noteDrawn = (node: X3DNode): void => void drawn.add(node);

export const wasDrawn = (node: X3DNode): boolean => drawn.has(node);
