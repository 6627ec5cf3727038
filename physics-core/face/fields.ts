// Written by `npm run write -- types` from the tables in physics-core/nodes.
import type { Rotation, Vec3 } from '../fields/types.js';
import type { Coordinate, Geometry, Line } from '../shapes/geometry.js';
import type { CollidableInput, NodeHandles, NodeInput } from './nodes.js';
import type { NumberLists, Numbers, Several, Strings } from './values.js';

/** What may be said of a RigidBodyCollection (ISO/IEC 19775-1, 37.4.12); what is left out has its default. */
export interface RigidBodyCollectionFields {
  /** The bodies; membership is kept at each body. (MFNode) */
  bodies?: unknown;
  /** The joints; membership is kept at each joint. (MFNode) */
  joints?: unknown;
  /** Set: exactly the pairs inside that CollisionCollection collide. Not set: every pair of the world. (SFNode) */
  collider?: NodeInput<'CollisionCollection'> | null;
  /** Contacts for the next step, as page code changed those of a CollisionSensor: what the list leaves out does not push, what page code added does. With a collider it only changes parameters. (MFNode) */
  set_contacts?: Several<NodeInput<'Contact'>>;
  /** FALSE freezes the simulation; it resumes without a jump in time. (SFBool) Default true. */
  enabled?: boolean;
  /** Acceleration of every body that uses global gravity, m/s². (SFVec3f) Default 0 -9.8 0. */
  gravity?: Numbers;
  /** TRUE asks for accuracy level `precise` where no level is authored. (SFBool) Default false. */
  preferAccuracy?: boolean;
  /** Solver iterations per step; authored, it wins over the accuracy level. 0 counts as 1. Range [0, Infinity]. (SFInt32) Default 10. */
  iterations?: number;
  /** Share of a joint error repaired per 1/60 s; authored, it wins over the accuracy level. Range [0, 1]. (SFFloat) Default 0.8. */
  errorCorrection?: number;
  /** Softness of joints, m/(N·s); acts where authored. Range [0, Infinity]. (SFFloat) Default 0.0001. */
  constantForceMix?: number;
  /** Depth that resting contacts keep, metres. Range [0, Infinity]. (SFFloat) Default 0. */
  contactSurfaceThickness?: number;
  /** Greatest speed at which overlaps are pushed apart, m/s; -1 is unlimited. The push adds no velocity. Range [-1, Infinity]. (SFFloat) Default -1. */
  maxCorrectionSpeed?: number;
  /** Default of the bodies. Not authored: bodies at rest may sleep unnoticed. FALSE: never. TRUE: by the fields below. (SFBool) Default false. */
  autoDisable?: boolean;
  /** Seconds below both speeds before a body sleeps. Range [0, Infinity]. (SFTime) Default 0. */
  disableTime?: number;
  /** Speed below which a body may sleep, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  disableLinearSpeed?: number;
  /** Angular speed below which a body may sleep, rad/s. Range [0, Infinity]. (SFFloat) Default 0. */
  disableAngularSpeed?: number;
  /** Accuracy level: game, standard (default), fine, precise, reference; auto takes the finest that fits the time budget. (SFString) Default standard. */
  accuracy?: 'game' | 'standard' | 'fine' | 'precise' | 'reference' | 'auto';
  /** Milliseconds per frame that accuracy auto lets the physics take, in nine of ten frames. Range [0, Infinity]. (SFFloat) Default 6. */
  timeBudget?: number;
  /** `never` keeps bodies awake whose autoDisable nobody wrote. (SFString) Default auto. */
  rest?: 'auto' | 'never';
  /** `strict` follows the standard to the letter: without a collider nothing collides but the contacts of a CollisionSensor that page code hands to set_contacts, and friction is what frictionCoefficients say. (SFString) Default lenient. */
  collisionRules?: 'lenient' | 'strict';
  /** How its bodies are dragged: spring (default), kinematic, teleport. (SFString) Default spring. */
  dragMode?: 'spring' | 'kinematic' | 'teleport';
  /** TRUE: people may drag all of its bodies that move, and its ropes, cloth and soft bodies. (SFBool) Default false. */
  draggableBody?: boolean;
  /** Keeps running while the page is hidden or the scene scrolled away. (SFBool) Default false. */
  runHidden?: boolean;
  /** Draws its world as Bullet has it: shapes (awake green, asleep blue, fixed grey, carried orange), centres of mass, joints with their limits, contacts. (SFBool) Default false. */
  debug?: boolean;
  /** Where steps are taken: on the page’s own thread (main), on another (worker), or there from a hundred bodies on (auto). Acts when the world starts or is reset. (SFString) Default main. */
  thread?: 'main' | 'worker' | 'auto';
  /** Greatest size of the wasm heap, MB; looked at whenever something is made. Range [16, 2048]. (SFFloat) Default 512. */
  heapLimit?: number;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a RigidBodyCollection answers. */
export interface RigidBodyCollectionValues {
  bodies: unknown;
  joints: unknown;
  collider: NodeHandles['CollisionCollection'] | null;
  enabled: boolean;
  gravity: Vec3;
  preferAccuracy: boolean;
  iterations: number;
  errorCorrection: number;
  constantForceMix: number;
  contactSurfaceThickness: number;
  maxCorrectionSpeed: number;
  autoDisable: boolean;
  disableTime: number;
  disableLinearSpeed: number;
  disableAngularSpeed: number;
  accuracy: 'game' | 'standard' | 'fine' | 'precise' | 'reference' | 'auto';
  timeBudget: number;
  rest: 'auto' | 'never';
  collisionRules: 'lenient' | 'strict';
  dragMode: 'spring' | 'kinematic' | 'teleport';
  draggableBody: boolean;
  runHidden: boolean;
  debug: boolean;
  thread: 'main' | 'worker' | 'auto';
  heapLimit: number;
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a RigidBody (ISO/IEC 19775-1, 37.4.11); what is left out has its default. */
export interface RigidBodyFields {
  /** FALSE takes it out of the simulation: no motion, no contact, its joints idle. (SFBool) Default true. */
  enabled?: boolean;
  /** TRUE: never moves, but is collided with and holds joints. (SFBool) Default false. */
  fixed?: boolean;
  /** Mass, kg. 0 means fixed. Range [0, Infinity]. (SFFloat) Default 1. */
  mass?: number;
  /** Inertia tensor about the centre of mass in body axes, kg·m². Not authored: from massDensityModel or the geometry. (SFMatrix3f) Default 1 0 0 0 1 0 0 0 1. */
  inertia?: Numbers;
  /** Centre of mass in the body frame, metres. (SFVec3f) Default 0 0 0. */
  centerOfMass?: Numbers;
  /** Sphere, Box or Cone whose solid gives the distribution of the mass; never drawn. (SFNode) */
  massDensityModel?: Geometry | null;
  /** The collidables that make its shape. (MFNode) */
  geometry?: Several<CollidableInput>;
  /** Position, metres, world frame. Live. What differs from the value last set acts at once; to set an equal one again is no edit: teleport() always moves it. (SFVec3f) Default 0 0 0. */
  position?: Numbers;
  /** Orientation, axis and angle, radians. Live. What differs from the value last set acts at once; to set an equal one again is no edit: teleport() always turns it. (SFRotation) Default 0 0 1 0. */
  orientation?: Numbers;
  /** Velocity of the body's origin, m/s. Live. What differs from the value last set acts at once; to set an equal one again is no edit: applyImpulse() always kicks it. (SFVec3f) Default 0 0 0. */
  linearVelocity?: Numbers;
  /** Angular velocity, rad/s, world frame. Live. What differs from the value last set acts at once; to set an equal one again is no edit: applyImpulse() off the centre of mass always spins it. (SFVec3f) Default 0 0 0. */
  angularVelocity?: Numbers;
  /** Forces at the centre of mass, newtons, world frame; their sum acts in every step. (MFVec3f) */
  forces?: NumberLists;
  /** Torques, newton metres, world frame; their sum acts in every step. (MFVec3f) */
  torques?: NumberLists;
  /** FALSE: the collection's gravity does not act on it. (SFBool) Default true. */
  useGlobalGravity?: boolean;
  /** TRUE switches both damping factors on. (SFBool) Default false. */
  autoDamp?: boolean;
  /** Damping force = -factor × velocity, N·s/m. Range [0, 1]. (SFFloat) Default 0.001. */
  linearDampingFactor?: number;
  /** Damping torque = -factor × angular velocity, N·m·s. Range [0, 1]. (SFFloat) Default 0.001. */
  angularDampingFactor?: number;
  /** TRUE: sleeps by the fields below. FALSE, authored: never. Not authored: as its collection, else unnoticed at rest. (SFBool) Default false. */
  autoDisable?: boolean;
  /** Seconds below both speeds before it sleeps. Range [0, Infinity]. (SFTime) Default 0. */
  disableTime?: number;
  /** Speed below which it may sleep, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  disableLinearSpeed?: number;
  /** Angular speed below which it may sleep, rad/s. Range [0, Infinity]. (SFFloat) Default 0. */
  disableAngularSpeed?: number;
  /** `spring` pulls it at the grabbed point, `kinematic` carries it, pushing others aside, `teleport` sets it down. Not authored: as its collection. (SFString) Default spring. */
  dragMode?: 'spring' | 'kinematic' | 'teleport';
  /** TRUE: people may drag it by mouse, touch, pen and keyboard. Not authored: as its collection, if it moves. (SFBool) Default false. */
  draggableBody?: boolean;
  /** Bullet always turns bodies by finite rotations, so both values do the same. (SFBool) Default false. */
  useFiniteRotation?: boolean;
  /** All axes turn by finite rotations, so there is none to choose. Range [-1, 1]. (SFVec3f) Default 0 1 0. */
  finiteRotationAxis?: Numbers;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a RigidBody answers. */
export interface RigidBodyValues {
  enabled: boolean;
  fixed: boolean;
  mass: number;
  inertia: number[];
  centerOfMass: Vec3;
  massDensityModel: Geometry | null;
  geometry: (NodeHandles['CollidableShape'] | NodeHandles['CollidableOffset'])[];
  position: Vec3;
  orientation: Rotation;
  linearVelocity: Vec3;
  angularVelocity: Vec3;
  forces: Vec3[];
  torques: Vec3[];
  useGlobalGravity: boolean;
  autoDamp: boolean;
  linearDampingFactor: number;
  angularDampingFactor: number;
  autoDisable: boolean;
  disableTime: number;
  disableLinearSpeed: number;
  disableAngularSpeed: number;
  dragMode: 'spring' | 'kinematic' | 'teleport';
  draggableBody: boolean;
  useFiniteRotation: boolean;
  finiteRotationAxis: Vec3;
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a CollidableShape (ISO/IEC 19775-1, 37.4.3); what is left out has its default. */
export interface CollidableShapeFields {
  /** FALSE takes it out of collision; it is still drawn. (SFBool) Default true. */
  enabled?: boolean;
  /** Place, metres. In a body it is the body that says where; in a CollidableOffset it is the offset. (SFVec3f) Default 0 0 0. */
  translation?: Numbers;
  /** Orientation, axis and angle in radians; as translation. (SFRotation) Default 0 0 1 0. */
  rotation?: Numbers;
  /** The Shape whose geometry collides. (MFNode) */
  shape?: Several<Geometry>;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a CollidableShape answers. */
export interface CollidableShapeValues {
  enabled: boolean;
  translation: Vec3;
  rotation: Rotation;
  shape: Geometry[];
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a CollidableOffset (ISO/IEC 19775-1, 37.4.2); what is left out has its default. */
export interface CollidableOffsetFields {
  /** FALSE takes it out of collision; it is still drawn. (SFBool) Default true. */
  enabled?: boolean;
  /** Place, metres. In a body it is the body that says where; in a CollidableOffset it is the offset. (SFVec3f) Default 0 0 0. */
  translation?: Numbers;
  /** Orientation, axis and angle in radians; as translation. (SFRotation) Default 0 0 1 0. */
  rotation?: Numbers;
  /** The collidable that is placed. (SFNode) */
  collidable?: CollidableInput | null;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a CollidableOffset answers. */
export interface CollidableOffsetValues {
  enabled: boolean;
  translation: Vec3;
  rotation: Rotation;
  collidable: NodeHandles['CollidableShape'] | NodeHandles['CollidableOffset'] | null;
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a CollisionCollection (ISO/IEC 19775-1, 37.4.4); what is left out has its default. */
export interface CollisionCollectionFields {
  /** What it is for, in words for people. (SFString) */
  description?: string;
  /** The members; `*` means every collidable of the world. (MFNode) */
  collidables?: Several<NodeInput<'CollidableShape' | 'CollidableOffset' | 'CollisionSpace'>> | '*';
  /** FALSE: its pairs are not tested. (SFBool) Default true. */
  enabled?: boolean;
  /** Which parameters act: BOUNCE, FRICTION_COEFFICIENT-2, SPEED-1, SPEED-2, SLIP-1, SLIP-2, ERROR_REDUCTION, CONSTANT_FORCE; hyphen or underscore. USER_FRICTION means something on a Contact only. (MFString) Default "BOUNCE". */
  appliedParameters?: Strings;
  /** Share of the approach speed that comes back. Range [0, 1]. (SFFloat) Default 0. */
  bounce?: number;
  /** Approach speed below which nothing bounces, m/s. Range [0, Infinity]. (SFFloat) Default 0.1. */
  minBounceSpeed?: number;
  /** Coulomb friction along direction 1 and 2; without FRICTION_COEFFICIENT-2 the first acts in both. Not authored: 0.5. Direction 1 is the world’s x axis laid into the surface (z where the surface faces along x), direction 2 is across: z on a floor. Two different ones act each along its own direction, so that sliding obliquely meets both. Range [0, Infinity]. (SFVec2f) Default 0 0. */
  frictionCoefficients?: Numbers;
  /** Speed at which the surface carries bodies along friction direction 1 and 2, m/s (a conveyor belt); needs SPEED-1, SPEED-2. What does not move is the belt; of two bodies that move, the one made earlier. (SFVec2f) Default 0 0. */
  surfaceSpeed?: Numbers;
  /** Sliding speed per tangential force along friction direction 1 and 2, (m/s)/N; needs SLIP-1, SLIP-2. Below 0 counts as 0. (SFVec2f) Default 0 0. */
  slipFactors?: Numbers;
  /** Softness of contacts, (m/s)/N; needs CONSTANT_FORCE. A load F sinks in by F · softness / (60 · error correction). No more than a quarter of the thinner body, so that nothing falls through. It yields but does not spring back. Range [0, 1]. (SFFloat) Default 0.0001. */
  softnessConstantForceMix?: number;
  /** Share of an overlap repaired per 1/60 s; needs ERROR_REDUCTION. Range [0, 1]. (SFFloat) Default 0.8. */
  softnessErrorCorrection?: number;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a CollisionCollection answers. */
export interface CollisionCollectionValues {
  description: string;
  collidables:
    | (
        | NodeHandles['CollidableShape']
        | NodeHandles['CollidableOffset']
        | NodeHandles['CollisionSpace']
      )[]
    | '*';
  enabled: boolean;
  appliedParameters: string[];
  bounce: number;
  minBounceSpeed: number;
  frictionCoefficients: [number, number];
  surfaceSpeed: [number, number];
  slipFactors: [number, number];
  softnessConstantForceMix: number;
  softnessErrorCorrection: number;
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a CollisionSpace (ISO/IEC 19775-1, 37.4.6); what is left out has its default. */
export interface CollisionSpaceFields {
  /** FALSE: its collidables are in the collection only where they are in it by another way. (SFBool) Default true. */
  enabled?: boolean;
  /** The members: collidables and further spaces; `*` means every collidable of the world. (MFNode) */
  collidables?: Several<NodeInput<'CollidableShape' | 'CollidableOffset' | 'CollisionSpace'>> | '*';
  /** FALSE: a moving mesh may collide as its convex hull. TRUE: its own triangles. (SFBool) Default false. */
  useGeometry?: boolean;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a CollisionSpace answers. */
export interface CollisionSpaceValues {
  enabled: boolean;
  collidables:
    | (
        | NodeHandles['CollidableShape']
        | NodeHandles['CollidableOffset']
        | NodeHandles['CollisionSpace']
      )[]
    | '*';
  useGeometry: boolean;
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a CollisionSensor (ISO/IEC 19775-1, 37.4.5); what is left out has its default. */
export interface CollisionSensorFields {
  /** What it is for, in words for people. (SFString) */
  description?: string;
  /** The collection it watches; both members of a pair must be in it. (SFNode) */
  collider?: NodeInput<'CollisionCollection'> | null;
  /** FALSE: it sends nothing. (SFBool) Default true. */
  enabled?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a CollisionSensor answers. */
export interface CollisionSensorValues {
  description: string;
  collider: NodeHandles['CollisionCollection'] | null;
  enabled: boolean;
  isActive: boolean;
  intersections: unknown;
  contacts: NodeHandles['Contact'][];
  metadata: unknown;
}

/** What may be said of a Contact (ISO/IEC 19775-1, 37.4.7); what is left out has its default. */
export interface ContactFields {
  /** Which parameters act, as on a CollisionCollection; USER_FRICTION gives frictionDirection. (MFString) Default "BOUNCE". */
  appliedParameters?: Strings;
  /** The body that the normal points into: the one that moves, of two that do the one made later. NULL: none. (SFNode) */
  body1?: NodeInput<'RigidBody'> | null;
  /** The other body; NULL where the collidable belongs to none. (SFNode) */
  body2?: NodeInput<'RigidBody'> | null;
  /** Share of the approach speed that comes back. Range [0, 1]. (SFFloat) Default 0. */
  bounce?: number;
  /** Unit vector into body1: moved along it, body1 comes free. World frame. (SFVec3f) Default 0 1 0. */
  contactNormal?: Numbers;
  /** Depth of the overlap, metres; negative is a gap. (SFFloat) Default 0. */
  depth?: number;
  /** Coulomb friction along direction 1 and 2; without FRICTION_COEFFICIENT-2 the first acts in both. Range [0, Infinity]. (SFVec2f) Default 0 0. */
  frictionCoefficients?: Numbers;
  /** Friction direction 1, world frame; acts with USER_FRICTION. Along the normal it says nothing. (SFVec3f) Default 0 1 0. */
  frictionDirection?: Numbers;
  /** The collidable of body1. (SFNode) */
  geometry1?: CollidableInput | null;
  /** The collidable of body2. (SFNode) */
  geometry2?: CollidableInput | null;
  /** Approach speed below which nothing bounces, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  minBounceSpeed?: number;
  /** Where they touch, metres, world frame. (SFVec3f) Default 0 0 0. */
  position?: Numbers;
  /** Sliding speed per tangential force along direction 1 and 2, (m/s)/N. Below 0 counts as 0. (SFVec2f) Default 0 0. */
  slipCoefficients?: Numbers;
  /** Softness: speed per normal force, (m/s)/N. Range [0, 1]. (SFFloat) Default 0.0001. */
  softnessConstantForceMix?: number;
  /** Share of the overlap repaired per 1/60 s. Range [0, 1]. (SFFloat) Default 0.8. */
  softnessErrorCorrection?: number;
  /** Speed at which body1 is carried along body2, direction 1 and 2, m/s. (SFVec2f) Default 0 0. */
  surfaceSpeed?: Numbers;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a Contact answers. */
export interface ContactValues {
  appliedParameters: string[];
  body1: NodeHandles['RigidBody'] | null;
  body2: NodeHandles['RigidBody'] | null;
  bounce: number;
  contactNormal: Vec3;
  depth: number;
  frictionCoefficients: [number, number];
  frictionDirection: Vec3;
  geometry1: NodeHandles['CollidableShape'] | NodeHandles['CollidableOffset'] | null;
  geometry2: NodeHandles['CollidableShape'] | NodeHandles['CollidableOffset'] | null;
  minBounceSpeed: number;
  position: Vec3;
  slipCoefficients: [number, number];
  softnessConstantForceMix: number;
  softnessErrorCorrection: number;
  surfaceSpeed: [number, number];
  metadata: unknown;
}

/** What may be said of a BallJoint (ISO/IEC 19775-1, 37.4.1); what is left out has its default. */
export interface BallJointFields {
  /** The first body; without it the other side is the world. (SFNode) */
  body1?: NodeInput<'RigidBody'> | null;
  /** The second body; without it the other side is the world. (SFNode) */
  body2?: NodeInput<'RigidBody'> | null;
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  forceOutput?: Strings;
  /** Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew. (SFVec3f) Default 0 0 0. */
  anchorPoint?: Numbers;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a BallJoint answers. */
export interface BallJointValues {
  body1: NodeHandles['RigidBody'] | null;
  body2: NodeHandles['RigidBody'] | null;
  forceOutput: string[];
  anchorPoint: Vec3;
  body1AnchorPoint: Vec3;
  body2AnchorPoint: Vec3;
  metadata: unknown;
}

/** What may be said of a SingleAxisHingeJoint (ISO/IEC 19775-1, 37.4.14); what is left out has its default. */
export interface SingleAxisHingeJointFields {
  /** The first body; without it the other side is the world. (SFNode) */
  body1?: NodeInput<'RigidBody'> | null;
  /** The second body; without it the other side is the world. (SFNode) */
  body2?: NodeInput<'RigidBody'> | null;
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  forceOutput?: Strings;
  /** Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew. (SFVec3f) Default 0 0 0. */
  anchorPoint?: Numbers;
  /** Direction of the axis, world frame, when the joint is made. Editing it makes the joint anew. (SFVec3f) Default 0 1 0. */
  axis?: Numbers;
  /** Lower stop, radians from the pose the joint was made at. Above maxAngle: no stops. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default -3.141592653589793. */
  minAngle?: number;
  /** Upper stop, radians. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 3.141592653589793. */
  maxAngle?: number;
  /** Share of the turning speed that comes back from a stop. Range [0, 1]. (SFFloat) Default 0. */
  stopBounce?: number;
  /** Share of an overshoot past a stop repaired per 1/60 s. Range [0, 1]. (SFFloat) Default 0.8. */
  stopErrorCorrection?: number;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a SingleAxisHingeJoint answers. */
export interface SingleAxisHingeJointValues {
  body1: NodeHandles['RigidBody'] | null;
  body2: NodeHandles['RigidBody'] | null;
  forceOutput: string[];
  anchorPoint: Vec3;
  body1AnchorPoint: Vec3;
  body2AnchorPoint: Vec3;
  axis: Vec3;
  minAngle: number;
  maxAngle: number;
  stopBounce: number;
  stopErrorCorrection: number;
  angle: number;
  angleRate: number;
  metadata: unknown;
}

/** What may be said of a DoubleAxisHingeJoint (ISO/IEC 19775-1, 37.4.9); what is left out has its default. */
export interface DoubleAxisHingeJointFields {
  /** The first body; without it the other side is the world. (SFNode) */
  body1?: NodeInput<'RigidBody'> | null;
  /** The second body; without it the other side is the world. (SFNode) */
  body2?: NodeInput<'RigidBody'> | null;
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  forceOutput?: Strings;
  /** Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew. (SFVec3f) Default 0 0 0. */
  anchorPoint?: Numbers;
  /** Axis of steering and suspension, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew. (SFVec3f) Default 1 0 0. */
  axis1?: Numbers;
  /** Axis of spin, world frame, when the joint is made; body2 carries it. The angle between the axes stays as it is then. (SFVec3f) Default 0 1 0. */
  axis2?: Numbers;
  /** Lower stop of the angle about axis 1, radians from the pose the joint was made at. Above maxAngle1: no stops. Equal to it: held there. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default -3.141592653589793. */
  minAngle1?: number;
  /** Upper stop of the angle about axis 1, radians. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 3.141592653589793. */
  maxAngle1?: number;
  /** Share of the rate about axis 1 that comes back from a stop. Range [0, 1]. (SFFloat) Default 0. */
  stop1Bounce?: number;
  /** Share of an overshoot past a stop repaired per 1/60 s. Range [0, 1]. (SFFloat) Default 0.8. */
  stop1ErrorCorrection?: number;
  /** How far the stops give way: a steady torque sinks in by constantForceMix / (60 · errorCorrection) radians per newton metre. 0: not at all. Range [0, Infinity]. (SFFloat) Default 0.001. */
  stop1ConstantForceMix?: number;
  /** Rate that the motor about axis 1 strives for, rad/s, body1 relative to body2. (SFFloat) Default 0. */
  desiredAngularVelocity1?: number;
  /** Torque that the motor about axis 1 can muster, newton metres; 0: no motor. Range [0, Infinity]. (SFFloat) Default 0. */
  maxTorque1?: number;
  /** Rate that the motor about axis 2 strives for, rad/s, body1 relative to body2. (SFFloat) Default 0. */
  desiredAngularVelocity2?: number;
  /** Torque that the motor about axis 2 can muster, newton metres; 0: no motor. Range [0, Infinity]. (SFFloat) Default 0. */
  maxTorque2?: number;
  /** Softness of the suspension along axis 1, despite its name: stiffness 60 · suspensionErrorCorrection / suspensionForce N/m, damping (1 - suspensionErrorCorrection) / suspensionForce N s/m. 0: rigid. Range [0, Infinity]. (SFFloat) Default 0. */
  suspensionForce?: number;
  /** Share of the spring against the damper in the suspension: 1 has no damper, 0 no spring. Range [0, 1]. (SFFloat) Default 0.8. */
  suspensionErrorCorrection?: number;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a DoubleAxisHingeJoint answers. */
export interface DoubleAxisHingeJointValues {
  body1: NodeHandles['RigidBody'] | null;
  body2: NodeHandles['RigidBody'] | null;
  forceOutput: string[];
  anchorPoint: Vec3;
  body1AnchorPoint: Vec3;
  body2AnchorPoint: Vec3;
  axis1: Vec3;
  axis2: Vec3;
  minAngle1: number;
  maxAngle1: number;
  stop1Bounce: number;
  stop1ErrorCorrection: number;
  stop1ConstantForceMix: number;
  desiredAngularVelocity1: number;
  maxTorque1: number;
  desiredAngularVelocity2: number;
  maxTorque2: number;
  suspensionForce: number;
  suspensionErrorCorrection: number;
  hinge1Angle: number;
  hinge1AngleRate: number;
  hinge2Angle: number;
  hinge2AngleRate: number;
  body1Axis: Vec3;
  body2Axis: Vec3;
  metadata: unknown;
}

/** What may be said of a SliderJoint (ISO/IEC 19775-1, 37.4.15); what is left out has its default. */
export interface SliderJointFields {
  /** The first body; without it the other side is the world. (SFNode) */
  body1?: NodeInput<'RigidBody'> | null;
  /** The second body; without it the other side is the world. (SFNode) */
  body2?: NodeInput<'RigidBody'> | null;
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  forceOutput?: Strings;
  /** Direction in which they slide, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew. (SFVec3f) Default 0 1 0. */
  axis?: Numbers;
  /** Lower stop, metres from the pose the joint was made at; negative is allowed. Above maxSeparation: no stops. (SFFloat) Default 0. */
  minSeparation?: number;
  /** Upper stop, metres. (SFFloat) Default 1. */
  maxSeparation?: number;
  /** Newtons along the axis on both bodies in every step: positive pushes them apart, negative pulls them together. (SFFloat) Default 0. */
  sliderForce?: number;
  /** Share of the speed that comes back from a stop. Range [0, 1]. (SFFloat) Default 0. */
  stopBounce?: number;
  /** Share of an overshoot past a stop repaired per 1/60 s. Range [0, 1]. (SFFloat) Default 1. */
  stopErrorCorrection?: number;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a SliderJoint answers. */
export interface SliderJointValues {
  body1: NodeHandles['RigidBody'] | null;
  body2: NodeHandles['RigidBody'] | null;
  forceOutput: string[];
  axis: Vec3;
  minSeparation: number;
  maxSeparation: number;
  sliderForce: number;
  stopBounce: number;
  stopErrorCorrection: number;
  separation: number;
  separationRate: number;
  metadata: unknown;
}

/** What may be said of a UniversalJoint (ISO/IEC 19775-1, 37.4.16); what is left out has its default. */
export interface UniversalJointFields {
  /** The first body; without it the other side is the world. (SFNode) */
  body1?: NodeInput<'RigidBody'> | null;
  /** The second body; without it the other side is the world. (SFNode) */
  body2?: NodeInput<'RigidBody'> | null;
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  forceOutput?: Strings;
  /** Place of the joint, metres, world frame, when it is made. Editing it makes the joint anew. (SFVec3f) Default 0 0 0. */
  anchorPoint?: Numbers;
  /** First arm of the cross, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew. (SFVec3f) Default 1 0 0. */
  axis1?: Numbers;
  /** Second arm, at right angles to the first, world frame, when the joint is made; body2 carries it. Editing it makes the joint anew. (SFVec3f) Default 0 1 0. */
  axis2?: Numbers;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 1. Range [0, 1]. (SFFloat) Default 0. */
  stop1Bounce?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 1. Range [0, 1]. (SFFloat) Default 0.8. */
  stop1ErrorCorrection?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 2. Range [0, 1]. (SFFloat) Default 0. */
  stop2Bounce?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 2. Range [0, 1]. (SFFloat) Default 0.8. */
  stop2ErrorCorrection?: number;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a UniversalJoint answers. */
export interface UniversalJointValues {
  body1: NodeHandles['RigidBody'] | null;
  body2: NodeHandles['RigidBody'] | null;
  forceOutput: string[];
  anchorPoint: Vec3;
  body1AnchorPoint: Vec3;
  body2AnchorPoint: Vec3;
  axis1: Vec3;
  axis2: Vec3;
  stop1Bounce: number;
  stop1ErrorCorrection: number;
  stop2Bounce: number;
  stop2ErrorCorrection: number;
  body1Axis: Vec3;
  body2Axis: Vec3;
  metadata: unknown;
}

/** What may be said of a MotorJoint (ISO/IEC 19775-1, 37.4.10); what is left out has its default. */
export interface MotorJointFields {
  /** The first body; without it the other side is the world. (SFNode) */
  body1?: NodeInput<'RigidBody'> | null;
  /** The second body; without it the other side is the world. (SFNode) */
  body2?: NodeInput<'RigidBody'> | null;
  /** Which outputs are sent along ROUTEs: NONE, ALL, or their names. Reading an output gives its live value in any case. (MFString) Default "NONE". */
  forceOutput?: Strings;
  /** TRUE: the angles are measured, as Euler angles about axis 1 (of body1), axis 3 (of body2) and the one across. FALSE: the author tells them. (SFBool) Default false. */
  autoCalc?: boolean;
  /** How many axes are driven: 0 to 3. Range [0, 3]. (SFInt32) Default 1. */
  enabledAxes?: number;
  /** Direction of axis 1, world frame when the joint is made. It turns with body1; with autoCalc axis 3 turns with body2 and axis 2 is axis 3 × axis 1. Without a direction it turns nothing. Editing it makes the joint anew. (SFVec3f) Default 1 0 0. */
  motor1Axis?: Numbers;
  /** Angle about axis 1 as the author measured it, radians: motor1Angle says it again, unless autoCalc measures it. It drives nothing. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 0. */
  axis1Angle?: number;
  /** Torque about axis 1, newton metres: plus on body1, minus on body2. (SFFloat) Default 0. */
  axis1Torque?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 1. Range [0, 1]. (SFFloat) Default 0. */
  stop1Bounce?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 1. Range [0, 1]. (SFFloat) Default 0.8. */
  stop1ErrorCorrection?: number;
  /** Direction of axis 2, world frame when the joint is made. It turns with body1; with autoCalc axis 3 turns with body2 and axis 2 is axis 3 × axis 1. Without a direction it turns nothing. Editing it makes the joint anew. (SFVec3f) Default 0 1 0. */
  motor2Axis?: Numbers;
  /** Angle about axis 2 as the author measured it, radians: motor2Angle says it again, unless autoCalc measures it. It drives nothing. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 0. */
  axis2Angle?: number;
  /** Torque about axis 2, newton metres: plus on body1, minus on body2. (SFFloat) Default 0. */
  axis2Torque?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 2. Range [0, 1]. (SFFloat) Default 0. */
  stop2Bounce?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 2. Range [0, 1]. (SFFloat) Default 0.8. */
  stop2ErrorCorrection?: number;
  /** Direction of axis 3, world frame when the joint is made. It turns with body1; with autoCalc axis 3 turns with body2 and axis 2 is axis 3 × axis 1. Without a direction it turns nothing. Editing it makes the joint anew. (SFVec3f) Default 0 0 1. */
  motor3Axis?: Numbers;
  /** Angle about axis 3 as the author measured it, radians: motor3Angle says it again, unless autoCalc measures it. It drives nothing. Range [-3.141592653589793, 3.141592653589793]. (SFFloat) Default 0. */
  axis3Angle?: number;
  /** Torque about axis 3, newton metres: plus on body1, minus on body2. (SFFloat) Default 0. */
  axis3Torque?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 3. Range [0, 1]. (SFFloat) Default 0. */
  stop3Bounce?: number;
  /** Kept, and without effect: X3D gives this node no limits, so nothing stops about axis 3. Range [0, 1]. (SFFloat) Default 0.8. */
  stop3ErrorCorrection?: number;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a MotorJoint answers. */
export interface MotorJointValues {
  body1: NodeHandles['RigidBody'] | null;
  body2: NodeHandles['RigidBody'] | null;
  forceOutput: string[];
  autoCalc: boolean;
  enabledAxes: number;
  motor1Axis: Vec3;
  axis1Angle: number;
  axis1Torque: number;
  stop1Bounce: number;
  stop1ErrorCorrection: number;
  motor1Angle: number;
  motor1AngleRate: number;
  motor2Axis: Vec3;
  axis2Angle: number;
  axis2Torque: number;
  stop2Bounce: number;
  stop2ErrorCorrection: number;
  motor2Angle: number;
  motor2AngleRate: number;
  motor3Axis: Vec3;
  axis3Angle: number;
  axis3Torque: number;
  stop3Bounce: number;
  stop3ErrorCorrection: number;
  motor3Angle: number;
  motor3AngleRate: number;
  metadata: unknown;
}

/** What may be said of a ParticleSystem (ISO/IEC 19775-1, 40.4.5); what is left out has its default. */
export interface ParticleSystemFields {
  /** What its particles are drawn with. (SFNode) */
  appearance?: unknown;
  /** Whether its particles cast shadows. (SFBool) Default true. */
  castShadow?: boolean;
  /** Colours that particles are drawn in, one for each colorKey. (SFNode) */
  color?: unknown;
  /** Ages of particles, seconds, at which they have the colours of color. Range [0, Infinity]. (MFFloat) */
  colorKey?: Numbers;
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  createParticles?: boolean;
  /** FALSE: it has no particles. (SFBool) Default true. */
  enabled?: boolean;
  /** What each particle is drawn as where geometryType is GEOMETRY. (SFNode) */
  geometry?: unknown;
  /** What particles are drawn as: QUAD, LINE, POINT, SPRITE, TRIANGLE, or GEOMETRY, which is that of geometry. (SFString) Default QUAD. */
  geometryType?: 'QUAD' | 'LINE' | 'POINT' | 'SPRITE' | 'TRIANGLE' | 'GEOMETRY';
  /** Greatest share of particleLifetime by which a particle lives longer or less long, evenly spread. Range [0, 1]. (SFFloat) Default 0.25. */
  lifetimeVariation?: number;
  /** How many particles may live at once. Range [0, Infinity]. (SFInt32) Default 200. */
  maxParticles?: number;
  /** How long a particle lives, seconds. Range [0, Infinity]. (SFFloat) Default 5. */
  particleLifetime?: number;
  /** Width and height of a particle, metres. Range [0, Infinity]. (SFVec2f) Default 0.02 0.02. */
  particleSize?: Numbers;
  /** Texture coordinates that particles are drawn with, a set for each texCoordKey. (SFNode) */
  texCoord?: unknown;
  /** Ages of particles, seconds, from which on they have the next set of texCoord. Range [0, Infinity]. (MFFloat) */
  texCoordKey?: Numbers;
  /** Where particles are born, and how; NULL: none are. (SFNode) */
  emitter?: NodeInput<
    | 'ConeEmitter'
    | 'ExplosionEmitter'
    | 'PointEmitter'
    | 'PolylineEmitter'
    | 'SurfaceEmitter'
    | 'VolumeEmitter'
  > | null;
  /** What moves particles: all of these models act together. (MFNode) */
  physics?: Several<NodeInput<'BoundedPhysicsModel' | 'ForcePhysicsModel' | 'WindPhysicsModel'>>;
  /** TRUE: particles bounce off bodies. (SFBool) Default false. */
  collides?: boolean;
  /** TRUE: particles that bounce off bodies push them by their mass, and its winds push bodies. (SFBool) Default false. */
  pushes?: boolean;
  /** Share of the approach speed that comes back when a particle meets a body. Range [0, 1]. (SFFloat) Default 0. */
  bounce?: number;
  /** Coulomb friction of particles on bodies. Range [0, Infinity]. (SFFloat) Default 0.5. */
  friction?: number;
  /** What is random about particles follows from it: the same number gives the same particles. (SFInt32) Default 0. */
  seed?: number;
  /** Share of its speed that a particle loses, 1/s. Range [0, Infinity]. (SFFloat) Default 0. */
  damping?: number;
  /** The body that its emitter stands on and moves with; NULL: the emitter stands in the world. (SFNode) */
  body?: NodeInput<'RigidBody'> | null;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a ParticleSystem answers. */
export interface ParticleSystemValues {
  appearance: unknown;
  castShadow: boolean;
  color: unknown;
  colorKey: number[];
  createParticles: boolean;
  enabled: boolean;
  geometry: unknown;
  geometryType: 'QUAD' | 'LINE' | 'POINT' | 'SPRITE' | 'TRIANGLE' | 'GEOMETRY';
  lifetimeVariation: number;
  maxParticles: number;
  particleLifetime: number;
  particleSize: [number, number];
  isActive: boolean;
  texCoord: unknown;
  texCoordKey: number[];
  emitter:
    | NodeHandles['ConeEmitter']
    | NodeHandles['ExplosionEmitter']
    | NodeHandles['PointEmitter']
    | NodeHandles['PolylineEmitter']
    | NodeHandles['SurfaceEmitter']
    | NodeHandles['VolumeEmitter']
    | null;
  physics: (
    | NodeHandles['BoundedPhysicsModel']
    | NodeHandles['ForcePhysicsModel']
    | NodeHandles['WindPhysicsModel']
  )[];
  collides: boolean;
  pushes: boolean;
  bounce: number;
  friction: number;
  seed: number;
  damping: number;
  body: NodeHandles['RigidBody'] | null;
  positions: Vec3[];
  count: number;
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a ConeEmitter (ISO/IEC 19775-1, 40.4.2); what is left out has its default. */
export interface ConeEmitterFields {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  on?: boolean;
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  speed?: number;
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  variation?: number;
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  mass?: number;
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  surfaceArea?: number;
  /** Where particles are born, metres, in the frame of their system. (SFVec3f) Default 0 0 0. */
  position?: Numbers;
  /** Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way. (SFVec3f) Default 0 1 0. */
  direction?: Numbers;
  /** Greatest angle between direction and the way of a particle, radians. Range [0, 3.141592653589793]. (SFFloat) Default 0.7853981633974483. */
  angle?: number;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a ConeEmitter answers. */
export interface ConeEmitterValues {
  on: boolean;
  speed: number;
  variation: number;
  mass: number;
  surfaceArea: number;
  position: Vec3;
  direction: Vec3;
  angle: number;
  metadata: unknown;
}

/** What may be said of a ExplosionEmitter (ISO/IEC 19775-1, 40.4.3); what is left out has its default. */
export interface ExplosionEmitterFields {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  on?: boolean;
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  speed?: number;
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  variation?: number;
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  mass?: number;
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  surfaceArea?: number;
  /** Where particles are born, metres, in the frame of their system. (SFVec3f) Default 0 0 0. */
  position?: Numbers;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a ExplosionEmitter answers. */
export interface ExplosionEmitterValues {
  on: boolean;
  speed: number;
  variation: number;
  mass: number;
  surfaceArea: number;
  position: Vec3;
  metadata: unknown;
}

/** What may be said of a PointEmitter (ISO/IEC 19775-1, 40.4.6); what is left out has its default. */
export interface PointEmitterFields {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  on?: boolean;
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  speed?: number;
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  variation?: number;
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  mass?: number;
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  surfaceArea?: number;
  /** Where particles are born, metres, in the frame of their system. (SFVec3f) Default 0 0 0. */
  position?: Numbers;
  /** Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way. (SFVec3f) Default 0 1 0. */
  direction?: Numbers;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a PointEmitter answers. */
export interface PointEmitterValues {
  on: boolean;
  speed: number;
  variation: number;
  mass: number;
  surfaceArea: number;
  position: Vec3;
  direction: Vec3;
  metadata: unknown;
}

/** What may be said of a PolylineEmitter (ISO/IEC 19775-1, 40.4.7); what is left out has its default. */
export interface PolylineEmitterFields {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  on?: boolean;
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  speed?: number;
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  variation?: number;
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  mass?: number;
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  surfaceArea?: number;
  /** Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way. (SFVec3f) Default 0 1 0. */
  direction?: Numbers;
  /** Its points, metres, in the frame of the system: a Coordinate, or the flat list of its numbers. (SFNode) */
  coord?: Coordinate | NumberLists | null;
  /** Which points make a line, counted from 0, with -1 after each line; -1 alone: all in order make one. Range [-1, Infinity]. (MFInt32) Default -1. */
  coordIndex?: Numbers;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a PolylineEmitter answers. */
export interface PolylineEmitterValues {
  on: boolean;
  speed: number;
  variation: number;
  mass: number;
  surfaceArea: number;
  direction: Vec3;
  coord: Coordinate | null;
  coordIndex: number[];
  metadata: unknown;
}

/** What may be said of a SurfaceEmitter (ISO/IEC 19775-1, 40.4.8); what is left out has its default. */
export interface SurfaceEmitterFields {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  on?: boolean;
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  speed?: number;
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  variation?: number;
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  mass?: number;
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  surfaceArea?: number;
  /** The geometry on which particles are born; NULL: none are. (SFNode) */
  surface?: Geometry | null;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a SurfaceEmitter answers. */
export interface SurfaceEmitterValues {
  on: boolean;
  speed: number;
  variation: number;
  mass: number;
  surfaceArea: number;
  surface: Geometry | null;
  metadata: unknown;
}

/** What may be said of a VolumeEmitter (ISO/IEC 19775-1, 40.4.9); what is left out has its default. */
export interface VolumeEmitterFields {
  /** FALSE: no particle is born, and those that there are live on. (SFBool) Default true. */
  on?: boolean;
  /** Speed that particles are born with, m/s. Range [0, Infinity]. (SFFloat) Default 0. */
  speed?: number;
  /** Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0. Range [0, Infinity]. (SFFloat) Default 0.25. */
  variation?: number;
  /** Mass of each particle, kilograms; with 0 no force and no wind moves it. Range [0, Infinity]. (SFFloat) Default 0. */
  mass?: number;
  /** Area that each particle shows to the wind, m². Range [0, Infinity]. (SFFloat) Default 0. */
  surfaceArea?: number;
  /** Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way. (SFVec3f) Default 0 1 0. */
  direction?: Numbers;
  /** Its points, metres, in the frame of the system: a Coordinate, or the flat list of its numbers. (SFNode) */
  coord?: Coordinate | NumberLists | null;
  /** Which points make a face, counted from 0, with -1 after each face: together they are closed. Range [-1, Infinity]. (MFInt32) Default -1. */
  coordIndex?: Numbers;
  /** TRUE: particles are born anywhere inside; FALSE: only on the surface. (SFBool) Default true. */
  internal?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a VolumeEmitter answers. */
export interface VolumeEmitterValues {
  on: boolean;
  speed: number;
  variation: number;
  mass: number;
  surfaceArea: number;
  direction: Vec3;
  coord: Coordinate | null;
  coordIndex: number[];
  internal: boolean;
  metadata: unknown;
}

/** What may be said of a BoundedPhysicsModel (ISO/IEC 19775-1, 40.4.1); what is left out has its default. */
export interface BoundedPhysicsModelFields {
  /** FALSE: it does nothing to particles. (SFBool) Default true. */
  enabled?: boolean;
  /** The geometry that particles bounce off, in the frame of their system. (SFNode) */
  geometry?: Geometry | null;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a BoundedPhysicsModel answers. */
export interface BoundedPhysicsModelValues {
  enabled: boolean;
  geometry: Geometry | null;
  metadata: unknown;
}

/** What may be said of a ForcePhysicsModel (ISO/IEC 19775-1, 40.4.4); what is left out has its default. */
export interface ForcePhysicsModelFields {
  /** FALSE: it does nothing to particles. (SFBool) Default true. */
  enabled?: boolean;
  /** Force on each particle, newtons, in the frame of their system; divided by its mass it is an acceleration. (SFVec3f) Default 0 -9.8 0. */
  force?: Numbers;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a ForcePhysicsModel answers. */
export interface ForcePhysicsModelValues {
  enabled: boolean;
  force: Vec3;
  metadata: unknown;
}

/** What may be said of a WindPhysicsModel (ISO/IEC 19775-1, 40.4.10); what is left out has its default. */
export interface WindPhysicsModelFields {
  /** FALSE: it does nothing to particles. (SFBool) Default true. */
  enabled?: boolean;
  /** Where the wind blows, in the frame of the system, whatever its length; 0 0 0: each time elsewhere. (SFVec3f) Default 1 0 0. */
  direction?: Numbers;
  /** Speed of the wind between gusts, m/s. Range [0, Infinity]. (SFFloat) Default 0.1. */
  speed?: number;
  /** Greatest share of the speed by which that of a gust is more or less. Range [0, Infinity]. (SFFloat) Default 0.1. */
  gustiness?: number;
  /** How far particles and bodies are pushed off the way of the wind, each another way: 0 not at all, 1 anywhere. Range [0, 1]. (SFFloat) Default 0. */
  turbulence?: number;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a WindPhysicsModel answers. */
export interface WindPhysicsModelValues {
  enabled: boolean;
  direction: Vec3;
  speed: number;
  gustiness: number;
  turbulence: number;
  metadata: unknown;
}

/** What may be said of a Rope; what is left out has its default. */
export interface RopeFields {
  /** FALSE: it stands still, and holds nothing. (SFBool) Default true. */
  enabled?: boolean;
  /** A LineSet or an IndexedLineSet: its first line is the rope as it is laid. (SFNode) */
  geometry?: Line | NumberLists | null;
  /** The line along which it is laid, metres; it wins over geometry. An edit lays it anew. (MFVec3f) */
  points?: NumberLists;
  /** How many links of one length it is divided into; 0: as many as its line has. Range [0, 10000]. (SFInt32) Default 0. */
  segments?: number;
  /** kg, of the whole rope. Range (0, Infinity]. (SFFloat) Default 1. */
  mass?: number;
  /** Half of its thickness, metres; 0: it touches nothing. Range [0, Infinity]. (SFFloat) Default 0.01. */
  radius?: number;
  /** Newtons that would stretch it to twice its length, if it went on as it begins; 0: it does not stretch. Range [0, Infinity]. (SFFloat) Default 0. */
  stretchStiffness?: number;
  /** What it takes to bend it, N m²: E I of a beam; 0: it bends freely. More than a step follows is told (soft-too-stiff). Range [0, Infinity]. (SFFloat) Default 0. */
  bendStiffness?: number;
  /** Share of its speed that it loses, 1/s. Range [0, Infinity]. (SFFloat) Default 0. */
  damping?: number;
  /** Coulomb friction on what it touches. Range [0, Infinity]. (SFFloat) Default 0.5. */
  friction?: number;
  /** TRUE: its links do not go through each other. It costs, so it is off. (SFBool) Default false. */
  selfCollision?: boolean;
  /** Points that stay where they are, counted from 0. Range [0, Infinity]. (MFInt32) */
  fixedIndex?: Numbers;
  /** TRUE: people may drag it by mouse, touch, pen and keyboard, at any place of it, by a spring. Not authored: as its collection. (SFBool) Default false. */
  draggableBody?: boolean;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a Rope answers. */
export interface RopeValues {
  enabled: boolean;
  geometry: Line | null;
  points: Vec3[];
  segments: number;
  mass: number;
  radius: number;
  stretchStiffness: number;
  bendStiffness: number;
  damping: number;
  friction: number;
  selfCollision: boolean;
  fixedIndex: number[];
  draggableBody: boolean;
  positions: Vec3[];
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a SoftBodyAttachment; what is left out has its default. */
export interface SoftBodyAttachmentFields {
  /** The rope, the cloth or the soft body. (SFNode) */
  softBody?: NodeInput<'Rope' | 'Cloth' | 'SoftBody'> | null;
  /** Which of its points, counted from 0. Range [0, Infinity]. (SFInt32) Default 0. */
  index?: number;
  /** The body; NULL: the world. (SFNode) */
  body?: NodeInput<'RigidBody'> | null;
  /** Where on the body, metres, in its frame; without a body in the world. The point is taken there. (SFVec3f) Default 0 0 0. */
  position?: Numbers;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a SoftBodyAttachment answers. */
export interface SoftBodyAttachmentValues {
  softBody: NodeHandles['Rope'] | NodeHandles['Cloth'] | NodeHandles['SoftBody'] | null;
  index: number;
  body: NodeHandles['RigidBody'] | null;
  position: Vec3;
  metadata: unknown;
}

/** What may be said of a Cloth; what is left out has its default. */
export interface ClothFields {
  /** FALSE: it stands still, touches nothing and holds nothing. (SFBool) Default true. */
  enabled?: boolean;
  /** Its surface as it is laid: an IndexedTriangleSet, an IndexedFaceSet, or any other geometry by its triangles. (SFNode) */
  geometry?: Geometry | null;
  /** Width and height of a sheet around its origin in the x-y plane, as X3DOM’s Plane lies, metres; without it there is what geometry says. Range [0, Infinity]. (SFVec2f) Default 0 0. */
  size?: Numbers;
  /** How many cells such a sheet has along its width and its height: its points are counted from its lower left corner, row by row. Range [1, 200]. (SFVec2f) Default 16 16. */
  subdivision?: Numbers;
  /** kg, of all of it. Range (0, Infinity]. (SFFloat) Default 1. */
  mass?: number;
  /** How thick it is, metres; 0: it touches nothing. Range [0, Infinity]. (SFFloat) Default 0.01. */
  thickness?: number;
  /** Newtons for each metre of width that would stretch it to twice its length along its threads, if it went on as it begins; 0: it does not stretch. Range [0, Infinity]. (SFFloat) Default 0. */
  stretchStiffness?: number;
  /** The same for what makes its squares slanted, N/m. Range [0, Infinity]. (SFFloat) Default 10. */
  shearStiffness?: number;
  /** What it takes to bend a metre of width of it, N m; 0: it bends freely. More than a step follows is told (soft-too-stiff). Range [0, Infinity]. (SFFloat) Default 0. */
  bendStiffness?: number;
  /** Share of its speed that it loses, 1/s. Range [0, Infinity]. (SFFloat) Default 0. */
  damping?: number;
  /** Coulomb friction on what it touches. Range [0, Infinity]. (SFFloat) Default 0.5. */
  friction?: number;
  /** Points of its geometry that stay where they are, counted from 0. Range [0, Infinity]. (MFInt32) */
  fixedIndex?: Numbers;
  /** TRUE: its points do not come nearer to each other than it is thick. (SFBool) Default false. */
  selfCollision?: boolean;
  /** A thread that is stretched by more than this share of its length tears, and the triangles it borders with it; 0: none does. Range [0, Infinity]. (SFFloat) Default 0. */
  tearStrain?: number;
  /** Where the air goes and how fast, m/s, in the world; 0 0 0: there is none. (SFVec3f) Default 0 0 0. */
  wind?: Numbers;
  /** TRUE: people may drag it by mouse, touch, pen and keyboard, at any place of it, by a spring. Not authored: as its collection. (SFBool) Default false. */
  draggableBody?: boolean;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a Cloth answers. */
export interface ClothValues {
  enabled: boolean;
  geometry: Geometry | null;
  size: [number, number];
  subdivision: [number, number];
  mass: number;
  thickness: number;
  stretchStiffness: number;
  shearStiffness: number;
  bendStiffness: number;
  damping: number;
  friction: number;
  fixedIndex: number[];
  selfCollision: boolean;
  tearStrain: number;
  wind: Vec3;
  draggableBody: boolean;
  positions: Vec3[];
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a SoftBody; what is left out has its default. */
export interface SoftBodyFields {
  /** FALSE: it stands still, touches nothing and holds nothing. (SFBool) Default true. */
  enabled?: boolean;
  /** Its surface as it is laid: an IndexedTriangleSet, an IndexedFaceSet, or any other geometry by its triangles. (SFNode) */
  geometry?: Geometry | null;
  /** kg, of all of it. Range (0, Infinity]. (SFFloat) Default 1. */
  mass?: number;
  /** What it takes to stretch it, Pa: rubber has 1e6 and more, jelly 1e4. More than a step follows is told (soft-too-stiff). Range (0, Infinity]. (SFFloat) Default 10000. */
  youngsModulus?: number;
  /** How much thinner it gets where it is stretched: 0.5 would keep its volume. Range [0, 0.499]. (SFFloat) Default 0.3. */
  poissonsRatio?: number;
  /** Pa above that of the air, as it is laid: it is hollow then, a ball or a cushion. 0: it is solid. Range [0, Infinity]. (SFFloat) Default 0. */
  pressure?: number;
  /** How thick its skin is where it is hollow, metres; 0: as thick as its mass is of rubber, 1000 kg/m³. Range [0, Infinity]. (SFFloat) Default 0. */
  thickness?: number;
  /** Share of its speed that it loses, 1/s. Range [0, Infinity]. (SFFloat) Default 0. */
  damping?: number;
  /** Coulomb friction on what it touches. Range [0, Infinity]. (SFFloat) Default 0.5. */
  friction?: number;
  /** Points of its geometry that stay where they are, counted from 0. Range [0, Infinity]. (MFInt32) */
  fixedIndex?: Numbers;
  /** TRUE: people may drag it by mouse, touch, pen and keyboard, at any place of it, by a spring. Not authored: as its collection. (SFBool) Default false. */
  draggableBody?: boolean;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a SoftBody answers. */
export interface SoftBodyValues {
  enabled: boolean;
  geometry: Geometry | null;
  mass: number;
  youngsModulus: number;
  poissonsRatio: number;
  pressure: number;
  thickness: number;
  damping: number;
  friction: number;
  fixedIndex: number[];
  draggableBody: boolean;
  positions: Vec3[];
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of a WaterVolume; what is left out has its default. */
export interface WaterVolumeFields {
  /** FALSE: it is not there. (SFBool) Default true. */
  enabled?: boolean;
  /** Where its middle is, metres; in a page in the frame of the Transform that it stands in, or for. (SFVec3f) Default 0 0 0. */
  position?: Numbers;
  /** How it is turned: its surface looks along its y. (SFRotation) Default 0 0 1 0. */
  orientation?: Numbers;
  /** Its width, depth and length, metres; in a page, where nothing is said, those of the Box of the Shape beside it. Range [0, Infinity]. (SFVec3f) Default 10 2 10. */
  size?: Numbers;
  /** kg/m³: where volumes overlap there is what is denser. Range [0, Infinity]. (SFFloat) Default 1000. */
  density?: number;
  /** Quadratic drag: half of the density times this, the wetted cross-section and the square of the speed through the water, newtons. Range [0, Infinity]. (SFFloat) Default 1. */
  dragCoefficient?: number;
  /** Lift: what wetted faces that stand aslant are pushed aside by, as drag is reckoned. It takes no energy. Range [0, Infinity]. (SFFloat) Default 1. */
  liftCoefficient?: number;
  /** Linear drag, 1/s: of its speed through the water and of its spin what floats loses this share in a second; what is wetted by more or less than it weighs loses more or less. Range [0, Infinity]. (SFFloat) Default 1. */
  damping?: number;
  /** Share of the mass of the displaced water that has to be moved along with a body that moves freely: a ball in deep water has 0.5. Range [0, Infinity]. (SFFloat) Default 0. */
  addedMass?: number;
  /** Where the water goes and how fast, m/s, in its own frame: what floats goes along. (SFVec3f) Default 0 0 0. */
  flow?: Numbers;
  /** TRUE: its surface moves. What goes through it makes waves, and what floats rides on them. (SFBool) Default false. */
  waves?: boolean;
  /** Cells of a surface that moves along its width and its length: one number counts for both. More show shorter waves, and cost more. Other cells begin flat. Range [1, 256]. (MFInt32) Default 64 64. */
  subdivision?: Numbers;
  /** REFLECTING: waves come back from its sides, as in a pool. OPEN: they go on, as in a sea. (SFString) Default REFLECTING. */
  edges?: 'REFLECTING' | 'OPEN';
  /** Share of its speed that the water of a surface that moves loses in a second: waves lose half of that of their height. Range [0, Infinity]. (SFFloat) Default 0.2. */
  waveDamping?: number;
  /** Centre of the bounding box that the author states, metres. (SFVec3f) Default 0 0 0. */
  bboxCenter?: Numbers;
  /** Size of the bounding box that the author states, metres; -1 -1 -1 states none. (SFVec3f) Default -1 -1 -1. */
  bboxSize?: Numbers;
  /** Whether the bounding box is drawn. (SFBool) Default false. */
  bboxDisplay?: boolean;
  /** Whether it is drawn; it collides either way. (SFBool) Default true. */
  visible?: boolean;
  /** Data about the node, for programs that read them. (SFNode) */
  metadata?: unknown;
}

/** What a WaterVolume answers. */
export interface WaterVolumeValues {
  enabled: boolean;
  position: Vec3;
  orientation: Rotation;
  size: Vec3;
  density: number;
  dragCoefficient: number;
  liftCoefficient: number;
  damping: number;
  addedMass: number;
  flow: Vec3;
  waves: boolean;
  subdivision: number[];
  edges: 'REFLECTING' | 'OPEN';
  waveDamping: number;
  bboxCenter: Vec3;
  bboxSize: Vec3;
  bboxDisplay: boolean;
  visible: boolean;
  metadata: unknown;
}

/** What may be said of each type of node. */
export interface NodeFields {
  RigidBodyCollection: RigidBodyCollectionFields;
  RigidBody: RigidBodyFields;
  CollidableShape: CollidableShapeFields;
  CollidableOffset: CollidableOffsetFields;
  CollisionCollection: CollisionCollectionFields;
  CollisionSpace: CollisionSpaceFields;
  CollisionSensor: CollisionSensorFields;
  Contact: ContactFields;
  BallJoint: BallJointFields;
  SingleAxisHingeJoint: SingleAxisHingeJointFields;
  DoubleAxisHingeJoint: DoubleAxisHingeJointFields;
  SliderJoint: SliderJointFields;
  UniversalJoint: UniversalJointFields;
  MotorJoint: MotorJointFields;
  ParticleSystem: ParticleSystemFields;
  ConeEmitter: ConeEmitterFields;
  ExplosionEmitter: ExplosionEmitterFields;
  PointEmitter: PointEmitterFields;
  PolylineEmitter: PolylineEmitterFields;
  SurfaceEmitter: SurfaceEmitterFields;
  VolumeEmitter: VolumeEmitterFields;
  BoundedPhysicsModel: BoundedPhysicsModelFields;
  ForcePhysicsModel: ForcePhysicsModelFields;
  WindPhysicsModel: WindPhysicsModelFields;
  Rope: RopeFields;
  SoftBodyAttachment: SoftBodyAttachmentFields;
  Cloth: ClothFields;
  SoftBody: SoftBodyFields;
  WaterVolume: WaterVolumeFields;
}

/** What each type of node answers. */
export interface NodeValues {
  RigidBodyCollection: RigidBodyCollectionValues;
  RigidBody: RigidBodyValues;
  CollidableShape: CollidableShapeValues;
  CollidableOffset: CollidableOffsetValues;
  CollisionCollection: CollisionCollectionValues;
  CollisionSpace: CollisionSpaceValues;
  CollisionSensor: CollisionSensorValues;
  Contact: ContactValues;
  BallJoint: BallJointValues;
  SingleAxisHingeJoint: SingleAxisHingeJointValues;
  DoubleAxisHingeJoint: DoubleAxisHingeJointValues;
  SliderJoint: SliderJointValues;
  UniversalJoint: UniversalJointValues;
  MotorJoint: MotorJointValues;
  ParticleSystem: ParticleSystemValues;
  ConeEmitter: ConeEmitterValues;
  ExplosionEmitter: ExplosionEmitterValues;
  PointEmitter: PointEmitterValues;
  PolylineEmitter: PolylineEmitterValues;
  SurfaceEmitter: SurfaceEmitterValues;
  VolumeEmitter: VolumeEmitterValues;
  BoundedPhysicsModel: BoundedPhysicsModelValues;
  ForcePhysicsModel: ForcePhysicsModelValues;
  WindPhysicsModel: WindPhysicsModelValues;
  Rope: RopeValues;
  SoftBodyAttachment: SoftBodyAttachmentValues;
  Cloth: ClothValues;
  SoftBody: SoftBodyValues;
  WaterVolume: WaterVolumeValues;
}

/** X3D's names of the types. */
export type NodeName = keyof NodeFields;
