import type { Vec3 } from '../fields/types.js';
import type { Mesh } from './geometry.js';
import type { Hull } from './hull.js';
import { BallForm } from './forms/ball.js';
import { BoxForm } from './forms/box.js';
import type { Form } from './forms/form.js';
import { FrustumForm } from './forms/frustum.js';
import { PolytopeForm } from './forms/polytope.js';
import type { Tensor } from './mass.js';
import { meshes } from './meshes.js';

/** What a shape of Bullet's stands for, exactly: without the margins that Bullet keeps inside or outside of it. */
export type Outline =
  | { kind: 'box'; half: Vec3 }
  | { kind: 'ball'; radius: number }
  | { kind: 'frustum'; bottom: number; top: number; half: number }
  | { kind: 'ellipsoid'; squares: Tensor }
  | { kind: 'hull'; points: number[]; hull: Hull | undefined }
  | { kind: 'triangles'; mesh: Mesh };

/** Of what is convex. */
export function formOf(outline: Outline): Form | undefined {
  switch (outline.kind) {
    case 'box':
      return new BoxForm(outline.half);
    case 'ball':
      return new BallForm(outline.radius);
    case 'frustum':
      return new FrustumForm(outline.bottom, outline.top, outline.half);
    case 'ellipsoid':
      return meshes.code.ellipsoid(outline.squares);
    case 'hull':
      return new PolytopeForm(meshes.code.facesOf(outline.points, outline.hull));
    default:
      return undefined;
  }
}
