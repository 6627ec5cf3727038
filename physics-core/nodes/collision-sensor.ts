import type { CollidableNode } from './collidable.js';
import type { CollisionCollectionNode } from './collision-collection.js';
import { PhysicsNode } from './node.js';
import { defineNode } from './table.js';

/** Tells whether members of a CollisionCollection touch, and which. */
export class CollisionSensorNode extends PhysicsNode {
  isActive = false;
  intersections: CollidableNode[] = [];

  get collider(): CollisionCollectionNode | undefined {
    return this.asked<CollisionCollectionNode | null>('collider') ?? undefined;
  }

  /** Reads contacts only while it has something to watch. */
  updateWatch(): void {
    const { contacts } = this.world.registry;
    if (this.collider && this.asked<boolean>('enabled')) {
      contacts.need(this, 'CollisionSensor');
      return;
    }
    contacts.drop(this);
    this.sense([]);
  }

  /** What touches after this step. Changes are sent; the end of contact sends the empty list once. */
  sense(touching: CollidableNode[]): void {
    const active = touching.length > 0;
    if (active || this.isActive) {
      this.intersections = touching;
      this.emit('intersections', touching);
    }
    if (active === this.isActive) return;
    this.isActive = active;
    this.emit('isActive', active);
  }

  protected override destroy(): void {
    this.world.registry.dropAll(this);
    this.isActive = false;
    this.intersections = [];
  }
}

const watch = (sensor: CollisionSensorNode): void => sensor.updateWatch();

export const collisionSensor = defineNode<CollisionSensorNode>({
  name: 'CollisionSensor',
  containerField: 'children',
  clause: '37.4.5',
  doc: 'Tells whether members of a CollisionCollection touch.',
  rank: 5,
  make: (context) => new CollisionSensorNode(context),
  fields: {
    collider: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['CollisionCollection'],
      edit: 'live',
      patch: watch,
      doc: 'The collection it watches; both members of a pair must be in it.',
    },
    enabled: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      edit: 'live',
      patch: watch,
      doc: 'FALSE: it sends nothing.',
    },
    isActive: {
      type: 'SFBool',
      access: 'outputOnly',
      default: false,
      edit: 'passive',
      read: (sensor) => sensor.isActive,
      doc: 'Whether anything touched in the last step.',
    },
    intersections: {
      type: 'MFNode',
      access: 'outputOnly',
      default: [],
      edit: 'passive',
      read: (sensor) => [...sensor.intersections],
      doc: 'The collidables that touch, each once.',
    },
  },
});
