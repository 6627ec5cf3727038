import { meshes, type Geometry } from '../../../../physics-core/inside.js';
import { onSolid } from './on-solid.js';
import type { SurfaceData, TextureOn } from './surface-data.js';

/** As its author says; else as X3D has it for what it is. `laid`: its points in the world. */
export function textureOn(
  laid: ArrayLike<number>,
  triangles: Int32Array,
  surface: SurfaceData | undefined,
): TextureOn {
  const { geometry, texture } = surface ?? {};
  if (texture?.faces)
    return {
      places: texture.places,
      index: byFaces(triangles, texture.faces.points, texture.faces.places),
    };
  if (texture) return { places: texture.places, index: triangles };
  const own = geometry && meshes.code.tessellate(geometry as Geometry).points;
  const points = own?.length === laid.length ? own : laid;
  return (
    onSolid(geometry?.type ?? '', points, triangles) ?? {
      places: overBox(points),
      index: triangles,
    }
  );
}

/** A triangle lies by the first face that has all of its points. */
function byFaces(triangles: Int32Array, points: number[], places: number[]): Int32Array {
  const index = new Int32Array(triangles.length);
  /** Of each point: where in the list it stands, by the number of the face. */
  const standing = new Map<number, Map<number, number>>();
  let face = 0;
  points.forEach((point, at) => {
    if (point < 0) return void face++;
    const faces = standing.get(point) ?? new Map<number, number>();
    standing.set(point, faces.set(face, at));
  });
  for (let n = 0; n + 2 < triangles.length; n += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => standing.get(triangles[n + k]!) ?? new Map());
    const found = [...a!.keys()].find((each) => b!.has(each) && c!.has(each)) as number;
    [a, b, c].forEach((faces, k) => (index[n + k] = places[faces!.get(found) as number] ?? 0));
  }
  return index;
}

/** Where nobody says it, as X3D has an IndexedFaceSet: along the longest side of its box, and as far along the next one. */
function overBox(laid: ArrayLike<number>): number[] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < laid.length; i++) {
    low[i % 3] = Math.min(low[i % 3]!, laid[i]!);
    high[i % 3] = Math.max(high[i % 3]!, laid[i]!);
  }
  const size = (axis: number): number => high[axis]! - low[axis]!;
  const [s, t] = [0, 1, 2].sort((a, b) => size(b) - size(a)) as [number, number];
  const longest = size(s) || 1;
  const places: number[] = [];
  for (let i = 0; i < laid.length; i += 3)
    places.push((laid[i + s]! - low[s]!) / longest, (laid[i + t]! - low[t]!) / longest);
  return places;
}
