import type { X3DShape } from '../x3dom/renderer.js';
import { x3dom, type X3DMesh, type X3DNode } from '../x3dom/x3dom.js';

// Cures for what x3dom does with meshes.

/**
 * All geometry of one type and size has one mesh in x3dom, and an edit of any of them writes into it: what is brought to
 * WebGL later would get the shape of that one. A copy is written into instead.
 */
export function ownMesh(geometry: X3DNode): X3DMesh {
  const own = new (x3dom()!.Mesh)(geometry);
  const { _vol } = own;
  const fields = Object.entries(geometry._mesh!).map(([name, value]: [string, unknown]) => [
    name,
    Array.isArray(value) ? [...(value as unknown[])] : value,
  ]);
  return Object.assign(own, Object.fromEntries(fields), { _vol, _parent: geometry });
}

/** x3dom itself leaves the buffers in WebGL that the shader at hand does not use: four for a Box. */
export function freeBuffers(shape: X3DShape, gl: WebGL2RenderingContext): void {
  for (const buffer of shape._webgl?.buffers ?? []) if (buffer) gl.deleteBuffer(buffer);
  shape._cleanupGLObjects?.(true);
}
