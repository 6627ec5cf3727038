import {
  compose,
  conjugate,
  cross,
  dot,
  identityPose,
  invert,
  normalize,
  perpendicular,
  rotate,
  scale,
  subtract,
  type Pose,
} from '../../physics-core/base/math.js';
import type { CaseJoint, CaseScene, Vec3 } from '../case.js';
import { bodyNamed, poseOf } from './bodies.js';
import { NotOffered } from './engine.js';

/** Where a joint takes hold of a body (without one: of the world), in that body's frame. */
export interface End {
  body: string | undefined;
  anchor: Vec3;
  /** Of a hinge or slider; of a cross the arm that this body carries. */
  axis: Vec3;
  /** At right angles to `axis`, and in the world the same for both ends. */
  normal: Vec3;
}

/** Of body1's turn or way against body2. */
export interface Stops {
  low: number;
  high: number;
  bounce: number;
}

export interface Motor {
  /** Of body1 against body2, rad/s. */
  speed: number;
  /** Newton metres. */
  most: number;
}

/** Along the axis of a cross that body1 carries: N/m and N s/m. */
export interface Spring {
  stiffness: number;
  damping: number;
}

/** A joint in the words that engines have in common. */
export interface Plan {
  kind: 'ball' | 'hinge' | 'slider' | 'cross';
  ends: [End, End];
  stops?: Stops | undefined;
  motor?: Motor | undefined;
  spring?: Spring | undefined;
}

/** What page code has to do itself in every step: a torque or force along an axis of body1, and its opposite on body2. */
export interface Push {
  kind: 'torque' | 'force';
  body1: string;
  body2: string | undefined;
  /** In the frame of body1. */
  vector: Vec3;
}

export interface Plans {
  joints: Plan[];
  pushes: Push[];
}

const start = (scene: CaseScene, body: string | undefined): Pose =>
  body === undefined ? identityPose() : poseOf(bodyNamed(scene, body));

function endsOf(
  scene: CaseScene,
  { body1, body2 }: CaseJoint,
  anchor: Vec3,
  axes: [Vec3, Vec3] = [
    [0, 0, 1],
    [0, 0, 1],
  ],
): [End, End] {
  const normal = normalize(
    dot(axes[0], axes[1]) > 0.999 ? perpendicular(axes[0]) : cross(axes[0], axes[1]),
  );
  return [body1, body2].map((body, i): End => {
    const pose = start(scene, body);
    const turn = (v: Vec3): Vec3 => rotate(conjugate(pose.q), v);
    const at = compose(invert(pose), { p: anchor, q: [0, 0, 0, 1] }).p;
    return { body, anchor: at, axis: turn(axes[i]!), normal: turn(normal) };
  }) as [End, End];
}

type Fields = Record<string, unknown>;

/** Reads fields of a joint, and knows which were left unread: what is not understood must not be left out in silence. */
class Reader {
  readonly #joint: CaseJoint;
  readonly #unread: Set<string>;

  constructor(joint: CaseJoint) {
    this.#joint = joint;
    this.#unread = new Set(Object.keys(joint));
    for (const name of ['type', 'body1', 'body2']) this.#unread.delete(name);
  }

