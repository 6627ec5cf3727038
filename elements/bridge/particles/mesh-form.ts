import type { Affine } from '../geometry/matrix.js';
import type { X3DMesh } from '../x3dom/x3dom.js';
import type { Form } from './form.js';
import { scaleIn } from './frame.js';
import { stamp } from './stamp.js';

/** What x3dom's own geometry has beside. */
type Given = X3DMesh & { _normals?: ArrayLike<number>[]; _texCoords?: ArrayLike<number>[] };

/** The triangles of a geometry, as its frame scales and turns them, about where the particle is. */
export function meshForm(mesh: X3DMesh, frame: Affine): Form {
  const { _positions, _indices, _normals, _texCoords } = mesh as Given;
  const points = turned(_positions[0] ?? [], frame);
  const scale = scaleIn(frame) || 1;
  const upright = frame.map((value) => value / scale);
  return {
    primitive: 'TRIANGLES',
    corners: points.length / 3,
    index: _indices[0] ?? [],
    normals: turned(_normals?.[0] ?? [], upright),
    texCoords: _texCoords?.[0] ?? [],
    reach: reachOf(points),
    write: (seen, out) => stamp(seen, points, out),
  };
}

function reachOf(points: Float32Array): number {
  let most = 0;
  for (let k = 0; k < points.length; k += 3)
    most = Math.max(most, Math.hypot(points[k]!, points[k + 1]!, points[k + 2]!));
  return most;
}

function turned(list: ArrayLike<number>, m: readonly number[]): Float32Array {
  const out = new Float32Array(list.length);
  for (let k = 0; k < list.length; k += 3)
    for (let i = 0; i < 3; i++)
      out[k + i] =
        m[4 * i]! * list[k]! + m[4 * i + 1]! * list[k + 1]! + m[4 * i + 2]! * list[k + 2]!;
  return out;
}
