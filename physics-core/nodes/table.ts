import type { Access, Dimension, FieldType, Value } from '../fields/types.js';
import type { PhysicsNode } from './node.js';

/**
 * One field of one node. Everything that knows a field reads it here: parsing, properties, observed attributes,
 * x3dom's declarations, the manifest, the docs and the tests.
 */
export interface Field<N extends PhysicsNode = never> {
  type: FieldType;
  access: Access;
  default: Value;
  /** Closed at finite ends. Both ends finite: out of range clamps; else the last valid value stays. */
  range?: readonly [number, number];
  /** The lower end of `range` itself is not allowed (mass must be above zero). */
  open?: boolean;
  /** The values a string may take. */
  values?: readonly string[];
  dimension?: Dimension;
  /** The node types that an SFNode or MFNode takes. */
  nodes?: readonly string[];
  /** An addition of ours, not an X3D field: its attribute is the kebab-case of its name. */
  own?: true;
  /**
   * `live`: `patch` writes the new value into the running Bullet object. `rebuild`: this one object is made again.
   * `passive`: nothing in Bullet stands for it; `doc` says who reads it.
   */
  edit: 'live' | 'rebuild' | 'passive';
  patch?: (node: N) => void;
  /** Of a RigidBodyCollection: one value for all collections that share a world. */
  worldWide?: true;
  /** The simulation leaves it out so far; an author who writes it is told. */
  unsimulated?: true;
  /** Reads the live value; without it a field reads as it was last asked for. */
  read?: (node: N) => Value;
  /** One sentence for people: meaning, unit, clause where it surprises. */
  doc: string;
}

export interface NodeType<N extends PhysicsNode = never> {
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
  make: (context: MakeContext) => N;
}

/** What a node is born with. Opaque here so that the tables don't depend on the world. */
export type MakeContext = ConstructorParameters<typeof PhysicsNode>[0];

/** Lets a table name its node class once; the registry holds all types under one signature. */
export function defineNode<N extends PhysicsNode>(type: NodeType<N>): NodeType {
  return type as unknown as NodeType;
}
