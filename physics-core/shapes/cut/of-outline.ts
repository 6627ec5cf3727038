import type { Outline } from '../outline.js';
import { boxFacets } from '../skin/box.js';
import { ballCut, EllipsoidCut } from './ball.js';
import type { Cuttable } from './cut.js';
import { FacetCut } from './facets.js';
import { FrustumCut } from './frustum.js';

/** Undefined: it has no inside. */
export function cutOf(outline: Outline): Cuttable | undefined {
  switch (outline.kind) {
    case 'box':
      return boxCut(outline.half);
    case 'ball':
      return ballCut(outline.radius);
    case 'frustum':
      return new FrustumCut(outline.bottom, outline.top, outline.half);
    case 'ellipsoid':
      return new EllipsoidCut(outline.squares);
    case 'hull':
      return outline.hull && new FacetCut(outline.points, outline.hull.triangles.flat());
    case 'triangles':
      return new FacetCut(outline.mesh.points, outline.mesh.index);
  }
}

const boxCut = (half: readonly number[]): Cuttable => {
  const { points, index } = boxFacets(half);
  return new FacetCut(points, index);
};
