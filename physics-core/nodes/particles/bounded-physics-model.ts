import { geometryTypes } from '../../shapes/geometry.js';
import { defineNode } from '../node/define.js';
import { codeOf } from './mesh.js';
import { changed, modelFields } from './model-fields.js';
import { BoundedModelNode } from './model-node.js';

export const boundedPhysicsModel = defineNode<BoundedModelNode>({
  name: 'BoundedPhysicsModel',
  containerField: 'physics',
  clause: '40.4.1',
  doc: 'A surface that particles bounce off, from both of its sides.',
  rank: 4,
  needs: (model) => codeOf(model.asked('geometry')),
  make: (context) => new BoundedModelNode(context),
  fields: {
    ...modelFields,
    geometry: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: [...geometryTypes],
      edit: 'live',
      patch: changed,
      doc: 'The geometry that particles bounce off, in the frame of their system.',
    },
  },
});
