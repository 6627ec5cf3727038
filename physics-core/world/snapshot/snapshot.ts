import type { Pose } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { LevelName } from '../../dynamics/levels.js';
import type { JointRowsState, JointZero } from '../../nodes/joints/placed-joint.js';
import type { Field } from '../../nodes/node/table.js';

/** What a node stands for in a snapshot: its id. */
export interface Reference {
  nodeId: number;
}

/** Bodies that stand in Bullet, by their ids. Numbers are packed: see `base/packed.ts`. */
export interface BodyStates {
  ids: number[];
  /** Of each: `AWAKE`, and the list of Bullet's broadphase that it stands in. */
  flags: string;
  /** To the bit, and the boxes of those that move in Bullet's broadphase. */
  states: string;
  boxes: string;
  /** Where those are that Bullet has at a place rounded, or nowhere, seen from its origin. */
  placed: number[];
  poses: string;
  /** The list of Bullet's broadphase that the next step fills. */
  list: number;
}

export const AWAKE = 0;
export const ASLEEP = 1;
export const PARKED = 2;

/** What is known of a joint. */
export interface JointState extends JointZero {
  /** What its rows are, which was looked at where the bodies were then. */
  rows: JointRowsState;
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
  heard?: string[];
  /** Made from plain data in a field of another. */
  child?: boolean;
  asked: [string, unknown][];
  /** The fields that the author wrote; undefined: all that are asked. */
  authored?: string[];
  beforeEvent?: [string, unknown][];
  joint?: JointState;
}

/** What a snapshot is written in. */
export const FORMAT = 2;

/** A world at one moment as plain data. */
export interface Snapshot {
  x3dPhysics: typeof FORMAT;
  time: number;
  /** Steps of Bullet before. */
  taken: number;
  /** The level in force, and into how many parts its steps are split. */
  level: LevelName;
  parts: number;
  nodes: NodeState[];
  bodies: BodyStates;
  /** Points in touch, packed. */
  contacts: string;
  /** What effects know of the steps before, by their names. */
  effects: Record<string, unknown>;
  /** How much all of that is. */
  extent: number;
  /** Where Bullet counted from. */
  origin?: Vec3;
}

export const authoredIn = ({ asked, authored }: NodeState): readonly string[] =>
  authored ?? asked.map(([name]) => name);

/** What the simulation makes nothing of, whatever it may be, stays where it is. */
export const isKept = ({ common, type, nodes }: Field): boolean =>
  common === true || (/^[SM]FNode$/.test(type) && !nodes);

/** What stays of what was asked: not what was only sent in. */
export const isLasting = (field: Field): boolean => !isKept(field) && field.access !== 'inputOnly';

/** Most values are numbers, which need none. */
export function cloned<T>(value: T): T {
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.map(cloned) as T;
  if (Object.getPrototypeOf(value) !== Object.prototype) return structuredClone(value);
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, cloned(one)])) as T;
}
