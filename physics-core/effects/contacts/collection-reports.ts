import { cut } from '../../base/show.js';
import type { Reported } from '../effect/reported.js';
import type { ParameterNode } from '../effect/chunks.js';
import { unknownTokens } from './parameters.js';

/** Of what a collection says itself, or the contacts that it is given. */
const OF = {
  appliedParameters: 'appliedParameters has',
  set_contacts: 'the appliedParameters of a contact in set_contacts have',
};

export function reportTokens(
  node: Reported,
  unknown: readonly string[],
  attribute: keyof typeof OF,
): void {
  if (unknown.length === 0) return;
  node.reportWhile(true, {
    code: 'bad-value',
    severity: 'warning',
    attribute,
    value: unknown.join(' '),
    used: 'the others',
    message: `${node.label}: ${OF[attribute]} no ${cut(unknown.join(', '))}; the others are used`,
  });
}

/** Of contacts that a RigidBodyCollection is given: there and not at the contacts, which last a step only. */
export function reportGiven(giver: Reported, contacts: readonly ParameterNode[]): void {
  reportTokens(giver, [...new Set(contacts.flatMap(unknownTokens))], 'set_contacts');
}

/** Bullet's contacts are hard; the depth is made to follow the force, and what they would spring back is lost. */
export function reportSoftness(collection: Reported, softness: number): void {
  collection.reportWhile(softness !== 0, {
    code: 'approximated-field',
    severity: 'info',
    attribute: 'softnessConstantForceMix',
    value: softness,
    used: 'a contact that yields and does not spring back',
    message: `${collection.label}: under a body at rest soft contacts are as deep as the standard says (within 1 %), though no deeper than a quarter of the thinner body; they give back none of the energy of a hit, and stacked on each other they are as deep as that only roughly`,
  });
}

export function reportOneSided(collection: Reported, is: boolean): void {
  collection.reportWhile(is, {
    code: 'one-sided-collider',
    severity: 'warning',
    attribute: 'collidables',
    used: 'every pair with one member inside',
    message: `${collection.label} lists the collidables of one body only and yet says what its contacts are like; every pair with one member inside collides by it`,
  });
}

/** What says what contacts are like, of nobody. */
export function reportIdle(collection: Reported, is: boolean): void {
  collection.reportWhile(is, {
    code: 'idle-collection',
    severity: 'info',
    attribute: 'collidables',
    used: 'friction 0.5 and bounce 0, as without it',
    message: `${collection.label} has no collidables, and so speaks for no contact: collidables="*" are all of its world`,
  });
}
