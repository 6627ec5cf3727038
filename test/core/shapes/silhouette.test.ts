import assert from 'node:assert/strict';
import { test } from 'node:test';
import { meshes } from '../../../physics-core/shapes/meshes.js';
import { hullOf } from '../../../physics-core/shapes/hull.js';
import type { Mesh } from '../../../physics-core/shapes/geometry.js';
import { FacetSilhouette } from '../../../physics-core/shapes/silhouette/facets.js';
import { FrustumSilhouette } from '../../../physics-core/shapes/silhouette/frustum.js';
import { silhouetteOf } from '../../../physics-core/shapes/silhouette/of-outline.js';
import { SEEN, type Silhouette } from '../../../physics-core/shapes/silhouette/silhouette.js';
import { tessellate } from '../../../physics-core/shapes/tessellate.js';
import { turned } from '../../../physics-core/shapes/turned.js';
import { close, random, type Vec3 } from '../helpers.js';

await meshes.load();

// What is seen of a shape from far away: how much, and where its middle lies across the way of who looks.

const unit = (v: Vec3): Vec3 => v.map((x) => x / Math.hypot(...v)) as Vec3;

/** Area, and where the middle lies across the way. */
function seen(silhouette: Silhouette, along: Vec3): { area: number; middle: Vec3 } {
  const way = unit(along);
  const out = new Float64Array(SEEN);
  silhouette.along(Float64Array.from(way), out);
  const middle = [1, 2, 3].map((i) => out[i]! / out[0]!) as Vec3;
  const depth = middle.reduce((sum, x, i) => sum + x * way[i]!, 0);
  return { area: out[0]!, middle: middle.map((x, i) => x - depth * way[i]!) as Vec3 };
}

const draw = random(7);
const WAYS = Array.from({ length: 40 }, () => [draw() - 0.5, draw() - 0.5, draw() - 0.5] as Vec3);

/** The convex hull of a mesh, as shapes have it. */
const hull = ({ points }: Mesh): Silhouette =>
  silhouetteOf({ kind: 'hull', points, hull: hullOf(points) });

/** In single rays along z, as a grid through it has them. */
function counted({ points, index }: Mesh, size: number, cells: number): number {
  let count = 0;
  const at = Array.from({ length: points.length / 3 }, (_, i) => points.slice(3 * i, 3 * i + 3));
  const triangles = Array.from({ length: index.length / 3 }, (_, i) =>
    index.slice(3 * i, 3 * i + 3).map((corner) => at[corner] as Vec3),
  );
  for (let i = 0; i < cells; i++)
    for (let j = 0; j < cells; j++) {
      const x = size * ((i + 0.5) / cells - 0.5);
      const y = size * ((j + 0.5) / cells - 0.5);
      for (const corners of triangles) {
        const sides = corners.map(([px, py], n) => {
          const [qx, qy] = corners[(n + 1) % 3]!;
          return (qx - px) * (y - py) - (qy - py) * (x - px);
        });
        if (sides.every((side) => side >= 0) || sides.every((side) => side <= 0)) {
          count++;
          break;
        }
      }
    }
  return (count * size * size) / (cells * cells);
}

test('a box shows each of its faces by how far that is turned to who looks', () => {
  const box = silhouetteOf({ kind: 'box', half: [1, 2, 3] });
  close(seen(box, [1, 0, 0]).area, 24, 1e-12, 'm²');
  close(seen(box, [0, -2, 0]).area, 12, 1e-12, 'm²');
  for (const way of WAYS) {
    const one = seen(box, way);
    const other = seen(hull(tessellate({ type: 'Box', size: [2, 4, 6] })), way);
    close(one.area, other.area, 1e-12, 'm²');
    close(one.middle, [0, 0, 0], 1e-12, 'm');
    close(other.middle, [0, 0, 0], 1e-12, 'm');
  }
});

test('a ball shows its great circle, and what a map makes of it the disc that the map makes', () => {
  for (const way of WAYS)
    close(seen(silhouetteOf({ kind: 'ball', radius: 0.5 }), way).area, Math.PI / 4, 1e-12, 'm²');
  const egg = silhouetteOf({ kind: 'ellipsoid', squares: [1, 4, 9, 0, 0, 0] });
  close(seen(egg, [1, 0, 0]).area, 6 * Math.PI, 1e-12, 'm²');
  close(seen(egg, [0, 0, 1]).area, 2 * Math.PI, 1e-12, 'm²');
  // Turned by an eighth about z: of 1 and 4 the mean, and half of what they differ by.
  const turnedEgg = silhouetteOf({ kind: 'ellipsoid', squares: [2.5, 2.5, 9, 1.5, 0, 0] });
  close(seen(turnedEgg, [1, 1, 0]).area, 3 * Math.PI, 1e-12, 'm²');
  close(seen(turnedEgg, [1, -1, 0]).area, 6 * Math.PI, 1e-12, 'm²');
});

