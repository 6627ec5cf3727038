import type initJolt from 'jolt-physics/wasm-compat';
import type { Vec3 } from '../case.js';
import { NotOffered } from './engine.js';
import type { End, Motor, Plan } from './joints.js';

export type Jolt = Awaited<ReturnType<typeof initJolt>>;

/** Makes vectors, and destroys them in the end. */
interface Maker {
  jolt: Jolt;
  vec(v: Vec3): InstanceType<Jolt['Vec3']>;
  place(v: Vec3): InstanceType<Jolt['RVec3']>;
}

type Axial = InstanceType<Jolt['HingeConstraintSettings'] | Jolt['SliderConstraintSettings']>;

/** What settings of all joints have. */
function placed<Settings extends Axial | InstanceType<Jolt['PointConstraintSettings']>>(
  maker: Maker,
  made: Settings,
  [b, a]: [End, End],
): Settings {
  made.mSpace = maker.jolt.EConstraintSpace_LocalToBodyCOM;
  made.mPoint1 = maker.place(a.anchor);
  made.mPoint2 = maker.place(b.anchor);
  return made;
}

/** What those about or along an axis have. */
function turned<Settings extends Axial>(maker: Maker, made: Settings, plan: Plan): Settings {
  const [b, a] = plan.ends;
  made.mNormalAxis1 = maker.vec(a.normal);
  made.mNormalAxis2 = maker.vec(b.normal);
  if (plan.stops) [made.mLimitsMin, made.mLimitsMax] = [plan.stops.low, plan.stops.high];
  return placed(maker, made, plan.ends);
}

function hinge(maker: Maker, plan: Plan) {
  const made = new maker.jolt.HingeConstraintSettings();
  const [b, a] = plan.ends;
  made.mHingeAxis1 = maker.vec(a.axis);
  made.mHingeAxis2 = maker.vec(b.axis);
  if (plan.motor) {
    made.mMotorSettings.mMinTorqueLimit = -plan.motor.most;
    made.mMotorSettings.mMaxTorqueLimit = plan.motor.most;
  }
  return turned(maker, made, plan);
}

function slider(maker: Maker, plan: Plan) {
  const made = new maker.jolt.SliderConstraintSettings();
  const [b, a] = plan.ends;
  made.mSliderAxis1 = maker.vec(a.axis);
  made.mSliderAxis2 = maker.vec(b.axis);
  return turned(maker, made, plan);
}

/** Settings of a constraint from the second body of a plan to the first. */
export function constraintOf(maker: Maker, plan: Plan) {
  if (plan.stops?.bounce) throw new NotOffered('stops that give back speed');
  if (plan.kind === 'hinge') return hinge(maker, plan);
  if (plan.kind === 'slider') return slider(maker, plan);
  if (plan.kind === 'ball')
    return placed(maker, new maker.jolt.PointConstraintSettings(), plan.ends);
  throw new NotOffered('universal joints');
}

export function drive(
  jolt: Jolt,
  constraint: InstanceType<Jolt['Constraint']>,
  { speed }: Motor,
): void {
  const made = jolt.castObject(constraint, jolt.HingeConstraint);
  made.SetMotorState(jolt.EMotorState_Velocity);
  made.SetTargetAngularVelocity(speed);
}
