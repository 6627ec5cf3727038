import type { JointNode } from './joint.js';
import type { Field } from './table.js';

const bodies = (joint: JointNode): void => joint.updateBodies();

/** Fields of X3DRigidJointNode (37.3.3). */
export const jointFields: Record<string, Field<JointNode>> = {
  body1: {
    type: 'SFNode',
    access: 'inputOutput',
    default: null,
    nodes: ['RigidBody'],
    edit: 'live',
    patch: bodies,
    doc: 'The first body; without it the other side is the world.',
  },
  body2: {
    type: 'SFNode',
    access: 'inputOutput',
    default: null,
    nodes: ['RigidBody'],
    edit: 'live',
    patch: bodies,
    doc: 'The second body; without it the other side is the world.',
  },
  forceOutput: {
    type: 'MFString',
    access: 'inputOutput',
    default: ['NONE'],
    edit: 'passive',
    doc: 'Which outputs are computed and sent: NONE, ALL, or their names.',
  },
};

const rezero = (joint: JointNode): void => joint.rezero();

/** Fields of joints that have a place. */
export const anchorFields: Record<string, Field<JointNode>> = {
  anchorPoint: {
    type: 'SFVec3f',
    access: 'inputOutput',
    default: [0, 0, 0],
    dimension: { length: 1 },
    edit: 'live',
    patch: rezero,
    doc: 'Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew.',
  },
  body1AnchorPoint: {
    type: 'SFVec3f',
    access: 'outputOnly',
    default: [0, 0, 0],
    dimension: { length: 1 },
    edit: 'passive',
    read: (joint) => joint.anchorOn(1),
    doc: 'The anchor as body1 carries it, world frame.',
  },
  body2AnchorPoint: {
    type: 'SFVec3f',
    access: 'outputOnly',
    default: [0, 0, 0],
    dimension: { length: 1 },
    edit: 'passive',
    read: (joint) => joint.anchorOn(2),
    doc: 'The anchor as body2 carries it; apart from body1AnchorPoint the joint gapes.',
  },
};

/** For tables that list it beside their own fields. */
export const rezeroPatch = rezero;
