import type { Field } from './table.js';

/** Of every X3D node. */
export const nodeFields: Record<string, Field> = {
  metadata: {
    type: 'SFNode',
    access: 'inputOutput',
    default: null,
    edit: 'passive',
    common: true,
    doc: 'Data about the node, for programs that read them.',
  },
};

/** Of X3DBoundedObject. Collision asks for none of them: what is invisible still collides. */
export const boundedFields: Record<string, Field> = {
  bboxCenter: {
    type: 'SFVec3f',
    access: 'initializeOnly',
    default: [0, 0, 0],
    dimension: { length: 1 },
    edit: 'passive',
    common: true,
    doc: 'Centre of the bounding box that the author states, metres.',
  },
  bboxSize: {
    type: 'SFVec3f',
    access: 'initializeOnly',
    default: [-1, -1, -1],
    dimension: { length: 1 },
    edit: 'passive',
    common: true,
    doc: 'Size of the bounding box that the author states, metres; -1 -1 -1 states none.',
  },
  bboxDisplay: {
    type: 'SFBool',
    access: 'inputOutput',
    default: false,
    edit: 'passive',
    common: true,
    doc: 'Whether the bounding box is drawn.',
  },
  visible: {
    type: 'SFBool',
    access: 'inputOutput',
    default: true,
    edit: 'passive',
    common: true,
    doc: 'Whether it is drawn; it collides either way.',
  },
};

/** For the nodes that have one: `...description`. */
export const description: Record<string, Field> = {
  description: {
    type: 'SFString',
    access: 'inputOutput',
    default: '',
    edit: 'passive',
    doc: 'What it is for, in words for people.',
  },
};
