import { geometryTypes, type Geometry } from '../../shapes/geometry.js';
import { codeFor } from '../../shapes/meshes.js';
import { CollidableShapeNode, type CollidableNode } from './collidable.js';
import { defineNode } from '../node/define.js';
import type { Field } from '../node/table.js';

const changed = (collidable: CollidableNode): void => collidable.changed();

/** Fields of X3DNBodyCollidableNode. */
export const collidableFields: Record<string, Field<CollidableNode>> = {
  enabled: {
    type: 'SFBool',
    access: 'inputOutput',
    default: true,
    edit: 'live',
    patch: changed,
    doc: 'FALSE takes it out of collision; it is still drawn.',
  },
  translation: {
    type: 'SFVec3f',
    access: 'inputOutput',
    default: [0, 0, 0],
    dimension: { length: 1 },
    edit: 'live',
    patch: changed,
    doc: 'Place, metres. In a body it is the body that says where; in a CollidableOffset it is the offset.',
  },
  rotation: {
    type: 'SFRotation',
    access: 'inputOutput',
    default: [0, 0, 1, 0],
    dimension: { angle: 1 },
    edit: 'live',
    patch: changed,
    doc: 'Orientation, axis and angle in radians; as translation.',
  },
};

export const collidableShape = defineNode<CollidableShapeNode>({
  name: 'CollidableShape',
  containerField: 'children',
  clause: '37.4.3',
  doc: 'The shape that collides, and that is drawn where it stands in the scene.',
  rank: 1,
  bounded: true,
  needs: (collidable) => [codeFor(collidable.asked<Geometry[]>('shape'))],
  make: (context) => new CollidableShapeNode(context),
  fields: {
    ...collidableFields,
    shape: {
      type: 'MFNode',
      access: 'initializeOnly',
      default: [],
      nodes: [...geometryTypes],
      edit: 'live',
      patch: (collidable) => collidable.updateShape(),
      doc: 'The Shape whose geometry collides.',
    },
  },
});
