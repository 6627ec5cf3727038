import type { Form } from './form.js';
import type { Look } from './look.js';

/** Along the way that it goes, as long as the system's particles are high, about its middle. */
export function lineForm({ size, length }: Look): Form {
  const half = size[1]! / length / 2;
  return {
    primitive: 'LINES',
    corners: 2,
    index: [0, 1],
    normals: [],
    texCoords: [0, 0, 1, 0],
    reach: half,
    write: ({ places, moves, motion, order, count }, out) => {
      for (let i = 0, to = 0; i < count; i++, to += 6) {
        const k = order[i]!;
        const way = moves[k]! + 3;
        const speed = Math.hypot(motion[way]!, motion[way + 1]!, motion[way + 2]!);
        const perSpeed = speed > 0 ? half / speed : 0;
        for (let axis = 0; axis < 3; axis++) {
          const middle = places[3 * k + axis]!;
          const arm = perSpeed * motion[way + axis]!;
          out[to + axis] = middle - arm;
          out[to + 3 + axis] = middle + arm;
        }
      }
    },
  };
}
