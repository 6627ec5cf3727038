import { cos, sin } from '../base/exact/index.js';
import type { Vec3 } from '../fields/types.js';
import type { Geometry, Mesh } from './geometry.js';
import { facesOf } from './faces.js';
import { SIDES, turned } from './turned.js';

/** Only triangles whose three points exist. */
function sound(mesh: Mesh): Mesh {
  const count = Math.floor(mesh.points.length / 3);
  const index: number[] = [];
  for (let i = 0; i + 2 < mesh.index.length; i += 3) {
    const triangle = mesh.index.slice(i, i + 3);
    if (triangle.every((k) => k >= 0 && k < count)) index.push(...triangle);
  }
  return { points: mesh.points, index };
}

const box = ([x, y, z]: Vec3): Mesh => ({
  points: [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    (i & 1 ? x : -x) / 2,
    (i & 2 ? y : -y) / 2,
    (i & 4 ? z : -z) / 2,
  ]),
  index: [
    0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3,
    7, 1, 7, 5,
  ],
});

function sphere(radius: number): Mesh {
  const rings = SIDES / 2;
  const profile = Array.from({ length: rings + 1 }, (_, i): [number, number] => {
    const angle = (Math.PI * i) / rings;
    return [radius * sin(angle), -radius * cos(angle)];
  });
  return turned(profile);
}

function cylinder(g: Extract<Geometry, { type: 'Cylinder' }>): Mesh {
  const [r, h] = [g.radius ?? 1, (g.height ?? 2) / 2];
  const parts: [number, number][][] = [];
  if (g.bottom !== false)
    parts.push([
      [0, -h],
      [r, -h],
    ]);
  if (g.side !== false)
    parts.push([
      [r, -h],
      [r, h],
    ]);
  if (g.top !== false)
    parts.push([
      [r, h],
      [0, h],
    ]);
  return merged(parts.map(turned));
}

function cone(g: Extract<Geometry, { type: 'Cone' }>): Mesh {
  const [r, tip, h] = [g.bottomRadius ?? 1, g.topRadius ?? 0, (g.height ?? 2) / 2];
  const parts: [number, number][][] = [];
  if (g.bottom !== false)
    parts.push([
      [0, -h],
      [r, -h],
    ]);
  if (g.side !== false)
    parts.push([
      [r, -h],
      [tip, h],
    ]);
  if (tip > 0 && g.top !== false)
    parts.push([
      [tip, h],
      [0, h],
    ]);
  return merged(parts.map(turned));
}

function merged(meshes: Mesh[]): Mesh {
  const points: number[] = [];
  const index: number[] = [];
  for (const mesh of meshes) {
    const first = points.length / 3;
    points.push(...mesh.points);
    index.push(...mesh.index.map((i) => i + first));
  }
  return { points, index };
}

/** The 3 × 3 `linear` on every point. A mirror turns the triangles round, so that they still face outward. */
function transformed(mesh: Mesh, m: number[] | undefined): Mesh {
  if (!m) return mesh;
  const points: number[] = [];
  for (let i = 0; i < mesh.points.length; i += 3) {
    const [x, y, z] = [mesh.points[i]!, mesh.points[i + 1]!, mesh.points[i + 2]!];
    for (let r = 0; r < 9; r += 3) points.push(m[r]! * x + m[r + 1]! * y + m[r + 2]! * z);
  }
  const determinant =
    m[0]! * (m[4]! * m[8]! - m[5]! * m[7]!) -
    m[1]! * (m[3]! * m[8]! - m[5]! * m[6]!) +
    m[2]! * (m[3]! * m[7]! - m[4]! * m[6]!);
  return { points, index: determinant < 0 ? mesh.index.toReversed() : mesh.index };
}

function plain(g: Geometry): Mesh {
  switch (g.type) {
    case 'Box':
      return box(g.size ?? [2, 2, 2]);
    case 'Sphere':
      return sphere(g.radius ?? 1);
    case 'Cylinder':
      return cylinder(g);
    case 'Cone':
      return cone(g);
    default:
      return facesOf(g);
  }
}

/** Any geometry as triangles facing outward, in the frame of its collidable before translation and rotation. */
export function tessellate(g: Geometry): Mesh {
  const mesh = sound(plain(g));
  const outward =
    'ccw' in g && g.ccw === false ? { ...mesh, index: mesh.index.toReversed() } : mesh;
  return transformed(outward, g.linear);
}
