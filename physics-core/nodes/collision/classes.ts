// What nodes of contacts are made of: the chunk `contacts` brings it.
import { collisionCollection } from './collision-collection.js';
import { CollisionCollectionNode } from './collision-collection-node.js';
import { collisionSensor } from './collision-sensor.js';
import { CollisionSensorNode } from './collision-sensor-node.js';
import { collisionSpace } from './collision-space.js';
import { CollisionSpaceNode } from './collision-space-node.js';
import { contact } from './contact.js';
import { ContactNode } from './contact-node.js';

export function provideCollisionNodes(): void {
  collisionCollection.make = (context) => new CollisionCollectionNode(context);
  collisionSensor.make = (context) => new CollisionSensorNode(context);
  collisionSpace.make = (context) => new CollisionSpaceNode(context);
  contact.make = (context) => new ContactNode(context);
}
