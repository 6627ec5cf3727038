import type { X3DNode } from '../x3dom/x3dom.js';

/**
 * An Appearance as it is, but sorted among what shows what is behind it, and hiding nothing by its depth, unless its author
 * says how that is: x3dom writes the depth of what has a texture, and particles of two systems would punch holes into each
 * other. Others that have the same Appearance stay as they are.
 */
export function fading(node: X3DNode, depthMode: X3DNode): X3DNode {
  depthMode._vf.readOnly = true;
  const values = Object.create(node._vf, { sortType: { value: 'transparent', writable: true } });
  const given = node._cf.depthMode!;
  const depth = {
    get node() {
      return given.node ?? depthMode;
    },
  };
  const parts = Object.create(node._cf, { depthMode: { value: depth } });
  return Object.create(node, { _vf: { value: values }, _cf: { value: parts } });
}
