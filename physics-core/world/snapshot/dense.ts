import { Chunk } from '../../base/chunk.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import type { Moment, NodeKind, NodeState } from './snapshot.js';

/** The nodes of a world. */
export interface NodesWorld {
  readonly nodes: Iterable<PhysicsNode>;
}

/** Writes snapshots in a fraction of their room: it comes with the first one, which is written without it. */
export interface DenseCode {
  kindsOf(world: NodesWorld): NodeKind[];
  statesIn(kinds: readonly NodeKind[]): NodeState[];
  /** `dt`: seconds of the step before, by which it is the shorter. */
  pack(moment: Moment, dt: number): string;
  /** Throws where it is none. */
  unpack(text: string): Moment;
}

export const dense = new Chunk<DenseCode>({ name: 'snapshots', causes: 'world.snapshot' });
