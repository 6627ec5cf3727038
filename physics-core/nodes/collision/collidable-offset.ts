import { CollidableOffsetNode } from './collidable.js';
import { collidableFields } from './collidable-shape.js';
import { defineNode } from '../node/define.js';

export const collidableOffset = defineNode<CollidableOffsetNode>({
  name: 'CollidableOffset',
  containerField: 'children',
  clause: '37.4.2',
  doc: 'Places one collidable away from the origin of its body: the way to build compound bodies.',
  rank: 1,
  bounded: true,
  make: (context) => new CollidableOffsetNode(context),
  fields: {
    ...collidableFields,
    collidable: {
      type: 'SFNode',
      access: 'initializeOnly',
      default: null,
      nodes: ['CollidableShape', 'CollidableOffset'],
      edit: 'live',
      patch: (offset) => offset.updateChild(),
      doc: 'The collidable that is placed.',
    },
  },
});
