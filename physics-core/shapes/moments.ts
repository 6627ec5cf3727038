import { IDENTITY, rotate, type Pose, type Quaternion } from '../base/math.js';
import type { Vec3 } from '../fields/types.js';
import type { Geometry } from './geometry.js';
import { inertiaAbout, principal, solidOf, type PlacedSolid, type Solid } from './mass.js';

/** A geometry where it stands in its body. */
interface Placed {
  readonly geometry: Geometry;
  readonly pose: Pose;
}

/** Principal moments, and the frame they belong to. */
export interface Moments {
  moments: Vec3;
  frame: Quaternion;
}

/** Of the solids that these geometries enclose: `mass` spread evenly over their volume, about `center`. */
export const momentsOf = (parts: readonly Placed[], mass: number, center: Vec3): Moments =>
  spread(
    parts.map(({ geometry, pose }) => place(pose, solidOf(geometry))),
    mass,
    center,
  );

/** The same of a model, which gives the distribution about the centre of mass, wherever its own origin lies. */
export const momentsOfModel = (model: Geometry, mass: number, center: Vec3): Moments =>
  spread([place({ p: center, q: IDENTITY }, centered(solidOf(model)))], mass, center);

const spread = (solids: PlacedSolid[], mass: number, center: Vec3): Moments =>
  principal(inertiaAbout(solids, mass, center));

const place = ({ p, q }: Pose, solid: Solid): PlacedSolid => ({
  solid,
  origin: p,
  axes: [rotate(q, [1, 0, 0]), rotate(q, [0, 1, 0]), rotate(q, [0, 0, 1])],
});

const centered = (solid: Solid): Solid => ({ ...solid, centroid: [0, 0, 0] });
