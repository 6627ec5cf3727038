import type { Ammo } from '../engine/ammo.js';
import { hullMarginFor, THINNEST, type Shaped, type Workshop } from './build.js';
import { isConvex } from './convex.js';
import { squaresOf } from './ellipsoid.js';
import type { Geometry, Mesh } from './geometry.js';
import { hullOf, type Hull } from './hull.js';
import { boundsOf } from './bounds.js';
import { tessellate } from './tessellate.js';

type BtMesh = Ammo['btTriangleMesh']['prototype'];

/** A moving mesh rests this far above the ground, metres. */
const MOVING_MESH_MARGIN = 0.001;

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

/** A geometry by its triangles; undefined where nothing is there that could collide. */
export function meshShapeOf(g: Geometry, exact: boolean, workshop: Workshop): Shaped | undefined {
  const mesh = tessellate(g);
  if (mesh.points.length === 0 || mesh.index.length === 0) {
    workshop.note('zero-volume');
    return undefined;
  }
  workshop.note('mesh');
  const squares = squaresOf(g);
  if (squares)
    return {
      ...hull(mesh, hullOf(mesh.points), workshop),
      outline: { kind: 'ellipsoid', squares },
    };
  if (!workshop.moving) return triangles(mesh, workshop);
  const outline = hullOf(mesh.points);
  if (isConvex(mesh, outline)) return hull(mesh, outline, workshop);
  if (exact) return movingTriangles(mesh, workshop);
  workshop.note('concave-dynamic');
  return hull(mesh, outline, workshop);
}
