import type { Tensor } from '../mass.js';
import type { Outline } from '../outline.js';
import { unitBall } from './ball.js';
import { boxFacets } from './box.js';
import { cornersOf } from './facets.js';
import { frustumSkin } from './frustum.js';

/** Triangles that bound a solid: the corners of each, x y z, seen against the clock from outside. */
export function skinOf(outline: Outline): number[] {
  switch (outline.kind) {
    case 'box':
      return cornersOf(boxFacets(outline.half));
    case 'ball':
      return unitBall().map((each) => each * outline.radius);
    case 'frustum':
      return frustumSkin(outline.bottom, outline.top, outline.half);
    case 'ellipsoid':
      return stretchedBall(outline.squares);
    case 'hull':
      return outline.hull
        ? cornersOf({ points: outline.points, index: outline.hull.triangles.flat() })
        : [];
    case 'triangles':
      return cornersOf(outline.mesh);
  }
}

/** Of the maps whose squares these are, all of which make the same of a ball, the one that is triangular. */
function stretchedBall([xx, yy, zz, xy, xz, yz]: Tensor): number[] {
  const a = Math.sqrt(xx);
  const b = xy / a;
  const c = xz / a;
  const d = Math.sqrt(yy - b * b);
  const e = (yz - b * c) / d;
  const f = Math.sqrt(zz - c * c - e * e);
  const ball = unitBall();
  const skin: number[] = [];
  for (let i = 0; i < ball.length; i += 3) {
    const x = ball[i]!;
    const y = ball[i + 1]!;
    const z = ball[i + 2]!;
    skin.push(a * x, b * x + d * y, c * x + e * y + f * z);
  }
  return skin;
}
