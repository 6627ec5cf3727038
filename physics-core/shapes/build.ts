import type { Ammo } from '../engine/ammo.js';
import type { Owner } from '../engine/owner.js';
import type { Scratch } from '../engine/scratch.js';
import { guards } from '../base/guards.js';
import type { Pose } from '../base/math.js';
import type { Outline } from './outline.js';
import type { Geometry } from './geometry.js';
import { isPrimitive, meshes } from './meshes.js';
import { axisScale } from './scale.js';

export type BtShape = Ammo['btCollisionShape']['prototype'];

/** What the body should know of its shape: what came out different from the markup, and whether it took a mesh. */
export type ShapeNote = 'concave-dynamic' | 'zero-volume' | 'mesh';

/** A shape of Bullet's, and what it is exactly. */
export interface Shaped {
  shape: BtShape;
  outline: Outline;
}

/** What shapes are made with. The owner is the body's: they live and die with its shape. */
export interface Workshop {
  ammo: Ammo;
  scratch: Scratch;
  owner: Owner;
  /** Bullet's triangle meshes only work on bodies that don't move. */
  moving: boolean;
  note(note: ShapeNote): void;
  /** Lets moving meshes meet other meshes. */
  allowMovingMeshes(): void;
}

/** Bullet keeps this margin inside boxes and cylinders; a thin part needs a thinner one (measured). */
const marginFor = (halfExtent: number): number => Math.min(0.04, 0.1 * halfExtent);

/** A hull, and Bullet's cone, grows by its margin: small enough not to be seen, large enough for a stable contact search. */
export const hullMarginFor = (halfExtent: number): number => Math.min(0.005, 0.02 * halfExtent);

/** Parts thinner than this (metres) are made this thick: Bullet's contact search needs a volume. */
export const THINNEST = 1e-4;

function primitive(g: Geometry, workshop: Workshop): Shaped | undefined {
  const { ammo, scratch, owner } = workshop;
  const [x, y, z] = axisScale(g.linear)!;
  /** A half extent or radius with a volume to collide with; reported where the author's has none. */
  const extent = (value: number): number => {
    if (!(value > 0)) workshop.note('zero-volume');
    return guards.thickness(Math.abs(value), THINNEST);
  };
  switch (g.type) {
    case 'Box': {
      const [w, h, d] = g.size ?? [2, 2, 2];
      const [hx, hy, hz] = [extent((w * x) / 2), extent((h * y) / 2), extent((d * z) / 2)];
      const shape = owner.own(new ammo.btBoxShape(scratch.vector(hx, hy, hz)));
      shape.setMargin(marginFor(Math.min(hx, hy, hz)));
      return { shape, outline: { kind: 'box', half: [hx, hy, hz] } };
    }
    case 'Sphere': {
      const radius = extent((g.radius ?? 1) * x);
      const shape = owner.own(new ammo.btSphereShape(radius));
      return { shape, outline: { kind: 'ball', radius } };
    }
    case 'Cylinder': {
      const [r, h] = [extent((g.radius ?? 1) * x), extent(((g.height ?? 2) * y) / 2)];
      const shape = owner.own(new ammo.btCylinderShape(scratch.vector(r, h, r)));
      shape.setMargin(marginFor(Math.min(r, h)));
      return { shape, outline: { kind: 'frustum', bottom: r, top: r, half: h } };
    }
    case 'Cone': {
      const [r, h] = [extent((g.bottomRadius ?? 1) * x), extent((g.height ?? 2) * y)];
      const shape = owner.own(new ammo.btConeShape(r, h));
      shape.setMargin(hullMarginFor(Math.min(r, h / 2)));
      return { shape, outline: { kind: 'frustum', bottom: r, top: 0, half: h / 2 } };
    }
    default:
      return undefined;
  }
}

/** One geometry as a Bullet shape; undefined where nothing is there that could collide. */
function shapeOf(g: Geometry, exact: boolean, workshop: Workshop): Shaped | undefined {
  return isPrimitive(g) ? primitive(g, workshop) : meshes.code.shapeOf(g, exact, workshop);
}

/** A geometry and the pose of its frame in the body's centre-of-mass frame. */
export interface PlacedGeometry {
  geometry: Geometry;
  pose: Pose;
  /** Its triangles are wanted where its hull would be fuller. */
  exact: boolean;
}

const isIdentity = ({ p, q }: Pose): boolean => p.every((value) => value === 0) && q[3] === 1;

/** A shape and, for each of its children in Bullet's order, the part it stands for and what it is exactly. */
export interface Built {
  shape: BtShape;
  made: { at: number; outline: Outline }[];
}

/** The whole shape of a body: one shape where it sits at the centre of mass, else a compound. */
export function buildShape(parts: PlacedGeometry[], workshop: Workshop): Built {
  const { ammo, owner, scratch } = workshop;
  const shapes: (Shaped & { at: number; pose: Pose })[] = [];
  parts.forEach(({ geometry, pose, exact }, at) => {
    const shaped = shapeOf(geometry, exact, workshop);
    if (shaped) shapes.push({ at, pose, ...shaped });
  });
  if (shapes.length === 1 && isIdentity(shapes[0]!.pose))
    return { shape: shapes[0]!.shape, made: shapes };
  // With its tree of boxes: Bullet lets two compounds without one pass through each other.
  const compound = owner.own(new ammo.btCompoundShape(true));
  for (const { shape, pose } of shapes)
    compound.addChildShape(scratch.transform(pose.p, pose.q), shape);
  return { shape: compound, made: shapes };
}
