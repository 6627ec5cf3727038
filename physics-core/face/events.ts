import type { Problem } from '../base/problems.js';
import type { LevelName } from '../dynamics/levels.js';
import type { Vec3 } from '../fields/types.js';
import type { Node, NodeOf } from './nodes.js';
import type { World } from './world.js';

/** One point where two bodies touch. */
export interface TouchPoint {
  /** World frame, metres. */
  position: Vec3;
  /** Unit vector, world frame; it points into the body whose event it is. */
  normal: Vec3;
  /** Overlap, metres; negative is a gap. */
  depth: number;
  /** N s. */
  impulse: number;
}

/** Detail of `collisionstart`. */
export interface CollisionStart {
  /** The other body; the collidable where that has none. */
  other: Node;
  /** What they passed on to each other from the first push of the hit on, N s. */
  impulse: number;
  contacts: TouchPoint[];
  /** Of the world, seconds. */
  time: number;
}

/** Detail of `collisionend`; exactly one for each start. */
export interface CollisionEnd extends CollisionStart {
  /** They came apart, one was removed or disabled, or the world was reset or restored. */
  reason: 'separated' | 'removed' | 'disabled' | 'reset';
}

/** When something happened: of the world, seconds. */
export interface Moment {
  time: number;
}

/** Detail of `beforestep` and `afterstep`. */
export interface StepEvent extends Moment {
  /** Seconds that the step takes. */
  timeStep: number;
}

/** Detail of `lag`. */
export interface LagEvent extends Moment {
  /** Seconds of the clock that were left out, since the machine could not keep up. */
  dropped: number;
}

/** Detail of `accuracy`. */
export interface AccuracyEvent {
  level: LevelName;
  from: LevelName;
  /** `asked`; of accuracy auto `over budget` or `room for more`. */
  because: string;
  /** Milliseconds that nine in ten frames stayed below, where those decided. */
  p90?: number;
}

/** Detail of `jointlimit`. */
export interface JointLimitEvent extends Moment {
  limit: 'min' | 'max';
  /** The limit that was reached, radians or metres. */
  value: number;
  /** Which one, of a joint with two axes. */
  axis?: number;
}

/** What `world.on` hears. */
export interface WorldEvents {
  /** It has started. */
  ready: World;
  /** An author should know of something; see `world.problems`. */
  problem: Problem;
  lag: LagEvent;
  /** Another level is in force. */
  accuracy: AccuracyEvent;
  /** A step begins: edits, forces and teleports made here act in it. */
  beforestep: StepEvent;
  /** A step is over; what it brought about has been told. */
  afterstep: StepEvent;
  /** `world.reset()` is over. */
  reset: World;
  /** `world.restore()` is over. */
  restore: World;
}

/** What a collidable without a body hears; with one the body hears it. */
export interface CollidableEvents {
  collisionstart: CollisionStart;
  collisionend: CollisionEnd;
}

/** Detail of `waterenter` and `waterleave`. */
export interface WaterEvent extends Moment {
  /** Into which, or out of which; where several overlap, that in which it is deepest. */
  water: NodeOf<'WaterVolume'>;
  /** How far its lowest point is below the surface, metres. */
  depth: number;
  /** How fast it goes down, m/s; negative is up. */
  speed: number;
}

/** What may be in water hears; ropes, cloths and soft bodies nothing else. */
export interface SwimmerEvents {
  /** It has come into water. */
  waterenter: WaterEvent;
  /** It is in water no more. */
  waterleave: WaterEvent;
}

/** What `body.on` hears. */
export interface BodyEvents extends CollidableEvents, SwimmerEvents {
  /** It has come to rest, and is simulated no longer. */
  sleep: Moment;
  /** It moves again. */
  wake: Moment;
}

/** What `joint.on` hears. */
export interface JointEvents {
  /** It has reached one of its stops. */
  jointlimit: JointLimitEvent;
}

/** What `sensor.on` hears: its outputs (ISO/IEC 19775-1, 37.4.5), the lists in each step in which something touches. */
export interface SensorEvents {
  isActive: boolean;
  intersections: Node[];
  contacts: NodeOf<'Contact'>[];
}
