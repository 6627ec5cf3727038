import { compose, type Pose } from '../../base/math.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import { BELOW, CUT, PLANE, type Cuttable, type Flat } from '../../shapes/cut/cut.js';
import { cutOf } from '../../shapes/cut/of-outline.js';

/** A solid of a body, how its frame is turned in that of the centre of mass, by rows, and where it stands there. */
interface Part {
  readonly solid: Cuttable;
  readonly rows: Flat;
  readonly place: Pose['p'];
}

const plane = new Float64Array(4);
const below = new Float64Array(CUT);

/** What a plane cuts off a body: its parts add up, and where they overlap they count twice. */
export class CutBody implements Cuttable {
  readonly #parts: readonly Part[];

  /** `intoFrame`: into that of the centre of mass. */
  constructor(parts: readonly CollidablePart[], intoFrame: Pose) {
    this.#parts = parts.flatMap(({ outline, pose }): Part[] => {
      const solid = outline && cutOf(outline);
      if (!solid) return [];
      const { p, q } = compose(intoFrame, pose);
      const rows = new Float64Array(MATRIX);
      writeMatrix(rows, 0, q, 0);
      return [{ solid, rows, place: p }];
    });
  }

  below(from: Flat, out: Flat): void {
    out.fill(0, 0, CUT);
    for (const { solid, rows, place } of this.#parts) {
      let offset = from[PLANE.offset]!;
      for (let k = 0; k < 3; k++) {
        plane[k] = rows[k]! * from[0]! + rows[3 + k]! * from[1]! + rows[6 + k]! * from[2]!;
        offset -= from[k]! * place[k]!;
      }
      plane[PLANE.offset] = offset;
      solid.below(plane, below);
      const volume = below[BELOW.volume]!;
      out[BELOW.volume] = out[BELOW.volume]! + volume;
      out[BELOW.area] = out[BELOW.area]! + below[BELOW.area]!;
      for (let k = 0; k < 3; k++) {
        const row = 3 * k;
        const turned =
          rows[row]! * below[1]! + rows[row + 1]! * below[2]! + rows[row + 2]! * below[3]!;
        out[BELOW.moment + k] = out[BELOW.moment + k]! + volume * place[k]! + turned;
      }
    }
  }
}
