import { x3dom, type X3DDocument, type X3DNode } from '../x3dom/x3dom.js';
import type { X3DDrawnDocument } from '../x3dom/renderer.js';

/** A Shape, and what x3dom has made of it. */
export interface UploadedShape extends X3DNode {
  /** What of it is to be made anew. */
  _dirty: Record<string, boolean>;
  _webgl?: { buffers: (WebGLBuffer | undefined)[] };
}

/** Lists of a mesh, by the names that x3dom has for their buffers and for what is to be made anew. */
const LISTS = {
  POSITION: 'positions',
  NORMAL: 'normals',
  TEXCOORD: 'texcoords',
  COLOR: 'colors',
} as const;

/**
 * Writes the first `count` numbers of a list of a Shape's mesh into the buffer that x3dom has for it. Told that the list has
 * changed, x3dom would make that buffer and the index anew, and copy both lists whole before. Where it has no such buffer yet,
 * or is about to make it anew, it takes the list then.
 */
export function upload(
  shape: UploadedShape,
  doc: X3DDocument,
  list: keyof typeof LISTS,
  numbers: Float32Array,
  count = numbers.length,
): void {
  const gl = (doc as X3DDrawnDocument).ctx?.ctx3d;
  const buffer = shape._webgl?.buffers[x3dom()!.BUFFER_IDX[list]!];
  const { positions, indexes } = shape._dirty;
  if (!gl || !buffer || positions || indexes) {
    shape._dirty[LISTS[list]] = true;
    return;
  }
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferSubData(gl.ARRAY_BUFFER, 0, numbers, 0, count);
}
