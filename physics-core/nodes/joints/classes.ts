// What joints are made of: the chunk `joints` brings it.
import { ballJoint } from './ball-joint.js';
import { BallJointNode } from './ball-joint-node.js';
import { doubleAxisHingeJoint } from './double-axis-hinge-joint.js';
import { DoubleAxisHingeJointNode } from './double-axis-hinge-joint-node.js';
import { motorJoint } from './motor-joint.js';
import { MotorJointNode } from './motor-joint-node.js';
import { singleAxisHingeJoint } from './single-axis-hinge-joint.js';
import { SingleAxisHingeJointNode } from './single-axis-hinge-joint-node.js';
import { sliderJoint } from './slider-joint.js';
import { SliderJointNode } from './slider-joint-node.js';
import { universalJoint } from './universal-joint.js';
import { UniversalJointNode } from './universal-joint-node.js';

export function provideJoints(): void {
  ballJoint.make = (context) => new BallJointNode(context);
  singleAxisHingeJoint.make = (context) => new SingleAxisHingeJointNode(context);
  doubleAxisHingeJoint.make = (context) => new DoubleAxisHingeJointNode(context);
  sliderJoint.make = (context) => new SliderJointNode(context);
  universalJoint.make = (context) => new UniversalJointNode(context);
  motorJoint.make = (context) => new MotorJointNode(context);
}
