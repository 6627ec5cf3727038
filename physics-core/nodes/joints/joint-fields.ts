import type { Vec3 } from '../../fields/types.js';
import { normalize } from '../../base/math.js';
import type { JointNode } from './joint.js';
import type { Doc, Field } from '../node/table.js';

/** Fields of X3DRigidJointNode (37.3.3). */
export const jointFields: Record<string, Field<JointNode>> = {
  body1: {
    type: 'SFNode',
    access: 'inputOutput',
    default: null,
    nodes: ['RigidBody'],
    edit: 'rebuild',
    doc: 'The first body; without it the other side is the world.',
  },
  body2: {
    type: 'SFNode',
    access: 'inputOutput',
    default: null,
    nodes: ['RigidBody'],
    edit: 'rebuild',
    doc: 'The second body; without it the other side is the world.',
  },
  forceOutput: {
    type: 'MFString',
    access: 'inputOutput',
    default: ['NONE'],
    edit: 'passive',
    doc: 'Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case.',
  },
};

/** Fields of joints that have a place. */
export const anchorFields: Record<string, Field<JointNode>> = {
  anchorPoint: {
    type: 'SFVec3f',
    access: 'inputOutput',
    default: [0, 0, 0],
    dimension: { length: 1 },
    edit: 'rebuild',
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

/** A direction given in the world when the joint is made; X3D 3.x has no direction as its default. */
export const axisField = (value: Vec3, { doc }: Doc): Field<JointNode> => ({
  type: 'SFVec3f',
  access: 'inputOutput',
  default: value,
  default3: [0, 0, 0],
  edit: 'rebuild',
  doc,
});

/** Where an axis of a joint with two of them points now. */
export const axisOutput = (which: 1 | 2, column: 0 | 2): Field<JointNode> => ({
  type: 'SFVec3f',
  access: 'outputOnly',
  default: [0, 0, 0],
  edit: 'passive',
  read: (joint) =>
    joint.placed ? joint.axisOn(which, column) : normalize(joint.asked<Vec3>(`axis${which}`)),
  doc: `Where axis${which} points now, as body${which} carries it: a unit vector, world frame.`,
});

/** A number that the simulation answers with. */
export function output<N extends JointNode>(
  read: (joint: N) => number,
  { doc }: Doc,
  dimension?: Field['dimension'],
): Field<N> {
  return {
    type: 'SFFloat',
    access: 'outputOnly',
    default: 0,
    ...(dimension && { dimension }),
    edit: 'passive',
    read,
    doc,
  };
}
