import type { JointNode } from './joint.js';

/** Whether it is a joint whose code is here: told without the class, which comes with that. */
export const isJoint = (node: object): node is JointNode => 'lockedRows' in node;
