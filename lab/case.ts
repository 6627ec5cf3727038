// What the lab measures, in words that every engine can be told: X3D's own fields, SI units, radians.

export type Vec3 = [number, number, number];
/** x, y, z, w. */
export type Quaternion = [number, number, number, number];

export type Shape =
  | { type: 'Sphere'; radius: number }
  | { type: 'Box'; size: Vec3 }
  /** Along y. */
  | { type: 'Cylinder'; radius: number; height: number }
  | Triangles
  | Heights;

/** Points, flat, and three of them for each triangle, counterclockwise from outside. What moves has to be convex. */
export interface Triangles {
  type: 'IndexedTriangleSet';
  coord: number[];
  index: number[];
}

/** Heights over points in the level, rows along x one after the other along z, from a corner of the grid on. */
export interface Heights {
  type: 'ElevationGrid';
  xDimension: number;
  zDimension: number;
  xSpacing: number;
  zSpacing: number;
  height: number[];
}

/** A body: fields of X3D's RigidBody, a name, and one shape, about its centre of mass unless it says where. */
export interface CaseBody {
  name: string;
  /** Without one it touches nothing, and `inertia` has to be given. */
  shape?: Shape;
  /** Where the middle of the shape is from the centre of mass, in the body's frame. */
  offset?: Vec3;
  /** Of the centre of mass. */
  position?: Vec3;
  /** Axis and angle. */
  orientation?: [number, number, number, number];
  fixed?: boolean;
  /** Of a fixed body that its author moves: where it is after so many seconds, first at `position`. */
  path?: (time: number) => Vec3;
  /** And how it is turned then, axis and angle; first as `orientation` says. */
  turn?: (time: number) => [number, number, number, number];
  /** Kilograms, 1 by default. */
  mass?: number;
  /** Principal moments about the body's axes, kg m²; by default those of the shape, but for triangles. */
  inertia?: Vec3;
  linearVelocity?: Vec3;
  angularVelocity?: Vec3;
  useGlobalGravity?: boolean;
  autoDamp?: boolean;
  linearDampingFactor?: number;
  angularDampingFactor?: number;
  /** Newtons and newton metres, at every moment. */
  forces?: Vec3[];
  torques?: Vec3[];
  /** Newtons that page code gives it before each step, by where its centre of mass is then. */
  pull?: (at: Vec3) => Vec3;
}

/** A joint: fields of its X3D node; bodies by name. */
export interface CaseJoint {
  type:
    | 'BallJoint'
    | 'SingleAxisHingeJoint'
    | 'DoubleAxisHingeJoint'
    | 'SliderJoint'
    | 'UniversalJoint'
    | 'MotorJoint';
  body1: string;
  /** Without one: the world. */
  body2?: string;
  [field: string]: unknown;
}

export interface CaseScene {
  gravity: Vec3;
  bodies: CaseBody[];
  joints?: CaseJoint[];
  /** For every pair that touches; without it nothing collides. */
  contact?: { bounce: number; friction: number };
}

/** What a case may ask of a running scene, whichever engine runs it. In the world frame, at the time of the look. */
export interface Sight {
  /** Of the centre of mass. */
  position(body: string): Vec3;
  orientation(body: string): Quaternion;
  linearVelocity(body: string): Vec3;
  angularVelocity(body: string): Vec3;
}

/** Follows one run. */
export interface Watch {
  /** Called at time 0 and then every `every` seconds of the run. */
  look(time: number): void;
  /** The error so far, in the case's unit; NaN where what is measured never came about. */
  error(): number;
}

export interface Case {
  /** In lower case, parts apart by hyphens; cases of a family begin alike: `chain-1-20`. */
  id: string;
  name: string;
  /** One sentence: what is compared with what. */
  says: string;
  scene: CaseScene;
  /** Simulated seconds. */
  seconds: number;
  /** Seconds between two looks, 1/60 by default: all levels stop there. */
  every?: number;
  unit: string;
  /** How large the quantity itself is, in the unit: what an error is small or large against. */
  size: number;
  /** What single precision alone leaves of the quantity's error, in the unit. */
  singlePrecision: number;
  /** Seconds up to which neighbouring runs stay together, where the scene is chaotic. */
  horizon?: number;
  /** Why a level errs more than the level before it, where one does. */
  exception?: string;
  /** Why another engine comes nearer to the truth in the time of `standard`, where one does. */
  behind?: string;
  watch(sight: Sight): Watch;
}

/** Under this an error counts as none. */
export const floorOf = ({ size, singlePrecision }: Case): number =>
  Math.max(10 * singlePrecision, 1e-4 * size);
