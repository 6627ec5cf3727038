import { conjugate, dot, rotate, scale, subtract } from '../../physics-core/base/math.js';
import type { CaseBody, CaseScene, Sight, Vec3 } from '../case.js';
import { forceOn, massOf, momentsOf } from '../engines/bodies.js';

function energyOf(sight: Sight, body: CaseBody, gravity: Vec3): number {
  const { name, useGlobalGravity = true } = body;
  const [m, v] = [massOf(body), sight.linearVelocity(name)];
  const spin = rotate(conjugate(sight.orientation(name)), sight.angularVelocity(name));
  const moments = momentsOf(body);
  const turning = spin.reduce((sum, rate, i) => sum + moments[i]! * rate ** 2, 0);
  const weight: Vec3 = useGlobalGravity ? scale(gravity, m) : [0, 0, 0];
  const pull = subtract(scale(forceOn(body), -1), weight);
  return (m * dot(v, v) + turning) / 2 + dot(pull, sight.position(name));
}

/** Joules of motion, height and steady forces; springs keep theirs to themselves. */
export const energyIn = ({ bodies, gravity }: CaseScene, sight: Sight): number =>
  bodies
    .filter(({ fixed }) => !fixed)
    .reduce((sum, body) => sum + energyOf(sight, body, gravity), 0);
