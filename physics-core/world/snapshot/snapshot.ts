import type { Pose } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { LevelName } from '../../dynamics/levels.js';
import type { JointRowsState, JointZero } from '../../nodes/joints/placed-joint.js';
import type { Field } from '../../nodes/node/table.js';

/** What a node stands for in a snapshot: its id. */
export interface Reference {
  nodeId: number;
}

export const isReference = (value: unknown): value is Reference =>
  typeof value === 'object' && value !== null && 'nodeId' in value;

/** Bodies that stand in Bullet, and where they touch. */
export interface Moment {
  /** By their ids. */
  ids: number[];
  /** Of each: `AWAKE`, and the list of Bullet's broadphase that it stands in. */
  flags: Uint8Array;
  /** To the bit, and the boxes of those that move in Bullet's broadphase. */
  states: Float32Array;
  boxes: Float32Array;
  /** Where those are that Bullet has at a place rounded, or nowhere, seen from its origin. */
  placed: number[];
  poses: Float64Array;
  /** Points in touch, as `saveContacts` has them. */
  contacts: Int32Array;
  /** The list of Bullet's broadphase that the next step fills. */
  list: number;
}

/** As it is kept: arrays as text, see `base/packed.ts`. */
export type KeptMoment = {
  [Name in keyof Moment]: Moment[Name] extends ArrayBufferView ? string : Moment[Name];
};

export const AWAKE = 0;
export const ASLEEP = 1;
export const PARKED = 2;

/** Bits of a flag for how a body is; above them lies the list that it stands in, 3 for none. */
export const HOW = 4;
export const NO_LIST = 3;

/** What is known of a joint. */
export interface JointState extends JointZero {
  /** What its rows are, which was looked at where the bodies were then. */
  rows: JointRowsState;
}

export interface NodeState {
  id: number;
  type: string;
  /** What a node is born with, for those that are made again elsewhere. */
  name?: string;
  version: number;
  collection?: number;
  start?: Pose;
  /** Made from plain data in a field of another. */
  child?: boolean;
  asked: [string, unknown][];
  /** The fields that the author wrote; undefined: all that are asked. */
  authored?: string[];
  beforeEvent?: [string, unknown][];
}

/**
 * Values of a field, one of each node, as plain data: one that is that of all; the parts of lists as long as each other and
 * of plain data by themselves; the few numbers there are and which each has; numbers packed; or each as it is.
 */
export type Column =
  | string
  | { all: unknown }
  | { parts: Column[] }
  | { named: Record<string, Column> }
  | { few: number[]; which: string }
  | { each: unknown[] };

/** Nodes of one type of which the same fields are asked. */
export interface NodeKind {
  type: string;
  version: number;
  collection?: number;
  /** Made from plain data in fields of others. */
  child?: boolean;
  /** The fields that the author wrote; undefined: all that are asked. */
  authored?: string[];
  /** In runs. */
  ids: number[];
  /** What they are born with, for those that are made again elsewhere. */
  names: Column;
  starts?: Column;
  asked: Record<string, Column>;
  beforeEvent?: Record<string, Column>;
}

/** What a snapshot is written in. */
export const FORMAT = 5;

/** A world at one moment as plain data. */
export interface Snapshot {
  x3dPhysics: typeof FORMAT;
  time: number;
  /** Steps of Bullet before. */
  taken: number;
  /** The level in force, and into how many parts its steps are split. */
  level: LevelName;
  parts: number;
  /** One after the other, or those alike together: see `dense.ts`. */
  nodes: NodeState[] | NodeKind[];
  /** Events that somebody listens to, by nodes: they switch effects on. */
  heard: [id: number, events: string[]][];
  joints: [id: number, state: JointState][];
  bodies: KeptMoment | string;
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
