import type { DragMode } from '../dynamics/body.js';
import type { DragEnd } from '../effects/drag/hold.js';
import type { Vec3 } from '../fields/types.js';
import type { Geometry } from '../shapes/geometry.js';
import type {
  BodyEvents,
  CollidableEvents,
  JointEvents,
  SensorEvents,
  SwimmerEvents,
} from './events.js';
import type { NodeFields, NodeName, NodeValues } from './fields.js';
import type { World } from './world.js';

/** Three numbers; of an orientation four: an axis, of any length, and an angle in radians. */
export type Vector = ArrayLike<number>;

/** A node of a world, of whatever type. */
export interface Node {
  /** Its number in its world. */
  readonly id: number;
  /** Its DEF or id. */
  readonly name: string | undefined;
  readonly type: {
    /** X3D's name of its type, as `RigidBody`. */
    readonly name: string;
  };
  readonly world: World;
  /** Whether it has left its world. */
  readonly removed: boolean;

  /** A field: live where the simulation changes it, else what was last asked for. A fresh copy, in SI units. */
  get(field: string): unknown;

  /**
   * Asks for a value of a field, in SI units. Equal to the one last asked for it is no edit, even where the live value has
   * moved on. What can't be used is reported in `world.problems`, and the last valid value stays; nothing throws.
   */
  set(field: string, value: unknown): void;

  /** X3D's default again. */
  unset(field: string): void;

  /** Calls the listener with each event's detail until the function that is returned is called. */
  on(event: string, listener: (detail: unknown) => void): () => void;

  /** Takes it out of its world for good. */
  remove(): void;
}

interface EventsOf {
  RigidBody: BodyEvents;
  Rope: SwimmerEvents;
  Cloth: SwimmerEvents;
  SoftBody: SwimmerEvents;
  CollidableShape: CollidableEvents;
  CollidableOffset: CollidableEvents;
  CollisionSensor: SensorEvents;
  SingleAxisHingeJoint: JointEvents;
  DoubleAxisHingeJoint: JointEvents;
  SliderJoint: JointEvents;
}

/** The events of one type of node, and their details. */
export type NodeEvents<Name extends NodeName> = Name extends keyof EventsOf
  ? EventsOf[Name]
  : Record<never, never>;

/** A node of one type, with its own fields and events. */
export interface NodeOf<Name extends NodeName> extends Node {
  get<Field extends keyof NodeValues[Name] & string>(field: Field): NodeValues[Name][Field];
  set<Field extends keyof NodeFields[Name] & string>(
    field: Field,
    value: NodeFields[Name][Field],
  ): void;
  unset(field: keyof NodeFields[Name] & string): void;
  on<Event extends keyof NodeEvents<Name> & string>(
    event: Event,
    listener: (detail: NodeEvents<Name>[Event]) => void,
  ): () => void;
}

/** Velocities, world frame. */
export interface Velocities {
  /** Of the body's origin, m/s. */
  linearVelocity?: Vector;
  /** rad/s. */
  angularVelocity?: Vector;
}

/**
 * A RigidBody (ISO/IEC 19775-1, 37.4.11). Arguments are in SI units and the world's frame. What is no list of finite
 * numbers is reported as `bad-value`, and nothing is done; nothing throws.
 */
export interface Body extends NodeOf<'RigidBody'> {
  /** Newtons, for the next timeStep only, at a point of the world; at the centre of mass where that is left out. */
  applyForce(force: Vector, at?: Vector): void;

  /** Newton metres, for the next timeStep only. */
  applyTorque(torque: Vector): void;

  /** Newton seconds, at once, at a point of the world; at the centre of mass where that is left out. */
  applyImpulse(impulse: Vector, at?: Vector): void;

  /**
   * Jumps there: metres, axis and angle. What is left out stays as it is: its orientation, and each of its velocities. No
   * edit of the fields: `position` set to what it was last set to before does nothing after it, either.
   */
  teleport(position: Vector, orientation?: Vector, velocities?: Velocities): void;

  /**
   * Takes hold of it at a point of the world, as its field `dragMode` says. Undefined where it can't be held: not simulated,
   * fixed and held by a spring, or held by another mode.
   */
  drag(point: Vector, onend?: (reason: DragEnd) => void): Drag | undefined;

  /** And all that it fell asleep together with. */
  wake(): void;

  /** Puts it to sleep until something wakes it. */
  sleep(): void;

  readonly sleeping: boolean;

  /** Position (3, metres) and quaternion (4, x y z w) of the last finished step into `out`, without allocating. */
  readPose<Out extends Float32Array | Float64Array | number[]>(out: Out): Out;
}

/** A rope, a cloth or a soft body. */
export interface Soft {
  /**
   * Takes hold of it, by a spring, at its place nearest to a point of the world. Undefined where it can't be held: it is not
   * simulated, or all of it stays where it is.
   */
  drag(point: Vector, onend?: (reason: DragEnd) => void): Drag | undefined;
}

/** What is held at a point, from `drag` on until it is let go. */
export interface Drag {
  readonly mode: DragMode;
  /** Whether it is held still: others may have ended it. */
  readonly held: boolean;
  /** Where the grabbed point is: world frame, metres. */
  readonly point: Vec3;
  /** The grabbed point is to be here: world frame, metres. */
  move(point: Vector): void;
  /** Lets go: it flies on as it was moved. */
  end(): void;
  /** Lets go, and puts back what no spring has moved. */
  cancel(): void;
}

/** What `add` gives for each type. */
export type NodeHandles = {
  [Name in NodeName]: Name extends 'RigidBody'
    ? Body
    : Name extends 'Rope' | 'Cloth' | 'SoftBody'
      ? NodeOf<Name> & Soft
      : NodeOf<Name>;
};

/** A node that `add` gave, or the fields of one that is made for this place and goes with it. */
export type NodeInput<Name extends NodeName> = {
  [Each in Name]: NodeOf<Each> | ({ type: Each } & NodeFields[Each]);
}[Name];

/** What a body is made of: bare geometry does for a CollidableShape. */
export type CollidableInput = NodeInput<'CollidableShape' | 'CollidableOffset'> | Geometry;
