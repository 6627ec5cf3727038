import type { MeantNode } from './advice.js';
import { byName } from './table.js';

/** What X3D has for a word of everyday or of another engine. */
export interface Word {
  /** The field; undefined where X3D has none. */
  field?: string;
  /** Nodes that have it; undefined: whatever has a field of that name. */
  at?: RegExp;
  /** The one to name where it is looked for elsewhere. */
  node?: string;
  /** How it is written. */
  write?: string;
  /** What that does here. */
  does?: string;
}

const BODY = { at: /^RigidBody$/, node: 'RigidBody' };
const LIST = { at: /^CollisionCollection$/, node: 'CollisionCollection' };
const WORLD = { at: /^RigidBodyCollection$/, node: 'RigidBodyCollection' };
const MOTOR = { at: /^MotorJoint$/, node: 'MotorJoint' };

/** Words without capitals and hyphens; some mean one thing or another by their value. */
type Words = Record<string, Word | ((value: string) => Word | undefined)>;

const FIXED: Word = {
  ...BODY,
  field: 'fixed',
  write: 'fixed="true"',
  does: 'nothing moves it, and what hits it bounces off',
};
const CARRIED: Word = {
  ...BODY,
  field: 'fixed',
  write: 'fixed="true"',
  does: 'a fixed body that is moved, by its Transform or its position, is carried, pushes, and takes along what lies on it',
};
const MOVES: Word = { does: 'every body moves that is not fixed: leave it out' };
const FRICTION: Word = { ...LIST, field: 'frictionCoefficients' };
const BOUNCE: Word = { ...LIST, field: 'bounce' };
const SPEED: Word = { ...BODY, field: 'linearVelocity' };
const SPIN: Word = { ...BODY, field: 'angularVelocity' };
const DAMPED: Word = {
  ...BODY,
  field: 'linearDampingFactor',
  write: 'linearDampingFactor="0.1" autoDamp="true"',
  does: 'so many newtons brake it for each metre per second; angularDampingFactor brakes its turning',
};
const TURN_DAMPED: Word = {
  ...BODY,
  field: 'angularDampingFactor',
  write: 'angularDampingFactor="0.1" autoDamp="true"',
  does: 'so many newton metres brake its turning for each radian per second',
};
const GRAVITY_SHARE: Word = {
  ...BODY,
  field: 'useGlobalGravity',
  write: 'useGlobalGravity="false" forces="0 -4.9 0"',
  does: 'X3D knows no share of gravity: it is off, and a force of its own, in newtons, stands for it',
};
const SLEEPS: Word = {
  field: 'autoDisable',
  write: 'autoDisable="true"',
  does: 'what stays below disableLinearSpeed and disableAngularSpeed for disableTime sleeps',
};
const PAIRS: Word = {
  ...LIST,
  field: 'collidables',
  does: 'named as collider of the RigidBodyCollection, it lets exactly the pairs in it collide',
};
const SIZE: Word = { at: /^(RigidBody|Collidable.*)$/, does: 'its size is that of its Shapes' };
const SIDE_ONE: Word = { field: 'body1', at: /Joint$/, node: 'a joint' };
const SIDE_TWO: Word = { field: 'body2', at: /Joint$/, node: 'a joint' };
const KICK: Word = {
  ...BODY,
  does: 'applyImpulse() of its element kicks it once; forces push it all the time, in newtons',
};
const STOPS: Word = {
  does: 'stops are minAngle and maxAngle of a hinge, minSeparation and maxSeparation of a slider',
};
const NO_LOCK: Word = {
  does: 'X3D locks no axis: a joint to the world holds a body to a line or a hinge',
};

const kindOf = (value: string): Word | undefined =>
  ({ dynamic: MOVES, static: FIXED, fixed: FIXED, kinematic: CARRIED })[plainKind(value)];
const plainKind = (value: string): string =>
  value.toLowerCase().match(/dynamic|static|fixed|kinematic/)?.[0] ?? '';

