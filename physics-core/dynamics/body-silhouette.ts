import { compose, invert, type Pose } from '../base/math.js';
import { MATRIX, writeMatrix } from '../base/matrix.js';
import type { Body } from './body.js';
import type { CollidablePart } from './collidable.js';
import { silhouetteOf } from '../shapes/silhouette/of-outline.js';
import { SEEN, type Flat, type Silhouette } from '../shapes/silhouette/silhouette.js';

/** What is seen of a part, and how its frame is turned in that of the centre of mass, by rows, and where it stands there. */
interface Part {
  readonly silhouette: Silhouette;
  readonly rows: Flat;
  readonly place: Pose['p'];
}

const way = new Float64Array(3);
const seen = new Float64Array(SEEN);

/** What is seen of a body in the frame of its centre of mass: its parts add up, whichever hides another. */
export class BodySilhouette implements Silhouette {
  readonly #of: readonly CollidablePart[];
  readonly #centre: Pose;
  readonly #parts: readonly Part[];

  constructor({ solidParts, centerOfMass }: Body) {
    this.#of = solidParts;
    this.#centre = centerOfMass;
    const intoFrame = invert(centerOfMass);
    this.#parts = solidParts.flatMap(({ outline, pose }): Part[] => {
      if (!outline) return [];
      const { p, q } = compose(intoFrame, pose);
      const rows = new Float64Array(MATRIX);
      writeMatrix(rows, 0, q, 0);
      return [{ silhouette: silhouetteOf(outline), rows, place: p }];
    });
  }

  /** Whether it is that of the body as it is now. */
  isOf({ solidParts, centerOfMass }: Body): boolean {
    return this.#of === solidParts && this.#centre === centerOfMass;
  }

  along(from: Flat, out: Flat): void {
    out.fill(0);
    for (const { silhouette, rows, place } of this.#parts) {
      for (let k = 0; k < 3; k++)
        way[k] = rows[k]! * from[0]! + rows[3 + k]! * from[1]! + rows[6 + k]! * from[2]!;
      silhouette.along(way, seen);
      const area = seen[0]!;
      out[0] = out[0]! + area;
      for (let k = 0; k < 3; k++) {
        const row = 3 * k;
        const off = rows[row]! * seen[1]! + rows[row + 1]! * seen[2]! + rows[row + 2]! * seen[3]!;
        out[1 + k] = out[1 + k]! + area * place[k]! + off;
      }
    }
  }
}
