import { plansOf, type End, type Plan } from '../engines/joints.js';
import { add, dot, length, rotate, scale, subtract } from '../../physics-core/base/math.js';
import type { CaseScene, Sight, Vec3 } from '../case.js';

const placed = ({ position, orientation }: Sight, { body }: End, own: Vec3): Vec3 =>
  body === undefined ? own : add(position(body), rotate(orientation(body), own));

const turned = ({ orientation }: Sight, { body }: End, own: Vec3): Vec3 =>
  body === undefined ? own : rotate(orientation(body), own);

/** Metres between the two halves of a joint; the way that it leaves free does not count. */
function gapOf(sight: Sight, { kind, ends: [a, b], spring }: Plan): number {
  const apart = subtract(placed(sight, a, a.anchor), placed(sight, b, b.anchor));
  if (kind !== 'slider' && !spring) return length(apart);
  const axis = turned(sight, a, a.axis);
  return length(subtract(apart, scale(axis, dot(apart, axis))));
}

/** Of a scene's joints, now. */
export function gapsIn(scene: CaseScene): (sight: Sight) => number[] {
  const { joints } = plansOf(scene);
  return (sight) => joints.map((plan) => gapOf(sight, plan));
}

/** The widest gap of a scene's joints, now. */
export function widestGap(scene: CaseScene): (sight: Sight) => number {
  const gaps = gapsIn(scene);
  return (sight) => Math.max(0, ...gaps(sight));
}
