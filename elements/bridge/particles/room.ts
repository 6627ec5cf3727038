import type { X3DMesh } from '../x3dom/x3dom.js';
import type { Form } from './form.js';

export interface CloudMesh extends X3DMesh {
  _normals: ArrayLike<number>[];
  _texCoords: ArrayLike<number>[];
  _colors: ArrayLike<number>[];
  _numColComponents: number;
}

/** Where what is not alive stands: out of any sight, in whatever x3dom draws. */
export const NOWHERE = 1e30;

/** Has a mesh hold so many particles, none of which is seen yet. */
export function makeRoom(mesh: CloudMesh, form: Form, room: number, hasColors: boolean): void {
  const { corners, index, normals, texCoords } = form;
  mesh._positions[0] = new Float32Array(room * corners * 3).fill(NOWHERE);
  mesh._normals[0] = spread(normals, new Float32Array(room * normals.length));
  mesh._texCoords[0] = spread(texCoords, new Float32Array(room * texCoords.length));
  mesh._colors[0] = hasColors ? new Float32Array(room * corners * 4) : [];
  mesh._indices[0] = indexOf(index, corners, room);
}

/** As wide as x3dom makes them. */
function indexOf(index: ArrayLike<number>, corners: number, times: number): ArrayLike<number> {
  const Wide = corners * times > 65535 ? Uint32Array : Uint16Array;
  const all = new Wide(times * index.length);
  for (let k = 0, at = 0; k < times; k++)
    for (let i = 0; i < index.length; i++) all[at++] = index[i]! + k * corners;
  return all;
}

/** The same values again and again, as often as there is room. */
export function spread(values: ArrayLike<number>, out: Float32Array): Float32Array {
  const { length } = out;
  if (length > 0) out.set(values);
  for (let done = values.length; done < length; done *= 2) out.copyWithin(done, 0, done);
  return out;
}
