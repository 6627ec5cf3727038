import type { Heights, Triangles } from '../case.js';
import { cornersOf, middleOf } from './bodies.js';
import type { BtShape, BulletScene } from './bullet-scene.js';

/** Bullet's y, as it counts axes. */
const UP = 1;

export function hullOf(scene: BulletScene, { coord }: Triangles): BtShape {
  const made = scene.owner.own(new scene.ammo.btConvexHullShape());
  for (const corner of cornersOf(coord)) made.addPoint(scene.vector(corner));
  return made;
}

export function meshOf(scene: BulletScene, { coord, index }: Triangles): BtShape {
  const { ammo, owner } = scene;
  const corners = cornersOf(coord).map((corner) => scene.vector(corner));
  const mesh = owner.own(new ammo.btTriangleMesh());
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = index.slice(i, i + 3).map((corner) => corners[corner]!);
    mesh.addTriangle(a!, b!, c!);
  }
  return owner.own(new ammo.btBvhTriangleMeshShape(mesh, true, true));
}

/** Bullet has a field about the middle of its box. It reads heights where they lie; this build gives no memory back. */
export function fieldOf(scene: BulletScene, grid: Heights): BtShape {
  const { ammo, owner } = scene;
  const { xDimension, zDimension, xSpacing, zSpacing, height } = grid;
  const [low, high] = [Math.min(...height), Math.max(...height)];
  const memory = ammo._malloc(4 * height.length);
  ammo.HEAPF32.set(height, memory >> 2);
  const size = [xDimension, zDimension] as const;
  const made = owner.own(
    new ammo.btHeightfieldTerrainShape(...size, memory, 1, low, high, UP, ammo.PHY_FLOAT, false),
  );
  made.setLocalScaling(scene.vector([xSpacing, 1, zSpacing]));
  const [x, , z] = middleOf(grid);
  const placed = owner.own(new ammo.btCompoundShape());
  scene.put(placed, made, [x, (low + high) / 2, z]);
  return placed;
}
