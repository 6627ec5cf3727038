import type { X3DNode } from '../x3dom/x3dom.js';

/** An Appearance as it is but for how it is sorted: others that have the same one stay as they are. */
export function withSortType(node: X3DNode, sortType: string): X3DNode {
  const values = Object.create(node._vf, { sortType: { value: sortType, writable: true } });
  return Object.create(node, { _vf: { value: values } });
}
