import { contacts } from '../../effects/effect/chunks.js';
import { defineNode } from '../node/define.js';
import type { CollisionSpaceNode } from './collision-space-node.js';

const changed = (space: CollisionSpaceNode): void => space.changed();

export const collisionSpace = defineNode<CollisionSpaceNode>({
  name: 'CollisionSpace',
  containerField: 'collidables',
  clause: '37.4.6',
  doc: 'Collidables of a CollisionCollection that are switched on and off together.',
  rank: 1,
  chunk: contacts,
  bounded: true,
  fields: {
    enabled: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      edit: 'live',
      patch: changed,
      doc: 'FALSE: its collidables are in the collection only where they are in it by another way.',
    },
    collidables: {
      type: 'MFNode',
      access: 'inputOutput',
      default: [],
      nodes: ['CollidableShape', 'CollidableOffset', 'CollisionSpace'],
      takesAll: true,
      edit: 'live',
      patch: changed,
      doc: 'The members: collidables and further spaces; `*` means every collidable of the world.',
    },
    useGeometry: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      edit: 'live',
      patch: (space) => space.updateGeometry(),
      doc: 'FALSE: a moving mesh may collide as its convex hull. TRUE: its own triangles.',
    },
  },
});
