import type { Chunk } from '../../base/chunk.js';
import type { Access, Dimension, FieldType, Value } from '../../fields/types.js';

/**
 * One field of one node. Everything that knows a field reads it here: parsing, properties, observed attributes,
 * x3dom's declarations, the manifest, the docs and the tests.
 */
export interface Field<N = unknown> {
  type: FieldType;
  access: Access;
  default: Value;
  /** The default in X3D 3.x, where that was another. */
  default3?: Value;
  /** Other spellings, of X3D 3.x: what is set or read by them is this field. */
  aliases?: readonly string[];
  /** Closed at finite ends. Both ends finite: out of range clamps; else the last valid value stays. */
  range?: readonly [number, number];
  /** The lower end of `range` itself is not allowed (mass must be above zero). */
  open?: boolean;
  /** Greatest magnitude of its numbers, where it is not that of its dimension (fields/bounds.ts). */
  most?: number;
  /** Least number above 0. */
  least?: number;
  /** The values a string may take. */
  values?: readonly string[];
  dimension?: Dimension;
  /** The node types that an SFNode or MFNode takes. */
  nodes?: readonly string[];
  /** An MFNode that also takes `*`: all there are in its world. */
  takesAll?: true;
  /** Not written, it counts for something else than its default. */
  implied?: true;
  /** Of every node, or of every X3DBoundedObject. */
  common?: true;
  /** An addition of ours, not an X3D field: its attribute is the kebab-case of its name. */
  own?: true;
  /**
   * `live`: `patch` writes the new value into the running Bullet object. `rebuild`: this one object is made again.
   * `passive`: nothing in Bullet stands for it; `doc` says who reads it.
   */
  edit: 'live' | 'rebuild' | 'passive';
  patch?(node: N): void;
  /** Of a RigidBodyCollection: one value for all collections that share a world. */
  worldWide?: true;
  /** Reads the live value; without it a field reads as it was last asked for. */
  read?(node: N): Value;
  /** What brings a live value to the one last asked for, which to set again is no edit; undefined: nothing does. */
  instead?(node: N): string | undefined;
  /** One sentence for people: meaning, unit, clause where it surprises. */
  doc: string;
}

/** What tells people of a field, by itself: builds for pages leave it out. */
export type Doc = Pick<Field, 'doc'>;

export interface NodeType<N = unknown> {
  /** X3D node name. */
  name: string;
  /** X3D's default containerField. */
  containerField: string;
  /** Clause of ISO/IEC 19775-1:2023. */
  clause: string;
  doc: string;
  /** Creation order: collections, collidables, bodies, joints, collision collections, sensors. */
  rank: number;
  fields: Record<string, Field<N>>;
  /** An X3DBoundedObject. */
  bounded?: true;
  /** Code of effects that its nodes are not made without. */
  chunk?: Chunk<unknown>;
  /** Code that one with such values needs beside that. */
  needs?(node: N): readonly (Chunk<unknown> | undefined)[];
}

/** What words of authors are looked up in: `constructor` is in it only where somebody put it. */
export const byName = <T>(entries: Record<string, T>): Record<string, T> =>
  Object.assign(Object.create(null), entries);

/** A field's default in a file of an X3D version. */
export const defaultOf = (field: Field, version: number): Value =>
  version < 4 && field.default3 !== undefined ? field.default3 : field.default;

/** A field's own name, from any of its spellings. */
export function fieldName({ fields }: NodeType, spelling: string): string {
  if (fields[spelling]) return spelling;
  const named = ([, field]: [string, Field]) => field.aliases?.includes(spelling);
  return Object.entries(fields).find(named)?.[0] ?? spelling;
}
