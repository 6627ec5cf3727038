import type { Field } from '../node/table.js';
import type { ModelNode } from './model-node.js';

export const changed = (model: ModelNode): void => model.changed();

/** Fields of X3DParticlePhysicsModelNode (40.3.2). */
export const modelFields: Record<string, Field<ModelNode>> = {
  enabled: {
    type: 'SFBool',
    access: 'inputOutput',
    default: true,
    edit: 'live',
    patch: changed,
    doc: 'FALSE: it does nothing to particles.',
  },
};