  get<T>(name: string, otherwise: T): T {
    this.#unread.delete(name);
    return ((this.#joint as Fields)[name] as T | undefined) ?? otherwise;
  }

  axis(name: string, otherwise: Vec3): Vec3 {
    return normalize(this.get<Vec3>(name, otherwise));
  }

  finish(): void {
    const [field] = this.#unread;
    if (field) throw new NotOffered(`${field} of a ${this.#joint.type}`);
  }
}

const NEARLY_PI = Math.PI - 1e-4;

function turnStops(read: Reader, n: '' | '1'): Stops | undefined {
  const low = read.get(`minAngle${n}`, -Math.PI);
  const high = read.get(`maxAngle${n}`, Math.PI);
  const bounce = read.get(n ? `stop${n}Bounce` : 'stopBounce', 0);
  read.get(n ? `stop${n}ErrorCorrection` : 'stopErrorCorrection', 0.8);
  if (n) read.get(`stop${n}ConstantForceMix`, 0);
  const none = low > high || (low <= -NEARLY_PI && high >= NEARLY_PI);
  return none ? undefined : { low, high, bounce };
}

function hinge(scene: CaseScene, joint: CaseJoint, read: Reader, plans: Plans): void {
  const axis = read.axis('axis', [0, 1, 0]);
  const ends = endsOf(scene, joint, read.get<Vec3>('anchorPoint', [0, 0, 0]), [axis, axis]);
  plans.joints.push({ kind: 'hinge', ends, stops: turnStops(read, '') });
}

/** X3D's way is body1's along the axis, or, where body1 lies behind body2, against it: apart is positive. */
function slider(scene: CaseScene, joint: CaseJoint, read: Reader, plans: Plans): void {
  const axis = read.axis('axis', [0, 1, 0]);
  const [one, other] = [start(scene, joint.body1).p, start(scene, joint.body2).p];
  const behind = joint.body2 !== undefined && dot(subtract(other, one), axis) > 1e-6;
  const [low, high] = [read.get('minSeparation', 0), read.get('maxSeparation', 1)];
  const bounce = read.get('stopBounce', 0);
  read.get('stopErrorCorrection', 1);
  const range = behind ? { low: -high, high: -low } : { low, high };
  const stops = low > high ? undefined : { ...range, bounce };
  const ends = endsOf(scene, joint, one, [axis, axis]);
  plans.joints.push({ kind: 'slider', ends, stops });
  const force = read.get('sliderForce', 0) * (behind ? -1 : 1);
  const [{ axis: own }] = ends;
  if (force !== 0)
    plans.pushes.push({ kind: 'force', ...bodiesOf(joint), vector: scale(own, force) });
}

const bodiesOf = ({ body1, body2 }: CaseJoint) => ({ body1, body2 });

function cardan(scene: CaseScene, joint: CaseJoint, read: Reader, plans: Plans): void {
  const axes: [Vec3, Vec3] = [read.axis('axis1', [1, 0, 0]), read.axis('axis2', [0, 1, 0])];
  const ends = endsOf(scene, joint, read.get<Vec3>('anchorPoint', [0, 0, 0]), axes);
  plans.joints.push({ kind: 'cross', ends });
}

/** Held about its first axis and not sprung it is a hinge with a motor; free about it, a cross that may be sprung. */
function doubleHinge(scene: CaseScene, joint: CaseJoint, read: Reader, plans: Plans): void {
  const steering = turnStops(read, '1');
  const axes: [Vec3, Vec3] = [read.axis('axis1', [1, 0, 0]), read.axis('axis2', [0, 1, 0])];
  const anchor = read.get<Vec3>('anchorPoint', [0, 0, 0]);
  const motor = { speed: read.get('desiredAngularVelocity2', 0), most: read.get('maxTorque2', 0) };
  const spring = springOf(read);
  if (steering && steering.low === steering.high && !spring) {
    const ends = endsOf(scene, joint, anchor, [axes[1], axes[1]]);
    plans.joints.push({ kind: 'hinge', ends, motor: motor.most > 0 ? motor : undefined });
    return;
  }
  if (steering || motor.most > 0 || Math.abs(dot(...axes)) > 1e-4)
    throw new NotOffered('a hinge about two axes with stops, a motor or a slant');
  plans.joints.push({ kind: 'cross', ends: endsOf(scene, joint, anchor, axes), spring });
}

/** X3D's softness and error correction of a row that is solved every 1/60 s are a spring and a damper. */
function springOf(read: Reader): Spring | undefined {
  const give = read.get('suspensionForce', 0);
  const share = read.get('suspensionErrorCorrection', 0.8);
  if (give === 0) return undefined;
  return { stiffness: (60 * share) / give, damping: (1 - share) / give };
}

const AXES: Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** It holds nothing together: in other engines page code applies its torques. */
function torques(scene: CaseScene, joint: CaseJoint, read: Reader, plans: Plans): void {
  const count = read.get('enabledAxes', 1);
  if (read.get('autoCalc', false)) throw new NotOffered('a MotorJoint in Euler mode');
  AXES.forEach((otherwise, i) => {
    const axis = read.axis(`motor${i + 1}Axis`, otherwise);
    const torque = read.get(`axis${i + 1}Torque`, 0);
    if (i >= count || torque === 0) return;
    const own = rotate(conjugate(start(scene, joint.body1).q), axis);
    plans.pushes.push({ kind: 'torque', ...bodiesOf(joint), vector: scale(own, torque) });
  });
}

function ball(scene: CaseScene, joint: CaseJoint, read: Reader, plans: Plans): void {
  const ends = endsOf(scene, joint, read.get<Vec3>('anchorPoint', [0, 0, 0]));
  plans.joints.push({ kind: 'ball', ends });
}

const PLANNERS = {
  BallJoint: ball,
  SingleAxisHingeJoint: hinge,
  SliderJoint: slider,
  UniversalJoint: cardan,
  DoubleAxisHingeJoint: doubleHinge,
  MotorJoint: torques,
};

/** The joints of a scene for engines other than ours. */
export function plansOf(scene: CaseScene): Plans {
  const plans: Plans = { joints: [], pushes: [] };
  for (const joint of scene.joints ?? []) {
    const read = new Reader(joint);
    PLANNERS[joint.type](scene, joint, read, plans);
    read.finish();
  }
  return plans;
}
