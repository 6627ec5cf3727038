import { cos, sin } from '../base/exact/index.js';
import type { Geometry, Mesh } from './geometry.js';
import { trianglesOfFace } from './polygon.js';
import { listsOf, trianglesOf } from './strips.js';
import { SIDES, turned } from './turned.js';

const pointsOf = (coord: number[] | { point: number[] } | undefined): number[] =>
  Array.isArray(coord) ? coord : (coord?.point ?? []);

function grid(
  xDimension: number,
  zDimension: number,
  xSpacing: number,
  zSpacing: number,
  height: number[],
): Mesh {
  const points: number[] = [];
  const index: number[] = [];
  for (let z = 0; z < zDimension; z++) {
    for (let x = 0; x < xDimension; x++) {
      points.push(x * xSpacing, height[z * xDimension + x] ?? 0, z * zSpacing);
      if (x === 0 || z === 0) continue;
      const here = z * xDimension + x;
      const [left, back, corner] = [here - 1, here - xDimension, here - xDimension - 1];
      index.push(corner, left, here, corner, here, back);
    }
  }
  return { points, index };
}

/** X3DOM's: the ring of radius `outer` about Z, its tube of radius `inner`. */
function torus(inner: number, outer: number): Mesh {
  const profile = Array.from({ length: SIDES + 1 }, (_, i): [number, number] => {
    const angle = (2 * Math.PI * i) / SIDES;
    return [outer + inner * cos(angle), inner * sin(angle)];
  });
  return turned(profile);
}

/** Turned so that its Y axis lies along Z. */
const upright = ({ points, index }: Mesh): Mesh => ({
  points: points.map((_, i) =>
    i % 3 === 1 ? -points[i + 1]! : i % 3 === 2 ? points[i - 1]! : points[i]!,
  ),
  index,
});

/** What is no solid of X3D: a geometry by the faces it is written as. */
export function facesOf(g: Geometry): Mesh {
  switch (g.type) {
    case 'IndexedFaceSet': {
      const points = pointsOf(g.coord);
      const faces = listsOf(g.coordIndex ?? []);
      return { points, index: faces.flatMap((face) => trianglesOfFace(points, face)) };
    }
    case 'IndexedTriangleSet':
      return { points: pointsOf(g.coord), index: g.index ?? [] };
    case 'TriangleSet':
    case 'TriangleStripSet':
    case 'TriangleFanSet':
    case 'QuadSet':
    case 'IndexedTriangleStripSet':
    case 'IndexedTriangleFanSet':
    case 'IndexedQuadSet': {
      const points = pointsOf(g.coord);
      const lists =
        'index' in g
          ? g.index
          : 'stripCount' in g
            ? g.stripCount
            : 'fanCount' in g
              ? g.fanCount
              : [];
      return { points, index: trianglesOf(g.type, lists ?? [], points) };
    }
    case 'Rectangle2D': {
      const [x, y] = (g.size ?? [2, 2]).map((value) => value / 2);
      return {
        points: [-x!, -y!, 0, x!, -y!, 0, x!, y!, 0, -x!, y!, 0],
        index: [0, 1, 2, 0, 2, 3],
      };
    }
    case 'Disk2D':
      return upright(
        turned([
          [g.outerRadius ?? 1, 0],
          [g.innerRadius ?? 0, 0],
        ]),
      );
    case 'Torus':
      return upright(torus(g.innerRadius ?? 0.5, g.outerRadius ?? 1));
    case 'ElevationGrid':
      return grid(
        g.xDimension ?? 0,
        g.zDimension ?? 0,
        g.xSpacing ?? 1,
        g.zSpacing ?? 1,
        g.height ?? [],
      );
    case 'Mesh':
      return { points: g.points ?? [], index: g.index ?? [] };
    default:
      return { points: [], index: [] };
  }
}