export const WORDS: Words = byName<Words[string]>({
  anchor: { field: 'anchorPoint' },
  angulardamping: TURN_DAMPED,
  angvel: SPIN,
  autosleep: SLEEPS,
  axis: { ...MOTOR, field: 'motor1Axis' },
  bodya: SIDE_ONE,
  bodyb: SIDE_TWO,
  bodytype: kindOf,
  bounce: BOUNCE,
  bounciness: BOUNCE,
  cansleep: SLEEPS,
  ccd: { does: 'fast bodies do not tunnel here: leave it out' },
  collisiongroup: PAIRS,
  collisionmask: PAIRS,
  connectedbody: SIDE_TWO,
  damping: DAMPED,
  density: { ...BODY, field: 'mass', write: 'mass="2"', does: 'in kilograms; X3D has no density' },
  drag: DAMPED,
  draggable: { ...BODY, at: /^RigidBody(Collection)?$/, field: 'draggable-body' },
  dynamic: MOVES,
  filtergroup: PAIRS,
  filtermask: PAIRS,
  fixedrotation: NO_LOCK,
  force: { ...BODY, field: 'forces' },
  freezerotation: NO_LOCK,
  friction: FRICTION,
  gravity: { ...WORLD, field: 'gravity' },
  gravityfactor: GRAVITY_SHARE,
  gravityscale: GRAVITY_SHARE,
  immovable: FIXED,
  impulse: KICK,
  iskinematic: CARRIED,
  isstatic: FIXED,
  kinematic: CARRIED,
  kind: kindOf,
  layer: PAIRS,
  lineardamping: DAMPED,
  linvel: SPEED,
  lockrotation: NO_LOCK,
  motiontype: kindOf,
  motorspeed: { ...MOTOR, field: 'axis1Torque' },
  max: STOPS,
  min: STOPS,
  mustoutput: { field: 'forceOutput' },
  omega: SPIN,
  pivot: { field: 'anchorPoint' },
  quaternion: { field: 'orientation' },
  radius: SIZE,
  restitution: BOUNCE,
  rotation: { field: 'orientation', at: /^RigidBody$/, node: 'RigidBody' },
  size: SIZE,
  sleeping: SLEEPS,
  speed: SPEED,
  static: FIXED,
  torque: (): Word => ({ ...MOTOR, field: 'axis1Torque' }),
  translation: { field: 'position', at: /^RigidBody$/, node: 'RigidBody' },
  type: kindOf,
  usegravity: { ...BODY, field: 'useGlobalGravity' },
  velocity: SPEED,
  weight: { ...BODY, field: 'mass' },
});

const hinge: MeantNode = {
  type: 'SingleAxisHingeJoint',
  does: 'it turns about axis through anchorPoint',
};
const fixedJoint: MeantNode = {
  type: 'RigidBody',
  does: 'several Shapes under one Transform with one body are welded',
};
const body: MeantNode = { type: 'RigidBody', does: '' };
const shape: MeantNode = {
  type: 'CollidableShape',
  does: 'it gives a body a Shape to collide with; a body inside a Transform takes the Shapes there',
};
const world: MeantNode = {
  type: 'RigidBodyCollection',
  does: 'a world with its gravity; bodies outside any have one, too',
};
const ball: MeantNode = { type: 'BallJoint', does: 'it turns freely about anchorPoint' };
const slider: MeantNode = { type: 'SliderJoint', does: 'it slides along axis' };
const material: MeantNode = {
  type: 'CollisionCollection',
  does: 'its bounce and frictionCoefficients hold for the pairs that it lists',
};
const sensor: MeantNode = {
  type: 'CollisionSensor',
  does: 'it tells of the contacts of its collider',
};

/** Names of other engines for nodes. */
export const NODES: Record<string, MeantNode | undefined> = byName<MeantNode>({
  balljoint: ball,
  ballsocketjoint: ball,
  body,
  collider: shape,
  collision: { type: 'CollisionCollection', does: '' },
  collisionshape: shape,
  fixedjoint: fixedJoint,
  hinge,
  hingejoint: hinge,
  motor: { type: 'MotorJoint', does: 'its torques drive up to three axes' },
  physics: world,
  physicsbody: body,
  physicsmaterial: material,
  physicsworld: world,
  pointjoint: ball,
  prismaticjoint: slider,
  revolutejoint: hinge,
  rigid: body,
  sphericaljoint: ball,
  trigger: sensor,
  weldjoint: fixedJoint,
  wheeljoint: { type: 'DoubleAxisHingeJoint', does: 'with steering, suspension and motor' },
  world,
});
