import { defineNode } from '../node/define.js';
import { changed, modelFields } from './model-fields.js';
import { ForceModelNode } from './model-node.js';

export const forcePhysicsModel = defineNode<ForceModelNode>({
  name: 'ForcePhysicsModel',
  containerField: 'physics',
  clause: '40.4.4',
  doc: 'A force that is the same on every particle.',
  rank: 4,
  make: (context) => new ForceModelNode(context),
  fields: {
    ...modelFields,
    force: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, -9.8, 0],
      dimension: { force: 1 },
      edit: 'live',
      patch: changed,
      doc: 'Force on each particle, newtons, in the frame of their system; divided by its mass it is an acceleration.',
    },
  },
});
