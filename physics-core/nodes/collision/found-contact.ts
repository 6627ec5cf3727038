import type { ContactPoint } from '../../engine/contact-point.js';
import { add } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Collidable } from '../../dynamics/collidable.js';
import { carriedBy } from '../../dynamics/contact-order.js';
import { PLAIN } from '../../dynamics/contact-parameters.js';
import { firstDirection } from '../../effects/contacts/friction-directions.js';
import { frictionOf } from '../../effects/contacts/parameters.js';
import type { Value } from '../../fields/types.js';
import type { NodeWorld } from '../node/node-world.js';
import type { PhysicsNode } from '../node/node.js';
import { contact } from './contact.js';
import { ContactNode } from './contact-node.js';

/** Fields that a Contact copies from the collection that speaks for its pair, by the Contact's name. */
const COPIED: Record<string, string> = {
  appliedParameters: 'appliedParameters',
  bounce: 'bounce',
  minBounceSpeed: 'minBounceSpeed',
  slipCoefficients: 'slipFactors',
  softnessConstantForceMix: 'softnessConstantForceMix',
  softnessErrorCorrection: 'softnessErrorCorrection',
  surfaceSpeed: 'surfaceSpeed',
};

/** A Contact node for a point of Bullet's. It belongs to no list of the world, and goes with its last holder. */
export function foundContact(
  world: NodeWorld,
  point: ContactPoint,
  a: Body,
  b: Body,
  geometryA: Collidable,
  geometryB: Collidable,
): ContactNode {
  const first = carriedBy(a, b) === a;
  const fields = {
    body1: bodyOf(first ? a : b),
    body2: bodyOf(first ? b : a),
    geometry1: first ? geometryA : geometryB,
    geometry2: first ? geometryB : geometryA,
    position: add(point.positionVector(), world.poses.origin),
    contactNormal: point.normalVector(first ? 1 : -1),
    frictionDirection: firstDirection(point),
    depth: -point.distance,
    ...parametersOf(world, geometryA, geometryB),
  };
  // It can't be asked for by number.
  const collection = collectionOf(a) ?? collectionOf(b);
  return new ContactNode({ world, type: contact, id: 0, collection }, { pair: [a, b], fields });
}

const collectionOf = ({ standsFor }: Body): PhysicsNode | undefined =>
  (standsFor as PhysicsNode).collection;

const bodyOf = (body: Body): Body | null => (body.isObstacle ? null : body);

function parametersOf(world: NodeWorld, a: Collidable, b: Collidable): Record<string, Value> {
  const collection = world.pairs.between(a, b);
  if (!collection) return { frictionCoefficients: PLAIN.friction };
  const copied = Object.entries(COPIED).map(([to, from]) => [to, collection.asked(from)]);
  return {
    ...Object.fromEntries(copied),
    frictionCoefficients: frictionOf(collection),
  };
}
