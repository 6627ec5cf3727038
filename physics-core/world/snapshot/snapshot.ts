import type { Pose } from '../../base/math.js';
import type { Load } from '../../dynamics/body.js';
import type { Vec3 } from '../../fields/types.js';
import type { LevelName } from '../../dynamics/levels.js';
import type { Field } from '../../nodes/node/table.js';
import type { RestState } from '../../effects/rest/resting.js';

/** What a node stands for in a snapshot: its id. */
export interface Reference {
  nodeId: number;
}

/** What Bullet and the effects know of a body. */
export interface BodyState {
  pose: Pose;
  /** Of the centre of mass, linear then angular. */
  velocity: number[];
  asleep: boolean;
  parked: boolean;
  rest: RestState;
  /** Seconds of its last step, to the middle of which joints keep its velocity; 0: to the moment. */
  lastStep: number;
  /** What `applyForce` and `applyTorque` asked of the next step. */
  load: Load | undefined;
}

export interface NodeState {
  id: number;
  type: string;
  /** What a node is born with, for those that are made again elsewhere. */
  name: string | undefined;
  version: number;
  collection: number | undefined;
  start?: Pose | undefined;
  /** Events of it that somebody listens to: they switch effects on. */
  heard: string[];
  /** Made from plain data in a field of another. */
  child: boolean;
  asked: [string, unknown][];
  authored: string[];
  beforeEvent: [string, unknown][];
  body?: BodyState;
  /** Where the joint is at zero. */
  joint?: { frame1: Pose; frame2: Pose };
}

/** A world at one moment as plain data. */
export interface Snapshot {
  x3dPhysics: 1;
  time: number;
  sinceLook: number;
  /** The level in force. */
  level: LevelName;
  nodes: NodeState[];
  /** Where Bullet counted from. */
  origin?: Vec3;
}

/** What the simulation makes nothing of, whatever it may be, stays where it is. */
export const isKept = ({ common, type, nodes }: Field): boolean =>
  common === true || (/^[SM]FNode$/.test(type) && !nodes);

/** Most values are numbers, which need none. */
export const cloned = <T>(value: T): T =>
  typeof value === 'object' ? structuredClone(value) : value;
