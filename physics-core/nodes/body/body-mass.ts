import type { MassProperties } from '../../dynamics/body.js';
import type { Vec3 } from '../../fields/types.js';
import { guards } from '../../base/guards.js';
import type { Geometry } from '../../shapes/geometry.js';
import { principal, type Tensor } from '../../shapes/mass.js';
import { momentsOf, momentsOfModel, type Moments } from '../../shapes/moments.js';
import type { BodyNode } from './body.js';

/**
 * Least share of the largest moment that the smallest may be. Needles thinner than this spin up without bound in
 * single precision (measured: 17 000 rad/s at a ratio of 1e-8).
 */
const LEAST_MOMENT = 1e-4;

/** A density model gives them, else the shapes. */
function shapedMoments(body: BodyNode, mass: number, center: Vec3): Moments {
  const model = body.asked<Geometry | null>('massDensityModel');
  return model ? momentsOfModel(model, mass, center) : momentsOf(body.parts, mass, center);
}

function authoredTensor(body: BodyNode): Tensor {
  const m = body.asked<number[]>('inertia');
  const both = (i: number, j: number): number => (m[i]! + m[j]!) / 2;
  return [m[0]!, m[4]!, m[8]!, both(1, 3), both(2, 6), both(5, 7)];
}

/** An authored tensor stands where a body can have it; else the density model or the shapes give one. */
function authoredMoments(body: BodyNode): Moments | undefined {
  if (!body.authored('inertia')) return undefined;
  const found = principal(authoredTensor(body));
  if (guards.positive(found.moments)) {
    body.settle('inertia', 'out-of-range');
    return found;
  }
  body.report({
    code: 'out-of-range',
    severity: 'warning',
    attribute: 'inertia',
    value: body.asked('inertia'),
    used: 'the inertia of its geometry',
    message: `${body.label}: inertia has a principal moment of ${Math.min(...found.moments)} and must have three above zero; that of its geometry is used`,
  });
  return undefined;
}

export function reportZeroMass(body: BodyNode): void {
  if (body.asked<number>('mass') > 0) return;
  body.report({
    code: 'zero-mass',
    severity: 'info',
    attribute: 'mass',
    value: 0,
    used: 'fixed',
    message: `${body.label}: mass="0" makes it fixed`,
  });
}

export function massOf(body: BodyNode): MassProperties {
  const mass = body.asked<number>('mass') || 1;
  const center = [...body.asked<Vec3>('centerOfMass')] as Vec3;
  const { moments, frame } = authoredMoments(body) ?? shapedMoments(body, mass, center);
  const least = Math.max(...moments) * LEAST_MOMENT;
  return {
    mass,
    moments: moments.map((moment) => guards.leastMoment(moment, least)) as Vec3,
    centerOfMass: { p: center, q: frame },
  };
}
