import type { Ammo } from '../engine/ammo.js';
import type { Owner } from '../engine/owner.js';
import type { Scratch } from '../engine/scratch.js';
import type { Vec3 } from '../fields/types.js';
import { guards } from '../base/guards.js';
import type { Pose } from '../base/math.js';
import { isConvex } from './convex.js';
import type { Outline } from './outline.js';
import type { Geometry, Mesh } from './geometry.js';
import { hullOf, type Hull } from './hull.js';
import { boundsOf } from './mass.js';
import { axisScale } from './scale.js';
import { tessellate } from './tessellate.js';

export type BtShape = Ammo['btCollisionShape']['prototype'];
type BtMesh = Ammo['btTriangleMesh']['prototype'];

/** What the body should know of its shape: what came out different from the markup, and whether it took a mesh. */
export type ShapeNote = 'concave-dynamic' | 'zero-volume' | 'mesh';

/** A shape of Bullet's, and what it is exactly. */
interface Shaped {
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
const hullMarginFor = (halfExtent: number): number => Math.min(0.005, 0.02 * halfExtent);

/** A moving mesh rests this far above the ground, metres. */
const MOVING_MESH_MARGIN = 0.001;

/** Parts thinner than this (metres) are made this thick: Bullet's contact search needs a volume. */
const THINNEST = 1e-4;

function primitive(g: Geometry, scale: Vec3, workshop: Workshop): Shaped | undefined {
  const { ammo, scratch, owner } = workshop;
  const [x, y, z] = scale;
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
      if (x !== y || y !== z) return undefined;
      const radius = extent((g.radius ?? 1) * x);
      const shape = owner.own(new ammo.btSphereShape(radius));
      return { shape, outline: { kind: 'ball', radius } };
    }
    case 'Cylinder': {
      if (x !== z || g.side === false || g.top === false || g.bottom === false) return undefined;
      const [r, h] = [extent((g.radius ?? 1) * x), extent(((g.height ?? 2) * y) / 2)];
      const shape = owner.own(new ammo.btCylinderShape(scratch.vector(r, h, r)));
      shape.setMargin(marginFor(Math.min(r, h)));
      return { shape, outline: { kind: 'frustum', bottom: r, top: r, half: h } };
    }
    case 'Cone': {
      if (x !== z || g.topRadius || g.side === false || g.bottom === false) return undefined;
      const [r, h] = [extent((g.bottomRadius ?? 1) * x), extent((g.height ?? 2) * y)];
      const shape = owner.own(new ammo.btConeShape(r, h));
      shape.setMargin(hullMarginFor(Math.min(r, h / 2)));
      return { shape, outline: { kind: 'frustum', bottom: r, top: 0, half: h / 2 } };
    }
    default:
      return undefined;
  }
}

function smallestHalfExtent(points: number[]): number {
  const { min, max } = boundsOf(points);
  return Math.min(...max.map((value, i) => (value - min[i]!) / 2));
}

/** Bullet looks at every point in each of its searches: those inside, on edges or within faces would only cost. */
function hull(mesh: Mesh, outline: Hull | undefined, { ammo, scratch, owner }: Workshop): Shaped {
  const { points } = mesh;
  const shape = owner.own(new ammo.btConvexHullShape());
  const corners = outline?.corners ?? [...Array(points.length / 3).keys()];
  corners.forEach((corner, i) => {
    const [x, y, z] = points.slice(3 * corner, 3 * corner + 3);
    shape.addPoint(scratch.vector(x!, y!, z!), i === corners.length - 1);
  });
  shape.setMargin(Math.max(hullMarginFor(smallestHalfExtent(points)), THINNEST));
  return { shape, outline: { kind: 'hull', points, hull: outline } };
}

function triangleMesh(mesh: Mesh, { ammo, scratch, owner }: Workshop): BtMesh {
  const made = owner.own(new ammo.btTriangleMesh(true, false));
  const corner = (at: number, slot: number) =>
    scratch.vector(mesh.points[at * 3]!, mesh.points[at * 3 + 1]!, mesh.points[at * 3 + 2]!, slot);
  for (let i = 0; i < mesh.index.length; i += 3) {
    made.addTriangle(
      corner(mesh.index[i]!, 0),
      corner(mesh.index[i + 1]!, 1),
      corner(mesh.index[i + 2]!, 2),
      false,
    );
  }
  return made;
}

function triangles(mesh: Mesh, workshop: Workshop): Shaped {
  const { ammo, owner } = workshop;
  const shape = owner.own(
    new ammo.btBvhTriangleMeshShape(triangleMesh(mesh, workshop), true, true),
  );
  (shape as unknown as { setMargin(margin: number): void }).setMargin(0);
  return { shape, outline: { kind: 'triangles', mesh } };
}

/** Triangles that may move: hollow, and slower by far than a hull. */
function movingTriangles(mesh: Mesh, workshop: Workshop): Shaped {
  const { ammo, owner } = workshop;
  workshop.allowMovingMeshes();
  const shape = owner.own(new ammo.btGImpactMeshShape(triangleMesh(mesh, workshop)));
  shape.setMargin(MOVING_MESH_MARGIN);
  shape.updateBound();
  return { shape, outline: { kind: 'triangles', mesh } };
}

/** One geometry as a Bullet shape; undefined where nothing is there that could collide. */
function shapeOf(g: Geometry, exact: boolean, workshop: Workshop): Shaped | undefined {
  const scale = axisScale(g.linear);
  const simple = scale && primitive(g, scale, workshop);
  if (simple) return simple;
  const mesh = tessellate(g);
  if (mesh.points.length === 0 || mesh.index.length === 0) {
    workshop.note('zero-volume');
    return undefined;
  }
  workshop.note('mesh');
  if (!workshop.moving) return triangles(mesh, workshop);
  const outline = hullOf(mesh.points);
  if (isConvex(mesh, outline)) return hull(mesh, outline, workshop);
  if (exact) return movingTriangles(mesh, workshop);
  workshop.note('concave-dynamic');
  return hull(mesh, outline, workshop);
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
