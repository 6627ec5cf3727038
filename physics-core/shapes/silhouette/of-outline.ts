import { meshes } from '../meshes.js';
import type { Outline } from '../outline.js';
import { BallSilhouette, BoxSilhouette, EllipsoidSilhouette } from './centred.js';
import { FacetSilhouette } from './facets.js';
import { FrustumSilhouette } from './frustum.js';
import type { Silhouette } from './silhouette.js';

export function silhouetteOf(outline: Outline): Silhouette {
  switch (outline.kind) {
    case 'box':
      return new BoxSilhouette(outline.half);
    case 'ball':
      return new BallSilhouette(outline.radius);
    case 'frustum':
      return new FrustumSilhouette(outline.bottom, outline.top, outline.half);
    case 'ellipsoid':
      return new EllipsoidSilhouette(outline.squares);
    case 'hull':
      return outline.hull
        ? new FacetSilhouette(outline.points, outline.hull.triangles.flat())
        : sheet(outline.points);
    case 'triangles':
      return new FacetSilhouette(outline.mesh.points, outline.mesh.index);
  }
}

/** Points in one plane: one of its two faces. */
function sheet(flat: readonly number[]): Silhouette {
  const { points, faces } = meshes.code.facesOf(flat, undefined);
  const corners = faces[0] ?? [];
  return new FacetSilhouette(
    points,
    corners.slice(2).flatMap((corner, i) => [corners[0]!, corners[i + 1]!, corner]),
  );
}
