import type { World } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import { planBody } from './plan-body.js';
import { planOffset, planShape } from './plan-collidable.js';
import { planColliders, planCollection, planSensor, planSpace } from './plan-collection.js';
import { planJoint } from './plan-joint.js';
import type { Plan } from './plan.js';

export type Planner = (binding: Binding, world: World) => Plan | undefined;

/** By the names of their types; some come in a chunk. */
export const planners: Record<string, Planner> = {
  RigidBodyCollection: planCollection,
  RigidBody: planBody,
  CollidableShape: planShape,
  CollidableOffset: planOffset,
  CollisionCollection: planColliders,
  CollisionSpace: planSpace,
  CollisionSensor: planSensor,
};

/** What a node is to be, going by the document; undefined while something it needs is missing. */
export function planFor(binding: Binding, world: World): Plan | undefined {
  const planner = planners[binding.type.name] ?? planJoint;
  return planner(binding, world);
}