test('a cylinder shows a rectangle from the side, its disc from above, and between them both', () => {
  const cylinder = new FrustumSilhouette(0.5, 0.5, 1);
  close(seen(cylinder, [1, 0, 0]).area, 2, 1e-12, 'm²');
  close(seen(cylinder, [0, 1, 0]).area, Math.PI / 4, 1e-12, 'm²');
  close(seen(cylinder, [0, 1, 1]).area, (2 + Math.PI / 4) * Math.SQRT1_2, 1e-12, 'm²');
  for (const way of WAYS) close(seen(cylinder, way).middle, [0, 0, 0], 1e-12, 'm');
});

test('a cone shows a triangle from the side, and its base from above and from below', () => {
  const cone = new FrustumSilhouette(0.5, 0, 1);
  const side = seen(cone, [0, 0, -1]);
  close(side.area, 1, 1e-12, 'm²');
  close(side.middle, [0, -1 / 3, 0], 1e-12, 'm');
  for (const y of [1, -1]) {
    const base = seen(cone, [0, y, 0]);
    close(base.area, Math.PI / 4, 1e-12, 'm²');
    close(base.middle, [0, 0, 0], 1e-12, 'm');
  }
});

test('from anywhere a cone that is cut off or not shows what one of very many sides does', () => {
  const SIDES = 512;
  for (const [bottom, top, half] of [
    [0.7, 0.2, 0.5],
    [0.1, 1, 0.05],
    [1, 0, 0.3],
    [0.4, 0.4, 2],
  ] as const) {
    const points: number[] = [];
    for (let i = 0; i < SIDES; i++) {
      const angle = (2 * Math.PI * i) / SIDES;
      for (const [radius, y] of [
        [bottom, -half],
        [top, half],
      ])
        points.push(radius! * Math.cos(angle), y!, radius! * Math.sin(angle));
    }
    const many = hull({ points, index: [] });
    for (const way of WAYS) {
      const one = seen(new FrustumSilhouette(bottom, top, half), way);
      const other = seen(many, way);
      close(one.area, other.area, 1e-4 * other.area, 'm²');
      close(one.middle, other.middle, 1e-4, 'm');
    }
  }
});

test('an open sheet shows as much from behind, and a bowl from wherever what rays find of it', () => {
  const square = new FacetSilhouette([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]);
  for (const z of [1, -1]) {
    const { area, middle } = seen(square, [0, 0, z]);
    close(area, 1, 1e-12, 'm²');
    close(middle, [0.5, 0.5, 0], 1e-12, 'm');
  }
  // Half a sphere, the opening upwards; turned about x, so that who looks along z looks at it from there.
  const rings = Array.from({ length: 17 }, (_, i): [number, number] => {
    const angle = (Math.PI / 2) * (i / 16);
    return [Math.sin(angle), -Math.cos(angle)];
  });
  const bowl = turned(rings);
  for (const tilt of [0, 0.5, 1.2, 2, 2.8]) {
    const [c, s] = [Math.cos(tilt), Math.sin(tilt)];
    const points = bowl.points.map((value, i) => {
      const [, y, z] = bowl.points.slice(i - (i % 3), i - (i % 3) + 3) as Vec3;
      return i % 3 === 0 ? value : i % 3 === 1 ? c * y - s * z : s * y + c * z;
    });
    const { area } = seen(new FacetSilhouette(points, bowl.index), [0, 0, 1]);
    close(area, counted({ points, index: bowl.index }, 2.2, 60), 0.02 * area, 'm²');
  }
});

test('points in one plane are a sheet', () => {
  const flat = silhouetteOf({
    kind: 'hull',
    points: [0, 0, 0, 2, 0, 0, 2, 0, 1, 0, 0, 1],
    hull: undefined,
  });
  const { area, middle } = seen(flat, [0, -1, 0]);
  close(area, 2, 1e-12, 'm²');
  close(middle, [1, 0, 0.5], 1e-12, 'm');
  assert.equal(seen(flat, [1, 0, 0]).area, 0);
});
