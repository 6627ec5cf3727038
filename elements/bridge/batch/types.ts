import type { X3DNode } from '../x3dom/x3dom.js';

/** X3D's name of a node's type. */
export const typeOf = ({ constructor }: X3DNode): string =>
  (constructor as unknown as { _typeName: string })._typeName;
