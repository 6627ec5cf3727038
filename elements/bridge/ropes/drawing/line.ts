import { indexOf } from '../../matter/index-of.js';
import type { Form } from './form.js';

/** A rope as a line from point to point. */
export function lineForm(count: number): Form {
  const positions = new Float32Array(3 * count);
  const index = Array.from({ length: 2 * count - 2 }, (_, i) => (i + 1) >> 1);
  return {
    positions,
    normals: new Float32Array(0),
    texCoords: new Float32Array(0),
    index: indexOf(index, count),
    reach: 0,
    write: (points) => positions.set(points),
  };
}
