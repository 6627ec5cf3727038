// Effects whose code weighs something come together with those that the same things cause.
import { Chunk } from '../../base/chunk.js';

export const joints = new Chunk('joints', 'a joint');

export const contacts = new Chunk(
  'contacts',
  'a second RigidBody in the same world, a CollisionCollection, a CollisionSensor or a Contact',
);
