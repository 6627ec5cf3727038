import { compose, invert, type Pose } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Vec3 } from '../../fields/types.js';
import { axisScale } from '../../shapes/scale.js';

/** A solid whose nearest point is known in closed form. */
export interface HitShape {
  kind: 'ball' | 'box' | 'cylinder';
  /** Half its extents; those of a ball and of a cylinder, about y, are radii. */
  half: Vec3;
  /** Its frame in that of the centre of mass. */
  frame: Pose;
  /** A ball about the centre of mass: it does not matter how it turns. */
  central: boolean;
}

interface Known {
  centerOfMass: Pose;
  shape: HitShape | undefined;
}

/** A body whose mass or shape changes has another centre of mass or other parts. */
const known = new WeakMap<CollidablePart, Known>();

/** Undefined: only Bullet knows where it is nearest. */
export function hitShapeOf(part: CollidablePart, { centerOfMass }: Body): HitShape | undefined {
  const found = known.get(part);
  if (found?.centerOfMass === centerOfMass) return found.shape;
  const shape = shapeOf(part, centerOfMass);
  known.set(part, { centerOfMass, shape });
  return shape;
}

function shapeOf(part: CollidablePart, centerOfMass: Pose): HitShape | undefined {
  const half = halfOf(part);
  if (!half) return undefined;
  const kind = kinds[part.geometry.type]!;
  const frame = compose(invert(centerOfMass), part.pose);
  return { kind, half, frame, central: kind === 'ball' && !frame.p.some(Boolean) };
}

const kinds: Readonly<Partial<Record<string, HitShape['kind']>>> = {
  Sphere: 'ball',
  Box: 'box',
  Cylinder: 'cylinder',
};

/** As Bullet's shapes are made of them. */
function halfOf({ geometry, mesh }: CollidablePart): Vec3 | undefined {
  const scale = axisScale(geometry.linear);
  if (!scale || mesh) return undefined;
  const [x, y, z] = scale;
  switch (geometry.type) {
    case 'Sphere': {
      const r = (geometry.radius ?? 1) * x;
      return x === y && y === z ? [r, r, r] : undefined;
    }
    case 'Box': {
      const [w, h, d] = geometry.size ?? [2, 2, 2];
      return [(w * x) / 2, (h * y) / 2, (d * z) / 2];
    }
    case 'Cylinder': {
      if (x !== z || geometry.side === false) return undefined;
      if (geometry.top === false || geometry.bottom === false) return undefined;
      const r = (geometry.radius ?? 1) * x;
      return [r, ((geometry.height ?? 2) * y) / 2, r];
    }
    default:
      return undefined;
  }
}
