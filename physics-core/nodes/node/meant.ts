import { nearest } from '../../base/nearest.js';
import { byName } from './table.js';

/** Everyday words, and those of other engines, for fields of X3D. */
const SYNONYMS = byName({
  anchor: 'anchorPoint',
  draggable: 'draggable-body',
  friction: 'frictionCoefficients',
  kinematic: 'fixed',
  restitution: 'bounce',
  rotation: 'orientation',
  static: 'fixed',
  torque: 'axis1Torque',
  translation: 'position',
  velocity: 'linearVelocity',
  weight: 'mass',
});

/** Fields that are looked for at bodies and hinges, and the node that has them. */
const ELSEWHERE = byName({
  axis1Torque: 'MotorJoint',
  bounce: 'CollisionCollection',
  frictionCoefficients: 'CollisionCollection',
  gravity: 'RigidBodyCollection',
});

/** What a message adds to a name that is none of `names`: the one that was probably meant, if there is one. */
export function meant(name: string, names: readonly string[]): string {
  const word = SYNONYMS[name.toLowerCase()] ?? name;
  const near = names.includes(word) ? word : nearest(name, names);
  if (near) return `; did you mean ${near}?`;
  return ELSEWHERE[word] ? `; ${ELSEWHERE[word]} has ${word}` : '';
}
