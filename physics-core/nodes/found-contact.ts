import type { ContactPoint } from '../engine/contact-point.js';
import { MANIFOLD_POINT as POINT } from '../engine/offsets.js';
import type { Value, Vec3 } from '../fields/types.js';
import type { BodyNode } from './body.js';
import type { CollidableNode } from './collidable.js';
import { contact, ContactNode } from './contact.js';
import { frictionOf, PLAIN } from '../dynamics/contact-parameters.js';
import { carriedBy } from '../dynamics/contact-order.js';
import { firstDirection } from '../effects/contacts/contact-rows.js';

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
  point: ContactPoint,
  a: BodyNode,
  b: BodyNode,
  geometryA: CollidableNode,
  geometryB: CollidableNode,
): ContactNode {
  const node = new ContactNode({
    world: a.world,
    type: contact,
    // It can't be asked for by number.
    id: 0,
    host: undefined,
    name: undefined,
    collection: a.collection ?? b.collection,
  });
  node.pair = [a, b];
  node.isChanged = false;
  const first = carriedBy(a, b) === a;
  const three = (offset: number, sign = 1): Vec3 => [
    point.get(offset, 0) * sign,
    point.get(offset, 1) * sign,
    point.get(offset, 2) * sign,
  ];
  const body = (one: BodyNode): BodyNode | null => (one.isObstacle ? null : one);
  node.found = {
    body1: body(first ? a : b),
    body2: body(first ? b : a),
    geometry1: first ? geometryA : geometryB,
    geometry2: first ? geometryB : geometryA,
    position: three(POINT.positionB),
    contactNormal: three(POINT.normalB, first ? 1 : -1),
    frictionDirection: firstDirection(point),
    depth: -point.distance,
    ...parametersOf(geometryA, geometryB),
  };
  return node;
}

function parametersOf(a: CollidableNode, b: CollidableNode): Record<string, Value> {
  const collection = a.world.pairs.between(a, b);
  if (!collection) return { frictionCoefficients: PLAIN.friction };
  const copied = Object.entries(COPIED).map(([to, from]) => [to, collection.asked(from)]);
  return { ...Object.fromEntries(copied), frictionCoefficients: frictionOf(collection) };
}
