import { IDENTITY, type Quaternion } from '../../../base/math.js';
import type { Vec3 } from '../../../fields/types.js';
import { principal } from '../../../shapes/mass.js';
import { meshes } from '../../../shapes/meshes.js';
import type { Outline } from '../../../shapes/outline.js';
import { BallSolid } from './ball.js';
import { BoxSolid } from './box.js';
import { EggSolid } from './egg.js';
import { FrustumSolid } from './frustum.js';
import { HullSolid } from './hull.js';
import { SheetSolid } from './sheet.js';
import type { Solid } from './solid.js';

/** A solid, and how its frame is turned in that of its part. */
export interface Turned {
  readonly solid: Solid;
  readonly turn: Quaternion;
}

/** A part whose shape is made again has another outline; triangles may be those of several. */
const known = new WeakMap<object, Turned>();

/** What ways meet of a part, made once. */
export function solidOf(outline: Outline): Turned {
  const key = outline.kind === 'triangles' ? outline.mesh : outline;
  let made = known.get(key);
  if (!made) known.set(key, (made = make(outline)));
  return made;
}

const straight = (solid: Solid): Turned => ({ solid, turn: IDENTITY });

function make(outline: Outline): Turned {
  switch (outline.kind) {
    case 'box':
      return straight(new BoxSolid(outline.half));
    case 'ball':
      return straight(new BallSolid(outline.radius));
    case 'frustum':
      return straight(new FrustumSolid(outline.bottom, outline.top, outline.half));
    case 'ellipsoid': {
      const { moments, frame } = principal(outline.squares);
      return { solid: new EggSolid(moments.map(Math.sqrt) as Vec3), turn: frame };
    }
    case 'hull': {
      const faces = meshes.code.facesOf(outline.points, outline.hull);
      if (outline.hull) return straight(new HullSolid(faces));
      // All in one plane: a sheet, of which one of both faces is enough.
      return straight(new SheetSolid(faces.points, fan(faces.faces[0] ?? [])));
    }
    case 'triangles':
      return straight(new SheetSolid(outline.mesh.points, outline.mesh.index));
  }
}

const fan = (corners: readonly number[]): number[] =>
  corners.slice(2).flatMap((corner, i) => [corners[0]!, corners[i + 1]!, corner]);
